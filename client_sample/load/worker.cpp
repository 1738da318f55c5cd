#include "worker.h"

#include <algorithm>

#include <asio/post.hpp>

#include "builder.h"
#include "player.h"
#include "requester.h"

namespace talus::load {
namespace {

constexpr std::size_t kScratchBytes = std::size_t{256} * 1024;
constexpr std::chrono::milliseconds kPollInterval{20};

/// Building material: the last solid one, so a placeable rather than a generated one if possible.
MaterialId building_material(const client::WorldInfo& world) {
  MaterialId material{1};
  for (const client::Material& each : world.materials) {
    if (each.phase == client::Phase::solid) material = each.id;
  }
  return material;
}

}  // namespace

Worker::Worker(const Plan& plan, std::uint32_t number)
    : plan_{plan},
      guard_{io_.get_executor()},
      timer_{io_},
      end_timer_{io_},
      scratch_(kScratchBytes),
      random_{plan.options.seed, 0xF00D + number} {}

Worker::~Worker() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
}

std::unique_ptr<SimulatedClient> Worker::make_client(const ClientProfile& profile) {
  switch (profile.role) {
    case Role::idle:
      return std::make_unique<SimulatedClient>(*this, profile);
    case Role::greedy:
    case Role::requests:
      return std::make_unique<Requester>(*this, profile);
    case Role::build: {
      auto& site = sites_[profile.group];
      if (site == nullptr) {
        site = std::make_shared<EditSite>(plan_.origins[profile.group], plan_.options.edit_group,
                                          building_material(plan_.world));
      }
      return std::make_unique<Builder>(*this, profile, site);
    }
    default:
      return std::make_unique<Player>(*this, profile);
  }
}

void Worker::add(const ClientProfile& profile) {
  clients_.push_back(make_client(profile));
}

void Worker::run() {
  thread_ = std::thread{[this] { io_.run(); }};
}

void Worker::join() {
  thread_.join();
}

void Worker::begin(bool idle, Time from, Time measure_from) {
  asio::post(io_, [this, idle, from, measure_from] {
    measure_from_ = measure_from;
    for (const auto& client : clients_) {
      if ((client->role() == Role::idle) == idle) client->start(from);
    }
  });
}

void Worker::finish(Time deadline) {
  // At once: a worker that is behind may execute overdue steps for minutes before it reaches posted work.
  finishing_ = true;
  asio::post(io_, [this, deadline] {
    for (const auto& client : clients_) client->finish();
    end_if_satisfied(deadline);
  });
}

void Worker::end_if_satisfied(Time deadline) {
  const auto satisfied = [](const auto& client) { return client->satisfied(); };
  if (Clock::now() < deadline && !std::all_of(clients_.begin(), clients_.end(), satisfied)) {
    end_timer_.expires_after(kPollInterval);
    end_timer_.async_wait([this, deadline](std::error_code) { end_if_satisfied(deadline); });
    return;
  }
  for (const auto& client : clients_) client->leave();
  io_.stop();
}

bool Worker::picks_to_verify() {
  const double percent = plan_.options.verify_percent;
  return percent > 0 && random_.part() * 100 < percent;
}

void Worker::reschedule(SimulatedClient& client) {
  const Time due = client.due();
  if (due == client.scheduled || due == Time::max()) return;
  client.scheduled = due;
  entries_.push({due, &client});
  wake_at(due);
}

void Worker::wake_at(Time due) {
  if (due >= timer_due_) return;
  timer_due_ = due;
  timer_.expires_at(due);
  timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) act();
  });
}

void Worker::act() {
  timer_due_ = Time::max();
  // Polls the sockets between batches, so that many due clients do not delay answers.
  constexpr int kBatch = 64;
  for (int done = 0; done < kBatch && !entries_.empty(); ++done) {
    const Entry entry = entries_.top();
    const Time now = Clock::now();
    if (entry.due > now) break;
    entries_.pop();
    if (entry.client->scheduled != entry.due) continue;
    entry.client->scheduled = Time::max();
    lateness_.record(now - entry.due);
    entry.client->act(now);
    reschedule(*entry.client);
  }
  if (!entries_.empty()) wake_at(entries_.top().due);
}

}  // namespace talus::load
