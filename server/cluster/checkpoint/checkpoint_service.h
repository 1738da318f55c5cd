// GET /store/checkpoint of the operators' port: the store as of now, for a server that joins. Only for who
// has a token with the right admin; a few at once; at a rate of its own.
//
// The disk is read on threads of its own, a bounded piece at a time, so neither the operators' port nor
// players wait for it. Who takes too long is cut off: no checkpoint is kept for ever.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <asio/awaitable.hpp>
#include <asio/thread_pool.hpp>
#include <tl/expected.hpp>

#include "cluster/checkpoint/checkpoint_tar.h"
#include "config/access/access_control.h"
#include "limits/rates/token_bucket.h"
#include "net/http/request.h"
#include "net/http/response.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class CheckpointService {
 public:
  static constexpr int kMaxAtOnce = 2;

  /// All outlive this.
  struct Parts {
    const AccessControl& access;
    Metrics& metrics;
    const Clock& clock;
    std::filesystem::path directory;  // of the store
    /// Makes the database's checkpoint at a path. On any thread.
    std::function<tl::expected<void, std::string>(const std::filesystem::path&)> make;
  };

  CheckpointService(Parts parts, std::uint64_t bytes_per_second, Logger log);
  ~CheckpointService();

  /// On one thread, that of the connections, from which `address` is.
  [[nodiscard]] asio::awaitable<http::Response> respond(const http::Request& request,
                                                        const std::string& address);
  /// Of all that are sent together; 0: no limit. Any thread.
  void set_rate(std::uint64_t bytes_per_second) { wanted_rate_ = bytes_per_second; }

  /// Waits until no thread of it works. Once, when the connections' thread has ended, before they are
  /// destroyed.
  void stop();

 private:
  class Body;

  /// Who asks, or the refusal.
  [[nodiscard]] tl::expected<std::string, http::Response> admit(const http::Request& request,
                                                                const std::string& address);
  /// May wait for the disk.
  [[nodiscard]] tl::expected<std::unique_ptr<CheckpointTar>, std::string> make(std::uint64_t number) const;
  /// When the next piece may go.
  [[nodiscard]] std::chrono::nanoseconds wait();
  void spend(std::uint64_t bytes);
  void follow_rate();

  const Parts parts_;
  const Logger log_;
  std::atomic<std::uint64_t> wanted_rate_;
  // Of the connections' thread.
  Rate rate_;
  TokenBucket bucket_;
  int at_once_ = 0;
  std::uint64_t next_number_ = 1;
  Clock::time_point next_complaint_{};
  asio::thread_pool disk_;
};

}  // namespace talus::server
