#include "request_timeout.h"

#include <sstream>

namespace talus::cli {

struct RequestTimeout::State {
  client::Clock& clock;
  std::unique_ptr<client::Timer> timer;
  client::Client& client;
  Seconds time;
  client::Clock::Time end;
  bool expired = false;
};

RequestTimeout::RequestTimeout(const asio::any_io_executor& executor, client::Clock& clock,
                               client::Client& client, Seconds time)
    : state_{new State{clock, clock.make_timer(executor), client, time, {}}} {
  restart();
  wait(state_);
}

void RequestTimeout::restart() {
  state_->end = state_->clock.now() + std::chrono::duration_cast<client::Clock::Time::duration>(state_->time);
}

void RequestTimeout::wait(const std::shared_ptr<State>& state) {
  state->timer->async_wait_until(state->end, [weak = std::weak_ptr{state}](std::error_code error) {
    const auto self = weak.lock();
    if (error || !self) return;
    if (self->clock.now() < self->end) return wait(self);
    self->expired = true;
    self->client.close();
  });
}

bool RequestTimeout::has_expired() const {
  return state_->expired;
}

std::string RequestTimeout::explain(const client::ClientError& error) const {
  if (!state_->expired) return error.message;
  std::ostringstream line;
  line << "the server has not answered within " << state_->time.count() << " s";
  if (!error.waited_for.empty()) line << "; it said: " << error.waited_for;
  return line.str();
}

}  // namespace talus::cli
