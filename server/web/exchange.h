// One request of a connection and its answer: the context with which answers of all kinds are made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <asio/any_io_executor.hpp>

#include "chunks/encoded_chunk.h"
#include "limits/memory/memory_reservation.h"
#include "net/http/request.h"
#include "net/http/response.h"
#include "player/session/session_context.h"
#include "runtime/clock.h"
#include "web/cache_fields.h"
#include "web/error_answers.h"
#include "web/fetch.h"
#include "web/requester.h"
#include "web/web_context.h"

namespace talus::server::web {

class Exchange {
 public:
  /// Memory of an idle connection.
  static constexpr std::size_t kIdleBytes = std::size_t{16} * 1024;

  /// For a connection's requests, one after the other. `context` and `requester` outlive it.
  Exchange(const WebContext& context, Requester& requester, asio::any_io_executor executor);

  /// `request` stays valid until it is answered; it arrived at `came`.
  void begin(const http::Request& request, Clock::time_point came);
  /// Cancels the answer: a waiting fetch ends with FetchError::gone.
  void abandon();
  /// Releases its chunks.
  void end() { fetch_.reset(); }

  [[nodiscard]] const WebContext& context() const { return context_; }
  [[nodiscard]] const SessionContext& shared() const { return shared_; }
  [[nodiscard]] ChunkSource& chunks() const { return shared_.chunks; }
  [[nodiscard]] Requester& requester() const { return requester_; }
  [[nodiscard]] const asio::any_io_executor& executor() const { return executor_; }
  [[nodiscard]] const http::Request& request() const { return *request_; }
  [[nodiscard]] std::string_view path() const { return path_; }
  /// True if the request is for the world and not for a file.
  [[nodiscard]] bool is_for_players() const { return for_players_; }
  [[nodiscard]] Clock::time_point began() const { return began_; }
  /// Time limit of generation, after which the client is asked to retry.
  [[nodiscard]] Clock::time_point deadline() const;

  /// Reserves memory until the answer is sent, in addition to an idle connection's.
  void hold(std::size_t bytes) { memory_.hold(kIdleBytes + bytes); }
  /// The answer is being written from now on, until drained(); `bytes` more of it are written.
  void drains(Clock::time_point now) { memory_.drain_begins(now, 0); }
  void drains_on(std::size_t bytes) { memory_.drain_goes_on(bytes); }
  void drained() { memory_.drained(); }
  /// The connection's memory is shared with other flows'.
  void share_memory(const FlowShares::GiveWay& give_way) {
    if (requester_.is_here()) memory_.share(requester_.flow()->id(), give_way);
  }
  /// Returns true if the client's flow may have `bytes` more for work.
  [[nodiscard]] bool takes_work(std::size_t bytes) const {
    return shared_.memory.takes_work_of(requester_.flow()->id(), bytes, shared_.clock.now());
  }
  /// Keeps the owner of the answer's bytes alive.
  void keep(std::shared_ptr<const void> kept) { kept_ = std::move(kept); }
  /// Starts a fetch, in turn with the client's flow. Call once per request.
  [[nodiscard]] Fetch& start_fetch();

  /// Charges the rates for the response's chunks and bytes.
  void charge(std::size_t chunks, const http::Response& response);
  /// Returns true if the rates were charged.
  [[nodiscard]] bool counted() const { return counted_; }
  /// A response with bytes that never change.
  [[nodiscard]] http::Response immutable(std::string body) const;
  [[nodiscard]] http::Response immutable(const EncodedChunkPtr& chunk);
  /// Marks the response as having `revision` instead of its path's revision: it must not be cached.
  void tell_revision(http::Response& response, std::uint64_t revision) const;
  /// Marks the answer as a chunk found in memory.
  void found_in_memory() { hot_ = true; }
  [[nodiscard]] bool hot() const { return hot_; }

  Audience audience;  // the answer's

 private:
  const WebContext& context_;
  const SessionContext& shared_;
  Requester& requester_;
  const asio::any_io_executor executor_;
  MemoryReservation memory_;
  std::shared_ptr<Fetch> fetch_;

  const http::Request* request_ = nullptr;
  std::string_view path_;
  bool for_players_ = false;
  Clock::time_point began_{};
  std::shared_ptr<const void> kept_;
  bool counted_ = false;
  bool hot_ = false;
};

}  // namespace talus::server::web
