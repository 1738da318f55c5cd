#include "session.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

#include "convert.h"

namespace talus::c_api {
namespace {

// Bounds the callbacks of one poll, so that a poll without waiting returns even if they produce no events.
constexpr int kMaxHandlers = 256;

QueuedEvent with_world(std::uint32_t type, const client::WorldInfo& world) {
  QueuedEvent event;
  event.type = type;
  event.world = std::make_shared<const client::WorldInfo>(world);
  return event;
}

QueuedEvent with_error(std::uint32_t type, const client::ClientError& error) {
  QueuedEvent event;
  event.type = type;
  event.error = error;
  return event;
}

QueuedEvent answer(std::uint32_t type, std::uint32_t request) {
  QueuedEvent event;
  event.type = type;
  event.request = request;
  return event;
}

}  // namespace

Session::Session(const std::string& host, const std::string& port, client::Options options) {
  client_.emplace(io_.get_executor(), std::move(options), events());
  client_->connect(host, port, [this](const auto& world) { remember([&] { on_joined(world); }); });
}

Session::~Session() {
  // Closing allocates; if that fails, destroying the event loop closes the sockets.
  remember([&] { client_->close(); });
}

template <typename Work>
void Session::remember(Work&& work) noexcept {
  try {
    work();
  } catch (const std::bad_alloc&) {
    out_of_memory_ = true;
  }
}

client::Events Session::events() {
  client::Events events;
  events.on_chunk = [this](const client::ReceivedChunk& chunk) {
    remember([&] {
      QueuedEvent& event = queue_.emplace_back();
      event.type = TALUS_EVENT_CHUNK;
      event.chunk = chunk;
    });
  };
  events.on_left_view = [this](const ChunkKey& key) {
    remember([&] {
      QueuedEvent& event = queue_.emplace_back();
      event.type = TALUS_EVENT_CHUNK_LEFT;
      event.chunk.key = key;
    });
  };
  events.on_view_complete = [this](const client::View&) {
    remember([&] { queue_.emplace_back().type = TALUS_EVENT_VIEW_COMPLETE; });
  };
  events.on_error = [this](const client::ClientError& error) {
    remember([&] { queue_.push_back(with_error(TALUS_EVENT_ERROR, error)); });
  };
  events.on_disconnect = [this](const client::ClientError& error, bool retrying) {
    remember([&] { on_disconnect(error, retrying); });
  };
  events.on_reconnect = [this](const client::WorldInfo& world) {
    remember([&] { queue_.push_back(with_world(TALUS_EVENT_RECONNECTED, world)); });
  };
  return events;
}

void Session::on_joined(const client::Result<client::WorldInfo>& world) {
  if (world) {
    queue_.push_back(with_world(TALUS_EVENT_JOINED, *world));
  } else {
    closed_ = with_error(TALUS_EVENT_CLOSED, world.error());
  }
}

// At the end of the connection, open requests are still to be answered.
void Session::on_disconnect(const client::ClientError& error, bool retrying) {
  if (retrying) {
    queue_.push_back(with_error(TALUS_EVENT_RECONNECTING, error));
  } else {
    closed_ = with_error(TALUS_EVENT_CLOSED, error);
  }
}

const QueuedEvent* Session::wait(std::int32_t timeout_ms) {
  if (queue_.empty() && !closed_ && !over_) run_some(timeout_ms);
  if (!queue_.empty()) return &queue_.front();
  return closed_ ? &*closed_ : nullptr;
}

void Session::run_some(std::int32_t timeout_ms) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds{timeout_ms};
  const auto nothing_yet = [this] { return queue_.empty() && !closed_; };
  io_.restart();
  for (int handlers = 0; nothing_yet(); ++handlers) {
    const bool late = timeout_ms >= 0 && std::chrono::steady_clock::now() >= end;
    if (late && handlers >= kMaxHandlers) return;
    std::size_t ran = io_.poll_one();
    if (ran == 0 && late) return;
    if (ran == 0) ran = timeout_ms < 0 ? io_.run_one() : io_.run_one_until(end);
    if (out_of_memory_) throw std::bad_alloc{};
    if (ran == 0 && io_.stopped()) throw std::logic_error{"a connection that waits for nothing"};
  }
}

QueuedEvent Session::pop() {
  if (queue_.empty()) {
    over_ = true;
    return std::exchange(closed_, std::nullopt).value();
  }
  QueuedEvent event = std::move(queue_.front());
  queue_.pop_front();
  return event;
}

client::Result<void> Session::set_view(const client::View& view) {
  auto set = client_->set_view(view);
  if (out_of_memory_) throw std::bad_alloc{};
  if (set && view_ != view) {
    view_ = view;
    // Queued events would be taken for the new View's.
    std::erase_if(queue_, [](const QueuedEvent& e) { return e.type == TALUS_EVENT_VIEW_COMPLETE; });
  }
  return set;
}

std::uint32_t Session::new_number() {
  if (++last_number_ == 0) ++last_number_;
  return last_number_;
}

std::uint32_t Session::get_chunk(const ChunkKey& key, std::optional<ContentHash> known) {
  const std::uint32_t number = new_number();
  const auto answered = [this, number, key](client::Result<client::ReceivedChunk> chunk) {
    remember([&] {
      chunk_requests_.erase(number);
      QueuedEvent event = answer(TALUS_EVENT_CHUNK_ANSWER, number);
      event.chunk.key = key;
      if (chunk) {
        event.chunk = std::move(*chunk);
      } else {
        event.error = std::move(chunk.error());
      }
      queue_.push_back(std::move(event));
    });
  };
  chunk_requests_[number] = client_->get(key, known, answered);
  return number;
}

std::uint32_t Session::get_heights(std::vector<client::Column> columns) {
  const std::uint32_t number = new_number();
  client_->get_heights(std::move(columns), [this, number](client::Result<std::vector<std::int32_t>> heights) {
    remember([&] {
      QueuedEvent event = answer(TALUS_EVENT_HEIGHTS, number);
      if (heights) {
        event.places.heights_fx = std::move(*heights);
      } else {
        event.error = std::move(heights.error());
      }
      queue_.push_back(std::move(event));
    });
  });
  return number;
}

std::uint32_t Session::get_places(std::vector<client::Column> columns, std::vector<std::string> fields) {
  const std::uint32_t number = new_number();
  const auto field_count = static_cast<std::uint32_t>(fields.size());
  client_->get_places(std::move(columns), std::move(fields),
                      [this, number, field_count](client::Result<client::ColumnPlaces> places) {
                        remember([&] {
                          QueuedEvent event = answer(TALUS_EVENT_HEIGHTS, number);
                          if (places) {
                            event.places = std::move(*places);
                            event.field_count = field_count;
                          } else {
                            event.error = std::move(places.error());
                          }
                          queue_.push_back(std::move(event));
                        });
                      });
  return number;
}

std::uint32_t Session::edit(client::Edit edit) {
  const std::uint32_t number = new_number();
  client_->edit(std::move(edit), [this, number](const client::Result<client::EditDone>& done) {
    remember([&] {
      QueuedEvent event = answer(TALUS_EVENT_EDITED, number);
      if (done) {
        event.done = *done;
      } else {
        event.error = done.error();
      }
      queue_.push_back(std::move(event));
    });
  });
  return number;
}

std::uint32_t Session::ping() {
  const std::uint32_t number = new_number();
  client_->ping([this, number](const client::Result<std::chrono::nanoseconds>& time) {
    remember([&] {
      QueuedEvent event = answer(TALUS_EVENT_PONG, number);
      if (time) {
        event.round_trip = *time;
      } else {
        event.error = time.error();
      }
      queue_.push_back(std::move(event));
    });
  });
  return number;
}

void Session::cancel(std::uint32_t request) {
  const auto open = chunk_requests_.find(request);
  if (open != chunk_requests_.end()) client_->cancel(open->second);
}

}  // namespace talus::c_api
