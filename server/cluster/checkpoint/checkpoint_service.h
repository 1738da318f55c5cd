// GET /store/checkpoint of the operators' port: sends the current store to a joining server. Requires a token
// with the right admin; limited in number and rate. Addresses share the number (flow_shares.h).
//
// Reads the disk on its own threads in bounded pieces, so that neither the operators' port nor players wait
// for it. Slow downloads are cut off, so that checkpoints do not stay on the disk for ever.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <tl/expected.hpp>

#include "cluster/checkpoint/checkpoint_tar.h"
#include "config/access/access_control.h"
#include "limits/flows/flow_ids.h"
#include "limits/flows/flow_shares.h"
#include "limits/rates/token_bucket.h"
#include "net/http/request.h"
#include "net/http/response.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class CheckpointService {
 public:
  static constexpr std::size_t kMaxAtOnce = 2;

  /// The referenced objects must outlive this.
  struct Parts {
    const AccessControl& access;
    Metrics& metrics;
    const Clock& clock;
    std::filesystem::path directory;  // the store's
    /// Writes the database's checkpoint to a path. Called on any thread.
    std::function<tl::expected<void, std::string>(const std::filesystem::path&)> make;
  };

  CheckpointService(Parts parts, std::uint64_t bytes_per_second, Logger log);
  ~CheckpointService();

  /// Call on the connections' thread. `address` is the client's; `close` ends its connection soon.
  [[nodiscard]] asio::awaitable<http::Response> respond(const http::Request& request,
                                                        const std::string& address,
                                                        FlowShares::GiveWay close);
  /// Limits all downloads together; 0: unlimited. Callable from any thread.
  void set_rate(std::uint64_t bytes_per_second) { wanted_rate_ = bytes_per_second; }

  /// Waits until its threads are idle. Call once, after the connections' thread has ended and before the
  /// connections are destroyed.
  void stop();

 private:
  class Body;

  [[nodiscard]] FlowId flow_of(const std::string& address) const;
  /// Returns the name of the authorized client, or the refusal.
  [[nodiscard]] tl::expected<std::string, http::Response> admit(const http::Request& request,
                                                                const std::string& address);
  /// May wait for the disk.
  [[nodiscard]] tl::expected<std::unique_ptr<CheckpointTar>, std::string> make(std::uint64_t number) const;
  /// Delay before the next piece may be sent.
  [[nodiscard]] std::chrono::nanoseconds wait();
  void spend(std::uint64_t bytes);
  void follow_rate();

  const Parts parts_;
  const Logger log_;
  std::atomic<std::uint64_t> wanted_rate_;
  // Used by the connections' thread.
  Rate rate_;
  TokenBucket bucket_;
  const FlowIds flows_;
  FlowShares places_{Clock::duration::max()};  // a download has a deadline
  std::uint64_t next_number_ = 1;
  Clock::time_point next_complaint_{};
  // Not asio::thread_pool: if its second thread cannot start, its constructor waits for the first for ever.
  asio::io_context disk_;
  asio::executor_work_guard<asio::io_context::executor_type> disk_work_{disk_.get_executor()};
  std::vector<std::jthread> threads_;
};

}  // namespace talus::server
