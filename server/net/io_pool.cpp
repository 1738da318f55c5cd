#include "net/io_pool.h"

#include <exception>
#include <utility>

namespace talus::server {

IoPool::IoPool(std::size_t threads, Logger log) : log_{std::move(log)} {
  for (std::size_t thread = 0; thread < threads; ++thread) {
    contexts_.push_back(std::make_unique<asio::io_context>(1));
    guards_.emplace_back(contexts_.back()->get_executor());
  }
}

IoPool::~IoPool() {
  end();
}

asio::io_context& IoPool::next() {
  turn_ = (turn_ + 1) % contexts_.size();
  return *contexts_[turn_];
}

void IoPool::run() {
  try {
    for (std::size_t other = 1; other < contexts_.size(); ++other) {
      threads_.emplace_back([this, other] { serve(*contexts_[other]); });
    }
  } catch (...) {
    end();  // objects that their handlers use may not outlive this call
    throw;
  }
  serve(control());
  end();
}

void IoPool::end() {
  stop();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void IoPool::serve(asio::io_context& context) const {
  while (!context.stopped()) {
    try {
      context.run();
    } catch (const std::exception& error) {
      log_->error("a handler failed: {}", error.what());
    }
  }
}

void IoPool::stop() {
  for (const auto& context : contexts_) context->stop();
}

}  // namespace talus::server
