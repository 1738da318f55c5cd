// One io_context for each thread that serves sockets. A socket stays on the context for which it was
// accepted.
#pragma once

#include <cstddef>
#include <memory>
#include <thread>
#include <vector>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>

#include "runtime/log/logger.h"

namespace talus::server {

class IoPool {
 public:
  IoPool(std::size_t threads, Logger log);
  ~IoPool();
  IoPool(const IoPool&) = delete;
  IoPool& operator=(const IoPool&) = delete;

  /// The context of the thread that calls run().
  [[nodiscard]] asio::io_context& control() { return *contexts_.front(); }
  /// Returns the contexts in turn. Call from one thread.
  [[nodiscard]] asio::io_context& next();

  /// Runs every context until stop(), the control one in the calling thread. Exceptions from handlers are
  /// logged: they must not end the thread, which serves other sockets too.
  void run();
  /// Ends run() without waiting for pending work. Callable from any thread.
  void stop();

 private:
  void serve(asio::io_context& context) const;
  /// Stops the contexts and joins the threads.
  void end();

  Logger log_;
  std::vector<std::unique_ptr<asio::io_context>> contexts_;
  std::vector<asio::executor_work_guard<asio::io_context::executor_type>> guards_;
  std::vector<std::thread> threads_;
  std::size_t turn_ = 0;
};

}  // namespace talus::server
