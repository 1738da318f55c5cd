// Players' HTTP over a stream in memory, a scripted source of chunks, and a clock that the test moves.
#pragma once

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/access/access_control.h"
#include "loopback_stream.h"
#include "net/http/connection.h"
#include "runtime/manual_clock.h"
#include "scratch_directory.h"
#include "scripted_source.h"
#include "session_limits_of_tests.h"
#include "web/player_handler.h"
#include "web/world_files.h"

#include <asio/executor_work_guard.hpp>

namespace talus::server {

using namespace std::chrono_literals;

struct Answer {
  int status = 0;
  std::string head;
  std::string body;

  [[nodiscard]] std::string field(const std::string& name) const {
    const std::size_t at = head.find("\r\n" + name + ": ");
    if (at == std::string::npos) return "";
    const std::size_t from = at + name.size() + 4;
    return head.substr(from, head.find("\r\n", from) - from);
  }
  [[nodiscard]] std::string code() const { return nlohmann::json::parse(body)["error"]["code"]; }
  [[nodiscard]] std::string text() const { return nlohmann::json::parse(body)["error"]["text"]; }
};

inline std::vector<Answer> answers_in(std::string_view text, bool heads_alone = false) {
  std::vector<Answer> all;
  while (!text.empty()) {
    Answer answer;
    const std::size_t end = text.find("\r\n\r\n");
    REQUIRE(end != std::string_view::npos);
    answer.head = text.substr(0, end + 2);
    answer.status = std::stoi(answer.head.substr(9, 3));
    text.remove_prefix(end + 4);
    if (!heads_alone && !answer.field("Content-Length").empty()) {
      answer.body = text.substr(0, std::stoul(answer.field("Content-Length")));
      text.remove_prefix(answer.body.size());
    }
    all.push_back(answer);
  }
  return all;
}

/// Which land was edited, as a test says.
struct FakeLand final : EditedLand {
  std::uint64_t newest = 0;
  bool taken = true;
  std::map<ChunkKey, std::uint64_t> columns;  // by the key of row 0
  ChunkRange rows;                            // of all of them
  std::vector<EditedColumn> region;           // of every region

  std::uint64_t revision() const override { return newest; }
  bool takes_edits() const override { return taken; }
  std::uint64_t column_revision(ChunkKey key) const override {
    const auto found = columns.find({{key.coord.x, 0, key.coord.z}, key.lod});
    return found == columns.end() ? 0 : found->second;
  }
  ChunkRange edited_rows(ChunkKey key) const override {
    return column_revision(key) == 0 ? ChunkRange{} : rows;
  }
  std::vector<EditedColumn> edited_columns(ChunkKey) const override { return region; }
};

/// Two scripted sources: one for each version of chunks.
class SourceOfVersions final : public ChunkSource {
 public:
  SourceOfVersions(ScriptedSource& generated, ScriptedSource& edited)
      : generated_{generated}, edited_{edited} {}

  EncodedChunkPtr find(ChunkKey key, Version version) override { return of(version).find(key, version); }
  EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override {
    return edited_.newer(key, revision);
  }
  std::uint64_t revision(ChunkKey key) const override { return edited_.revision(key); }
  MixedRows column(ChunkKey key, Version version) override { return of(version).column(key, version); }
  int columns_together() const override { return generated_.columns_together(); }
  std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency urgency,
                     Version version) override {
    return of(version).submit(mailbox, keys, urgency, version);
  }
  void hasten(ClientId, std::span<const ChunkKey>) override {}
  void cancel(ClientId client, std::span<const ChunkKey> keys) override {
    generated_.cancel(client, keys);
    edited_.cancel(client, keys);
  }
  void set_wanted(const MailboxPtr&, std::span<const LevelBox>) override {}
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) override {
    generated_.submit_heights(mailbox, ticket, std::move(query));
  }
  void cancel_heights(ClientId client, std::uint64_t ticket) override {
    generated_.cancel_heights(client, ticket);
  }
  PicturePtr find_map(const map::Tile& tile) override { return generated_.find_map(tile); }

 private:
  ScriptedSource& of(Version version) { return version == Version::edited ? edited_ : generated_; }
  ScriptedSource& generated_;
  ScriptedSource& edited_;
};

struct PlayerSite {
  ManualClock clock{std::chrono::sys_seconds{1'700'000'000s}};
  ScriptedSource source;  // as generated
  MemoryBudget memory{0};
  Metrics metrics;
  SessionLimits limits = test_limits(1U << 30);
  WorldInfo world{ContentHash{1, 2},
                  ContentHash{3, 4},
                  {},
                  {0, 256},
                  {},
                  "test",
                  {"meadow"},
                  {"temperature", "red rock", "a,b"}};
  FakeLand land;
  bool has_store = true;
  CurrentRates rates;
  FlowUses flows;
  Access access_settings;
  AccessControl access;
  Admission admission{{10, 2}, clock};
  Registry registry;
  ScriptedSource edited;
  SourceOfVersions both{source, edited};
  RunnerContext runner{{limits, world, both, memory, metrics, access, rates, flows, clock},
                       {65'536, 1U << 20, {10s, 60s, 15s}},
                       registry,
                       make_logger("off", "text")};
  http::Service service{clock, runner.log, {}, 60s, 10s, 15s};
  web::WebSettings settings;
  std::shared_ptr<const web::Site> site;
  std::shared_ptr<const web::WorldFiles> world_files;
  std::atomic<std::uint64_t> answers{0};
  std::atomic<std::uint64_t> fetches{0};
  web::RecentRevisions recent_revisions;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  std::optional<web::WebContext> context;
  std::vector<std::shared_ptr<http::Connection<LoopbackStream>>> connections;
  bool through_proxy = false;

  explicit PlayerSite(Access of = {})
      : access_settings{std::move(of)}, access{access_settings, *load_keys(access_settings)} {}
  ~PlayerSite() {
    for (const auto& each : connections) each->close();
    io.poll();
  }

  std::shared_ptr<Loopback> connect() {
    if (!context) {
      context.emplace(
          web::WebContext{{RunnerContextPtr{}, &runner},
                          has_store ? &land : nullptr,
                          settings,
                          admission,
                          service,
                          to_string(world.fingerprint),
                          to_string(world.store_id),
                          answers,
                          fetches,
                          recent_revisions,
                          site,
                          std::make_shared<web::WorldDocument>(world, limits, has_store ? &land : nullptr),
                          world_files});
    }
    auto client = std::make_shared<Loopback>(io);
    const auto address = asio::ip::address_v4::loopback();
    auto slot = through_proxy ? admission.enter_proxy(address) : admission.enter(address);
    const auto handler = std::make_shared<web::PlayerHandler>(
        web::WebContextPtr{web::WebContextPtr{}, &*context},
        ConnectionInfo{connections.size() + 1, "test", clock.now(), through_proxy}, *std::move(slot),
        io.get_executor());
    connections.push_back(std::make_shared<http::Connection<LoopbackStream>>(LoopbackStream{client},
                                                                             context->service, handler));
    connections.back()->start();
    io.poll();
    return client;
  }
  Answer ask(Loopback& client, const std::string& target, const std::string& fields = "",
             const std::string& method = "GET") {
    client.received.clear();
    client.send(method + " " + target + " HTTP/1.1\r\nHost: a.example\r\n" + fields + "\r\n");
    io.poll();
    if (client.received.empty()) return {};
    const auto all = answers_in(client.text(), method == "HEAD");
    REQUIRE(all.size() == 1);
    return all[0];
  }
  Answer ask(const std::string& target, const std::string& fields = "", const std::string& method = "GET") {
    const auto client = connect();
    Answer answer = ask(*client, target, fields, method);
    connections.back()->close();
    io.poll();
    return answer;
  }
  void answer_all() { answer_all(source); }
  void answer_all(ScriptedSource& of) {
    const auto waiting = of.waiting;
    of.answer_all();
    for (const auto& [key, mailbox] : waiting) mailbox->wake();
    io.poll();
  }
};

inline const std::string kChunks = "/v1/00000000000000020000000000000001/4";
inline const std::string kStore = "/v1/00000000000000020000000000000001/00000000000000040000000000000003";
inline const std::string kEdited = kStore + "/4";

inline ChunkKey key_at(std::int32_t x, std::int32_t y, std::int32_t z) {
  return {{x, y, z}, Lod{}};
}

inline Access with_secret(const ScratchDirectory& scratch) {
  Access access;
  access.secret_file = scratch.write("secret", "a secret of more than sixteen bytes\n");
  return access;
}
inline const std::string kToken = "Authorization: Bearer a secret of more than sixteen bytes\r\n";

}  // namespace talus::server
