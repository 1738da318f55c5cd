// One request of a connection and its answer: what the answers of all kinds are made with.
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
  /// Memory of a connection that asks for nothing.
  static constexpr std::size_t kIdleBytes = std::size_t{16} * 1024;

  /// One after the other, of a connection. `context` and `requester` outlive it.
  Exchange(const WebContext& context, Requester& requester, asio::any_io_executor executor);

  /// `request` stays until its answer is there; it came at `came`.
  void begin(const http::Request& request, Clock::time_point came);
  /// No answer is wanted any more: who waits for chunks gets FetchError::gone.
  void abandon();
  /// Its chunks are let go.
  void end() { fetch_.reset(); }

  [[nodiscard]] const WebContext& context() const { return context_; }
  [[nodiscard]] const SessionContext& shared() const { return shared_; }
  /// As generated, or, where `edited`, what sessions are sent.
  [[nodiscard]] ChunkSource& chunks(bool edited = false) const {
    return edited ? shared_.chunks : context_.chunks;
  }
  [[nodiscard]] Requester& requester() const { return requester_; }
  [[nodiscard]] const asio::any_io_executor& executor() const { return executor_; }
  [[nodiscard]] const http::Request& request() const { return *request_; }
  [[nodiscard]] std::string_view path() const { return path_; }
  /// Whether it asks for something of the world, and not for a file.
  [[nodiscard]] bool is_for_players() const { return for_players_; }
  [[nodiscard]] Clock::time_point began() const { return began_; }
  /// What has to be generated comes until then, or the client is told to ask again.
  [[nodiscard]] Clock::time_point deadline() const;

  /// Memory that is held until the answer is sent, beside the idle connection's.
  void hold(std::size_t bytes) { memory_.hold(kIdleBytes + bytes); }
  /// Keeps what holds the answer's bytes.
  void keep(std::shared_ptr<const void> kept) { kept_ = std::move(kept); }
  /// From chunks(edited), in the client's turn. Once for each request.
  [[nodiscard]] Fetch& start_fetch(bool edited = false);

  /// The response's chunks and bytes count now.
  void charge(std::size_t chunks, const http::Response& response);
  /// Its bytes count in the rates already.
  [[nodiscard]] bool counted() const { return counted_; }
  /// Bytes that never change.
  [[nodiscard]] http::Response immutable(std::string body) const;
  [[nodiscard]] http::Response immutable(const EncodedChunkPtr& chunk);
  /// The response is of this revision, and not of its path's: no cache keeps it.
  void tell_revision(http::Response& response, std::uint64_t revision) const;
  /// The answer is a chunk that was in memory.
  void found_in_memory() { hot_ = true; }
  [[nodiscard]] bool hot() const { return hot_; }

  Audience audience;  // of the answer

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
