// A server of whose store checkpoints are taken: a store that is open, and its operators' port.
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include <asio/ip/tcp.hpp>
#include <asio/write.hpp>

#include "admin/admin_server.h"
#include "checkpoint_store.h"
#include "cluster/checkpoint/checkpoint_download.h"
#include "cluster/checkpoint/checkpoint_service.h"
#include "signed_tokens.h"

namespace talus::server::testing {

using asio::ip::tcp;
namespace fs = std::filesystem;

inline const Logger kSilentLog = make_logger("off", "text");

/// A server of a store: its operators' port alone.
struct Peer {
  explicit Peer(std::uint64_t seed = 7, std::uint64_t rate = 1U << 30U, bool with_keys = true)
      : store{seed},
        access{settings(store.scratch, with_keys), *load_keys(settings(store.scratch, with_keys))},
        service{{access, metrics, clock, store.path,
                 [this](const fs::path& path) { return store.store.database().checkpoint(path); }},
                rate,
                kSilentLog} {
    const auto listening = server->listen({"127.0.0.1", 0});
    REQUIRE(listening.has_value());
    url = "http://" + *listening;
    address = {asio::ip::address_v4::loopback(),
               static_cast<std::uint16_t>(std::stoi(listening->substr(listening->rfind(':') + 1)))};
    server->start(
        {[] { return ""; }, [] { return true; }, [] { return Readiness{}; }, [] { return FlowsReport{}; },
         [this](const http::Request& request, const std::string& from, std::function<void()> close) {
           return service.respond(request, from, std::move(close));
         }});
  }
  ~Peer() { end(); }
  void end() {
    if (server == nullptr) return;
    server->stop();
    service.stop();
    server.reset();
  }

  static Access settings(const ScratchDirectory& scratch, bool with_keys) {
    Access access;
    if (with_keys) access.signing_key_file = scratch.write("key", kKeyText);
    return access;
  }
  [[nodiscard]] std::string signed_token(Rights rights) const {
    return *make_signed_token(Secret{kKeyText}, {"joiner", rights, clock.wall() + std::chrono::hours{1}},
                              clock.wall());
  }
  [[nodiscard]] PeerAccess admin() const { return {signed_token({Right::read, Right::admin}), {}, {}, {}}; }
  [[nodiscard]] std::string error_with(const std::string& token) const {
    const auto download = CheckpointDownload::open(url, {token, {}, {}, {}});
    return download ? "" : download.error().reason;
  }
  /// A request of a client that reads nothing.
  [[nodiscard]] tcp::socket ask(const asio::ip::address& from = asio::ip::address_v4::loopback()) {
    tcp::socket socket{io};
    socket.open(tcp::v4());
    socket.bind({from, 0});
    socket.set_option(asio::socket_base::receive_buffer_size{4'096});
    socket.connect(address);
    const std::string text = "GET /store/checkpoint HTTP/1.1\r\nHost: a\r\nAuthorization: Bearer " +
                             signed_token({Right::read, Right::admin}) + "\r\n\r\n";
    asio::write(socket, asio::buffer(text));
    return socket;
  }
  [[nodiscard]] std::size_t checkpoints() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        fs::directory_iterator{store.path},
        [](const auto& entry) { return entry.path().filename().string().starts_with("talus-checkpoint-"); }));
  }

  SystemClock clock;
  Metrics metrics;
  CheckpointStore store;
  AccessControl access;
  CheckpointService service;
  std::unique_ptr<AdminServer> server = std::make_unique<AdminServer>(clock, kSilentLog);
  std::string url;
  tcp::endpoint address;
  asio::io_context io;
};

}  // namespace talus::server::testing
