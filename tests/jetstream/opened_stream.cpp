#include "opened_stream.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cluster/jetstream/stream_admin.h"

namespace talus::nats_test {

using namespace server;
using namespace server::jetstream;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span{text.data(), text.size()});
}

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

StreamNames test_names(std::uint64_t store) {
  return StreamNames::of(ContentHash{store, 0});
}

ServerUrls urls_of(const std::string& list) {
  constexpr std::array<std::string_view, 2> kSchemes{"nats", "tls"};
  auto urls = ServerUrls::parse(list, kSchemes);
  if (!urls) throw std::runtime_error{urls.error()};
  return *std::move(urls);
}

std::shared_ptr<Connection> connected_to(const std::string& urls, Credentials credentials) {
  const auto patience_ends = std::chrono::steady_clock::now() + std::chrono::seconds{20};
  const auto shared = std::make_shared<const Credentials>(std::move(credentials));
  for (;;) {
    auto connection = Connection::open(urls_of(urls), shared, nullptr, Retry::never);
    if (connection) return *std::move(connection);
    if (std::chrono::steady_clock::now() > patience_ends) throw std::runtime_error{connection.error().reason};
  }
}

Credentials as_talusd() {
  Credentials who;
  who.user = "talus";
  who.password.emplace("p");
  return who;
}

void make_stream(const NatsServers& servers, const StreamNames& names, std::uint64_t replicas) {
  const auto patience_ends = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  const auto connection = connected_to(servers.url_list());
  for (;;) {
    const auto made = jetstream::make_stream(*connection, names, replicas);
    if (made) break;
    // Until the leader of all has heard of enough servers.
    if (std::chrono::steady_clock::now() > patience_ends) {
      throw std::runtime_error{failure_of(made.error(), names).reason};
    }
  }
  servers.await_replicas(names.stream);
}

std::string ask(const NatsServers& servers, const std::string& subject, const std::string& text) {
  const auto reply = connected_to(servers.url_list())->request(subject, text, std::chrono::seconds{5});
  if (!reply) throw std::runtime_error{reply.error().reason};
  return std::string{ReceivedMessage{reply->get()}.text()};
}

std::vector<std::uint64_t> last_of_each(const NatsServers& servers, const std::string& stream) {
  std::vector<std::uint64_t> last;
  for (std::size_t server = 0; server < servers.count(); ++server) {
    const auto page = nlohmann::json::parse(servers.page(server, "/jsz?streams=true"));
    for (const auto& each : page.at("account_details").at(0).at("stream_detail")) {
      if (each.at("name") == stream) last.push_back(each.at("state").at("last_seq"));
    }
  }
  return last;
}

namespace {

using Headers = std::vector<std::pair<std::string, std::string>>;

void send_with(const NatsServers& servers, const std::string& subject, const Headers& headers,
               std::string_view text) {
  const auto must = [](natsStatus status) {
    if (status != NATS_OK) throw std::runtime_error{natsStatus_GetText(status)};
  };
  natsConnection* connection = nullptr;
  must(natsConnection_ConnectTo(&connection, servers.url_list().c_str()));
  const std::unique_ptr<natsConnection, DestroyedBy<natsConnection_Destroy>> owned{connection};
  natsMsg* made = nullptr;
  must(natsMsg_Create(&made, subject.c_str(), nullptr, text.data(), static_cast<int>(text.size())));
  const NatsMessage message{made};
  for (const auto& [name, value] : headers) must(natsMsgHeader_Set(made, name.c_str(), value.c_str()));
  must(natsConnection_PublishMsg(connection, made));
  must(natsConnection_FlushTimeout(connection, 10'000));
}

}  // namespace

void publish_to_be_refused(const NatsServers& servers, const std::string& subject, std::string_view text) {
  send_with(servers, subject, {{"Nats-Expected-Last-Sequence", "999999"}}, text);
}

void send_as_stream(const NatsServers& servers, const std::string& subject, const std::string& stream,
                    std::uint64_t sequence, std::string_view text) {
  send_with(servers, subject,
            {{"Nats-Stream", stream},
             {"Nats-Sequence", std::to_string(sequence)},
             {"Nats-Time-Stamp", "2099-01-01T00:00:00Z"},
             {"Status", "404"}},
            text);
}

std::unique_ptr<JetStreamLog> open_log(const std::string& urls, const StreamNames& names,
                                       Credentials credentials) {
  auto log =
      JetStreamLog::open({urls_of(urls), names}, std::make_shared<const Credentials>(std::move(credentials)),
                         make_logger(std::getenv("TALUS_TEST_LOG") != nullptr ? "trace" : "off", "text"));
  if (!log) throw std::runtime_error{log.error().reason};
  return *std::move(log);
}

}  // namespace talus::nats_test
