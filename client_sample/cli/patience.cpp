#include "patience.h"

#include <sstream>

#include <asio/steady_timer.hpp>

namespace talus::cli {

using Clock = std::chrono::steady_clock;

struct Patience::State {
  asio::steady_timer timer;
  client::Client& client;
  Seconds time;
  Clock::time_point end;
  bool over = false;
};

Patience::Patience(const asio::any_io_executor& executor, client::Client& client, Seconds time)
    : state_{new State{asio::steady_timer{executor}, client, time, {}}} {
  renew();
  wait(state_);
}

void Patience::renew() {
  state_->end = Clock::now() + std::chrono::duration_cast<Clock::duration>(state_->time);
}

void Patience::wait(const std::shared_ptr<State>& state) {
  state->timer.expires_at(state->end);
  state->timer.async_wait([weak = std::weak_ptr{state}](std::error_code error) {
    const auto self = weak.lock();
    if (error || !self) return;
    if (Clock::now() < self->end) return wait(self);
    self->over = true;
    self->client.close();
  });
}

bool Patience::is_over() const {
  return state_->over;
}

std::string Patience::explain(const client::ClientError& error) const {
  if (!state_->over) return error.message;
  std::ostringstream line;
  line << "the server has not answered within " << state_->time.count() << " s";
  return line.str();
}

}  // namespace talus::cli
