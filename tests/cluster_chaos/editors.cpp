// Editors of a cluster who know of each edit what it must do (plot.h), and go to another server when theirs
// breaks off. Lines on stdin say what they do, lines of JSON on stdout what became of it:
//
//   go                  they edit
//   pause               they begin no edit; "paused" comes when all are answered
//   figures             "figures": what there was so far, and the longest pause since the figures before
//   verify HOST:PORT    "verified": every voxel as that server has it against what was acknowledged
//
// "lost" comes for each connection that broke. They end with stdin.
#include <chrono>
#include <deque>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <nlohmann/json.hpp>

#include <talus/client/client.h>

#include "measure/histogram.h"
#include "plot.h"

namespace {

using namespace talus;
using namespace talus::chaos;
using namespace std::chrono_literals;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t kBetweenPlots = 20;  // so that many lie in several chunks
constexpr std::size_t kPlotsInRow = 24;
constexpr auto kTick = 2ms;

struct Settings {
  std::vector<client::ServerAddress> servers;
  std::size_t editors = 8;
  std::size_t lanes = 8;
  double rate = 0;
  bool alone = false;
  std::int64_t place = 0;
  std::uint64_t seed = 1;
};

void tell(const json& line) {
  std::cout << line.dump() << std::endl;
}

double ms_of(Clock::duration time) {
  return std::chrono::duration<double, std::milli>{time}.count();
}

client::ServerAddress address_of(const std::string& text) {
  const auto colon = text.rfind(':');
  return {text.substr(0, colon), text.substr(colon + 1)};
}

/// A server that stands still, or that a cut has made silent, is given up soon.
client::Options impatient() {
  client::Options options;
  options.client_name = "talus-chaos";
  options.connect_timeout = 2s;
  options.handshake_timeout = 2s;
  options.ping_interval = 2s;
  options.silence_timeout = 6s;
  options.reconnect.max_attempts = 1'000'000;
  options.reconnect.first_delay = 20ms;
  options.reconnect.max_delay = 500ms;
  return options;
}

struct Totals {
  std::uint64_t done = 0;       // edits that were answered, those that conflict too
  std::uint64_t revisions = 0;  // of them, that changed something
  std::uint64_t conflicts = 0;  // as they had to
  std::uint64_t mistakes = 0;   // answers other than they had to be
  std::uint64_t unknown = 0;    // nobody can say whether they happened
  std::uint64_t connections_lost = 0;
  std::string first_mistake;
  measure::Histogram waits;
  Clock::time_point last_answer = Clock::now();
  Clock::duration longest_pause{};  // since it was asked last
};

/// One edit after the other.
struct Lane {
  Lane(VoxelPos corner, std::vector<MaterialId> palette, std::uint64_t seed)
      : plot{corner, std::move(palette), seed} {}
  Plot plot;
  Plot::Step step;
  Clock::time_point since;
  bool open = false;
  bool certain = true;
  std::uint64_t revision = 0;
};

/// A client and its lanes.
struct Editor {
  std::unique_ptr<client::Client> client;
  std::vector<std::unique_ptr<Lane>> lanes;
  std::uint64_t done = 0;
};

class Editors {
 public:
  Editors(asio::io_context& io, Settings settings) : io_{io}, settings_{std::move(settings)}, ticks_{io} {
    editors_.resize(settings_.editors);
    for (std::size_t i = 0; i < editors_.size(); ++i) {
      client::Options options = impatient();
      const auto& servers = settings_.servers;
      if (!settings_.alone)
        for (std::size_t n = 1; n < servers.size(); ++n)
          options.more_servers.push_back(servers[(i + n) % servers.size()]);
      client::Events events;
      events.on_disconnect = [this, i](const client::ClientError& error, bool retrying) {
        lost(i, error, retrying);
      };
      editors_[i].client = std::make_unique<client::Client>(io_.get_executor(), options, events);
      connect(i);
    }
    tick();
  }

  void go() {
    edits_ = true;
    totals_.last_answer = Clock::now();
  }
  void pause() {
    edits_ = false;
    pausing_ = true;
    tell_when_paused();
  }
  void figures(const char* event) {
    json line{{"event", event},
              {"done", totals_.done},
              {"revisions", totals_.revisions},
              {"conflicts", totals_.conflicts},
              {"mistakes", totals_.mistakes},
              {"first_mistake", totals_.first_mistake},
              {"unknown", totals_.unknown},
              {"connections_lost", totals_.connections_lost},
              {"open", open_},
              {"p50_ms", totals_.waits.percentile_ms(0.5)},
              {"p99_ms", totals_.waits.percentile_ms(0.99)},
              {"max_ms", totals_.waits.max_ms()}};
    if (open_ > 0) note_pause(Clock::now());
    line["longest_pause_ms"] = ms_of(std::exchange(totals_.longest_pause, {}));
    tell(line);
  }
  void verify(const std::string& server);

 private:
  struct Check {
    std::unique_ptr<client::Client> client;
    std::string server;
    std::map<ChunkCoord, std::shared_ptr<const Chunk>> chunks;
    std::size_t wanted = 0;
    std::string failed;
  };

  [[nodiscard]] VoxelPos corner_of(const client::WorldInfo& world, std::size_t plot) const {
    const auto column = static_cast<std::int64_t>(plot % kPlotsInRow);
    const auto row = static_cast<std::int64_t>(plot / kPlotsInRow);
    // Above all hills, so that what is there is known without asking.
    return {world.spawn.x + settings_.place * 1'000 + column * kBetweenPlots, world.max_y + 8,
            world.spawn.z + row * kBetweenPlots};
  }
  void connect(std::size_t i);
  void joined(std::size_t i, const client::WorldInfo& world);
  void lost(std::size_t i, const client::ClientError& error, bool retrying);
  void tick();
  void begin(std::size_t i, Lane& lane);
  void answered(std::size_t i, Lane& lane, const client::Result<client::EditDone>& result);
  void mistake(const Lane& lane, const std::string& what);
  void tell_when_paused() {
    if (!pausing_ || open_ > 0) return;
    pausing_ = false;
    figures("paused");
  }
  void note_pause(Clock::time_point now) {
    totals_.longest_pause = std::max(totals_.longest_pause, now - totals_.last_answer);
  }
  void fetch(const std::shared_ptr<Check>& check);
  void compare(const Check& check);

  asio::io_context& io_;
  const Settings settings_;
  asio::steady_timer ticks_;
  std::vector<Editor> editors_;
  std::size_t joined_ = 0;
  std::deque<std::pair<std::size_t, Lane*>> idle_;
  std::size_t open_ = 0;
  double credit_ = 0;  // edits that may begin
  Clock::time_point last_tick_ = Clock::now();
  bool edits_ = false;
  bool pausing_ = false;
  Totals totals_;
};

void Editors::connect(std::size_t i) {
  const auto& first = settings_.servers[i % settings_.servers.size()];
  editors_[i].client->connect(first.host, first.port,
                              [this, i](const client::Result<client::WorldInfo>& world) {
                                if (world) return joined(i, *world);
                                const auto again = std::make_shared<asio::steady_timer>(io_, 200ms);
                                again->async_wait([this, i, again](std::error_code) { connect(i); });
                              });
}

void Editors::joined(std::size_t i, const client::WorldInfo& world) {
  std::vector<MaterialId> palette;
  for (const client::Material& material : world.materials)
    if (material.phase == client::Phase::solid && palette.size() < 4) palette.push_back(material.id);
  for (std::size_t n = 0; n < settings_.lanes; ++n) {
    const std::size_t plot = i * settings_.lanes + n;
    editors_[i].lanes.push_back(
        std::make_unique<Lane>(corner_of(world, plot), palette, settings_.seed * 1'000'003 + plot));
    idle_.emplace_back(i, editors_[i].lanes.back().get());
  }
  if (++joined_ < editors_.size()) return;
  const VoxelPos corner = corner_of(world, 0);
  tell({{"event", "joined"}, {"editors", joined_}, {"corner", {corner.x, corner.y, corner.z}}});
}

void Editors::lost(std::size_t i, const client::ClientError& error, bool retrying) {
  ++totals_.connections_lost;
  std::size_t open = 0;
  for (const auto& lane : editors_[i].lanes) open += lane->open ? 1 : 0;
  tell(
      {{"event", "lost"}, {"editor", i}, {"why", error.message}, {"open", open}, {"done", editors_[i].done}});
  if (!retrying) tell({{"event", "gave up"}, {"editor", i}, {"why", error.message}});
}

void Editors::tick() {
  const auto now = Clock::now();
  credit_ = std::min(settings_.rate / 5 + 1, credit_ + settings_.rate * ms_of(now - last_tick_) / 1000);
  last_tick_ = now;
  for (std::size_t left = edits_ ? idle_.size() : 0; left > 0 && (settings_.rate == 0 || credit_ >= 1);
       --left) {
    const auto [editor, lane] = idle_.front();
    idle_.pop_front();
    credit_ -= settings_.rate == 0 ? 0 : 1;
    begin(editor, *lane);
  }
  ticks_.expires_after(kTick);
  ticks_.async_wait([this](std::error_code) { tick(); });
}

void Editors::begin(std::size_t i, Lane& lane) {
  lane.step = lane.plot.next();
  lane.since = Clock::now();
  if (open_ == 0) totals_.last_answer = std::max(totals_.last_answer, lane.since);
  lane.open = true;
  ++open_;
  client::Edit edit = lane.step.edit;
  editors_[i].client->edit(std::move(edit), [this, i, &lane](const client::Result<client::EditDone>& result) {
    answered(i, lane, result);
  });
}

void Editors::answered(std::size_t i, Lane& lane, const client::Result<client::EditDone>& result) {
  const auto now = Clock::now();
  lane.open = false;
  --open_;
  if (result || result.error().kind == client::ErrorKind::conflict) {
    note_pause(now);
    totals_.last_answer = now;
    totals_.waits.record(now - lane.since);
    ++totals_.done;
    ++editors_[i].done;
  }
  if (result) {
    if (lane.step.conflicts) {
      mistake(lane, "happened against its guards");
    } else if (result->changed != lane.step.changed) {
      mistake(lane, "changed " + std::to_string(result->changed) + " voxels, not " +
                        std::to_string(lane.step.changed));
    } else if (result->changed > 0 && result->revision <= lane.revision) {
      mistake(lane,
              "has revision " + std::to_string(result->revision) + " after " + std::to_string(lane.revision));
    }
    if (result->changed > 0) ++totals_.revisions;
    lane.revision = std::max(lane.revision, result->revision);
    lane.plot.take(lane.step);
  } else if (result.error().kind == client::ErrorKind::conflict) {
    ++totals_.conflicts;
    if (!lane.step.conflicts) mistake(lane, "did not happen: " + result.error().message);
  } else {
    ++totals_.unknown;
    lane.certain = false;
    mistake(lane, "is not known: " + result.error().message);
  }
  if (lane.certain) idle_.emplace_back(i, &lane);
  tell_when_paused();
}

void Editors::mistake(const Lane& lane, const std::string& what) {
  ++totals_.mistakes;
  const VoxelPos at = lane.plot.voxel(0);
  std::ostringstream text;
  text << "an edit at " << at.x << ',' << at.y << ',' << at.z << ' ' << what;
  if (totals_.first_mistake.empty()) totals_.first_mistake = text.str();
  tell({{"event", "mistake"}, {"what", text.str()}});
}

void Editors::verify(const std::string& server) {
  const auto check = std::make_shared<Check>();
  check->server = server;
  client::Options options = impatient();
  options.reconnect.max_attempts = 20;
  check->client = std::make_unique<client::Client>(io_.get_executor(), options);
  const auto address = address_of(server);
  check->client->connect(address.host, address.port,
                         [this, check](const client::Result<client::WorldInfo>& world) {
                           if (world) return fetch(check);
                           check->failed = world.error().message;
                           compare(*check);
                         });
}

void Editors::fetch(const std::shared_ptr<Check>& check) {
  for (const Editor& editor : editors_)
    for (const auto& lane : editor.lanes)
      for (std::size_t index = 0; index < lane->plot.size(); ++index)
        check->chunks.try_emplace(chunk_holding(lane->plot.voxel(index), Lod{})->coord);
  check->wanted = check->chunks.size();
  for (auto& [coord, chunk] : check->chunks) {
    check->client->get(ChunkKey{coord, Lod{}}, std::nullopt,
                       [this, check, &chunk = chunk](const client::Result<client::ReceivedChunk>& received) {
                         if (received) chunk = received->chunk;
                         if (!received) check->failed = received.error().message;
                         // Not within the client's own call.
                         if (--check->wanted == 0) asio::post(io_, [this, check] { compare(*check); });
                       });
  }
}

void Editors::compare(const Check& check) {
  std::size_t wrong = 0;
  std::size_t voxels = 0;
  if (check.failed.empty()) {
    for (const Editor& editor : editors_) {
      for (const auto& lane : editor.lanes) {
        if (!lane->certain) continue;
        for (std::size_t index = 0; index < lane->plot.size(); ++index, ++voxels) {
          const VoxelPos at = lane->plot.voxel(index);
          const auto& chunk = check.chunks.at(chunk_holding(at, Lod{})->coord);
          wrong += chunk->at(local_pos(at)) == lane->plot.at(index) ? 0 : 1;
        }
      }
    }
  }
  tell({{"event", "verified"},
        {"server", check.server},
        {"chunks", check.chunks.size()},
        {"voxels", voxels},
        {"wrong", wrong},
        {"failed", check.failed}});
}

/// On a thread of its own, as std::getline waits.
void read_orders(asio::io_context& io, Editors& editors) {
  for (std::string line; std::getline(std::cin, line);) {
    asio::post(io, [&editors, line] {
      std::istringstream words{line};
      std::string order;
      std::string server;
      words >> order >> server;
      if (order == "go") return editors.go();
      if (order == "pause") return editors.pause();
      if (order == "figures") return editors.figures("figures");
      if (order == "verify") return editors.verify(server);
      std::cerr << "talus-chaos-editors: '" << line
                << "' is not one of go, pause, figures, verify HOST:PORT\n";
    });
  }
  io.stop();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Editors of a cluster who know of each edit what it must do."};
  Settings settings;
  std::vector<std::string> servers;
  app.add_option("--connect", servers, "HOST:PORT of each server; editor i begins at the i-th")
      ->required()
      ->delimiter(',');
  app.add_option("--editors", settings.editors, "Connections")->check(CLI::Range(1, 10'000));
  app.add_option("--lanes", settings.lanes, "Edits that each keeps unanswered, each at a place of its own")
      ->check(CLI::Range(1, 64));
  app.add_option("--rate", settings.rate, "Edits a second of all; 0: as fast as they are answered");
  app.add_flag("--alone", settings.alone, "Each stays with its server, whatever happens");
  app.add_option("--place", settings.place,
                 "Several such programs edit at places of their own: 0, 1, 2, ...");
  app.add_option("--seed", settings.seed, "Of what they do");
  CLI11_PARSE(app, argc, argv);
  for (const auto& server : servers) settings.servers.push_back(address_of(server));
  asio::io_context io;
  Editors editors{io, std::move(settings)};
  std::thread reader{[&] { read_orders(io, editors); }};
  io.run();
  reader.join();
}
