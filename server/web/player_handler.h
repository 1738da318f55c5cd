// Answers one connection's HTTP requests: chunks, columns of them, heights, the world. What is cached is
// answered at once; the rest waits for the generators, in the turns of the client's flow.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/ip/address.hpp>

#include "config/allowed_origins.h"
#include "config/networks.h"
#include "flows/flow_use.h"
#include "http/handler.h"
#include "http/request.h"
#include "http/response.h"
#include "http/service.h"
#include "memory/memory_reservation.h"
#include "net/accepted_connection.h"
#include "net/admission.h"
#include "net/session_runner.h"
#include "rates/rates.h"
#include "web/fetch.h"
#include "web/routes.h"
#include "web/site.h"
#include "web/world_document.h"

namespace talus::server::web {

struct WebSettings {
  bool public_chunks = false;  // chunks need no token, and every cache may keep them
  AllowedOrigins origins;
  Networks proxies;           // who names its clients in X-Forwarded-For
  std::uint64_t log_every{};  // answers, of which one is logged; 0: none
};

/// What players' HTTP connections share. `runner`'s context outlives them.
struct WebContext {
  RunnerContextPtr runner;
  WebSettings settings;
  Admission& admission;
  http::Service service;
  std::string fingerprint;              // as paths have it
  std::atomic<std::uint64_t>& answers;  // of all connections, for the log
  std::atomic<std::uint64_t>& fetches;  // that ever waited, for their ids
  std::shared_ptr<const Site> site;     // null: none
  std::shared_ptr<WorldDocument> world;
};
using WebContextPtr = std::shared_ptr<const WebContext>;

/// What a client of the HTTP port is told that is refused: a whole response.
[[nodiscard]] std::vector<std::byte> refusal_response(wire::ErrorCode code, const std::string& text,
                                                      std::chrono::milliseconds retry_after);

class PlayerHandler final : public http::Handler {
 public:
  /// Memory of a connection that asks for nothing.
  static constexpr std::size_t kIdleBytes = std::size_t{16} * 1024;

  /// `slot`: the connection's.
  PlayerHandler(WebContextPtr context, const ConnectionInfo& connection, Admission::Slot slot,
                asio::any_io_executor executor);
  ~PlayerHandler() override;

  std::optional<http::Response> respond_now(const http::Request& request) override;
  asio::awaitable<http::Response> respond(const http::Request& request) override;
  http::Response refuse(const http::RequestError& error) override;
  void sent() override;
  void closed() override;
  /// Called once, where the connection ends without having become a session.
  void on_closed(std::function<void()> told) { told_ = std::move(told); }

  /// The connection's address is on the list of the blocked now.
  [[nodiscard]] bool blocked() const;
  void rates_changed();
  /// For the session that takes the connection over: of the client that asked for it.
  [[nodiscard]] Admission::Slot take_slot();
  [[nodiscard]] ConnectionInfo session_info() const;

 private:
  /// Whom a request counts as: the connection's client, or whom a proxy names.
  struct Caller {
    Caller(Admission::Slot of, const WebContext& context);
    Admission::Slot slot;
    SessionRates rates;
    FlowUsePtr flow;
  };
  using Answer = std::optional<http::Response>;  // none: it waits

  [[nodiscard]] Answer decide(const http::Request& request);
  [[nodiscard]] Answer find_caller(const http::Request& request);
  [[nodiscard]] Answer check_token(const http::Request& request, bool may_be_public);
  [[nodiscard]] Answer check_rates();
  [[nodiscard]] Answer answer(const WorldRoute& route);
  [[nodiscard]] Answer answer(const StreamRoute& route);
  [[nodiscard]] Answer answer(const ChunkRoute& route);
  [[nodiscard]] Answer answer(const ColumnsRoute& route);
  [[nodiscard]] Answer answer(const HeightsRoute& route);
  [[nodiscard]] Answer answer(const MapRoute& route);
  [[nodiscard]] Answer check_world(std::string_view fingerprint) const;
  [[nodiscard]] Answer check_world(std::string_view fingerprint, std::string_view codec) const;

  [[nodiscard]] asio::awaitable<http::Response> fetch(const ChunkRoute& route);
  [[nodiscard]] asio::awaitable<http::Response> fetch(const ColumnsRoute& route);
  [[nodiscard]] asio::awaitable<http::Response> fetch(const HeightsRoute& route);
  [[nodiscard]] asio::awaitable<http::Response> fetch(const MapRoute& route);
  /// One column of the square appended to `body`; an answer where that cannot be had. `held`: bytes of the
  /// others.
  [[nodiscard]] asio::awaitable<Answer> append(ChunkKey column, std::string& body, std::size_t held);
  /// Waits until the rates let a chunk go; an answer where that is too long. Before the work: who has no rate
  /// left costs the generators nothing.
  [[nodiscard]] asio::awaitable<Answer> wait_for_rates();
  /// Counts in the rates.
  void charge(std::size_t chunks, std::size_t bytes);
  [[nodiscard]] http::Response over_rate(std::chrono::nanoseconds wait) const;
  /// The response, whose chunks and bytes count now.
  [[nodiscard]] http::Response charged(std::size_t chunks, http::Response response);

  [[nodiscard]] http::Response chunk_response(const EncodedChunk& chunk);
  [[nodiscard]] http::Response body_response(std::string body);
  [[nodiscard]] http::Response picture_response(const PicturePtr& picture);
  [[nodiscard]] AnswerKind kind() const;
  /// With ETag, and 304 where the client has it.
  [[nodiscard]] http::Response tagged(http::Response response) const;
  [[nodiscard]] http::Response tagged(http::Response response, std::string tag) const;
  [[nodiscard]] http::Response failure(FetchError error) const;
  [[nodiscard]] http::Response refuse(const SessionRates::Refusal& refusal) const;
  void finish(const http::Request& request, http::Response& response);
  void log_answer(const http::Request& request, int status, std::size_t bytes) const;
  void leave();
  /// Which pages may read it.
  void add_origin_fields(const http::Request& request, http::Response& response) const;

  const WebContextPtr context_;
  const SessionContext& shared_;
  const ConnectionInfo connection_;
  const asio::any_io_executor executor_;
  MemoryReservation memory_;
  std::optional<Caller> caller_;
  std::optional<Admission::Slot> proxy_slot_;  // of a connection whose requests name their clients
  std::shared_ptr<Fetch> fetch_;
  std::function<void()> told_;
  bool closed_ = false;

  // ---- of the request that is answered
  const http::Request* request_ = nullptr;
  Clock::time_point began_{};
  std::optional<Route> route_;
  std::shared_ptr<const void> kept_;  // whose bytes the answer has
  bool open_ = false;                 // nobody needs a token
  bool public_ = false;               // every cache may keep the answer
  bool counted_ = false;              // its bytes count in the rates already
  std::size_t made_ = 0;              // chunks of columns, so far
};

}  // namespace talus::server::web
