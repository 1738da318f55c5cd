// Players' HTTP over a stream in memory, a scripted source of chunks, and a clock that the test moves.
#include "web/player_handler.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "access/access_control.h"
#include "clock/manual_clock.h"
#include "http/connection.h"
#include "loopback_stream.h"
#include "scratch_directory.h"
#include "scripted_source.h"
#include "session_limits_of_tests.h"
#include "web/columns_body.h"

#include <asio/executor_work_guard.hpp>

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

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
};

std::vector<Answer> answers_in(std::string_view text, bool heads_alone = false) {
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

struct Site {
  ManualClock clock{std::chrono::sys_seconds{1'700'000'000s}};
  ScriptedSource source;
  MemoryBudget memory{0};
  Metrics metrics;
  SessionLimits limits = test_limits(1U << 30);
  WorldInfo world{ContentHash{1, 2}, ContentHash{3, 4}, {}, {0, 256}, {}, "test",
                  {"meadow"},        {"temperature"}};
  FakeLand land;
  bool has_store = true;
  CurrentRates rates;
  FlowUses flows;
  Access access_settings;
  AccessControl access;
  Admission admission{{10, 2}, clock};
  Registry registry;
  ScriptedSource edited;  // what sessions are sent
  RunnerContext runner{{limits, world, edited, memory, metrics, access, rates, flows, clock},
                       {65'536, 1U << 20, {10s, 60s, 15s}},
                       registry,
                       std::make_shared<spdlog::logger>("silent")};
  http::Service service{clock, runner.log, {}, 60s, 10s, 15s};
  web::WebSettings settings;
  std::shared_ptr<const web::Site> site;
  std::atomic<std::uint64_t> answers{0};
  std::atomic<std::uint64_t> fetches{0};
  web::RecentRevisions recent_revisions;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  std::optional<web::WebContext> context;
  std::vector<std::shared_ptr<http::Connection<LoopbackStream>>> connections;
  bool through_proxy = false;

  explicit Site(Access of = {})
      : access_settings{std::move(of)}, access{access_settings, *load_keys(access_settings)} {}
  ~Site() {
    for (const auto& each : connections) each->close();
    io.poll();
  }

  std::shared_ptr<Loopback> connect() {
    if (!context) {
      context.emplace(
          web::WebContext{{RunnerContextPtr{}, &runner},
                          source,
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
                          std::make_shared<web::WorldDocument>(world, limits, has_store ? &land : nullptr)});
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

const std::string kChunks = "/v1/00000000000000020000000000000001/4";
const std::string kStore = "/v1/00000000000000020000000000000001/00000000000000040000000000000003";
const std::string kEdited = kStore + "/4";

ChunkKey key_at(std::int32_t x, std::int32_t y, std::int32_t z) {
  return {{x, y, z}, Lod{}};
}

Access with_secret(const ScratchDirectory& scratch) {
  Access access;
  access.secret_file = scratch.write("secret", "a secret of more than sixteen bytes\n");
  return access;
}
const std::string kToken = "Authorization: Bearer a secret of more than sixteen bytes\r\n";

}  // namespace

TEST_CASE("paths have chunks as generated, whatever sessions are sent") {
  Site site;
  const ChunkKey key{{1, 2, 3}, Lod{}};
  site.source.in_memory[key] = scripted_chunk(key);
  site.edited.in_memory[key] = scripted_chunk(key, 5, 50);
  const std::string path = "/v1/" + to_string(site.world.fingerprint) + "/4/0/1/2/3";
  CHECK(site.ask(path).body.size() == 100);
  CHECK(site.edited.submitted == 0);
}

TEST_CASE("a chunk in memory is answered at once, for every cache to keep") {
  Site site;
  const EncodedChunkPtr chunk = scripted_chunk(key_at(1, -2, 3));
  site.source.in_memory[key_at(1, -2, 3)] = chunk;
  const Answer answer = site.ask(kChunks + "/0/1/-2/3");
  CHECK(answer.status == 200);
  CHECK(answer.body.size() == chunk->payload().size());
  CHECK(std::equal(answer.body.begin(), answer.body.end(),
                   reinterpret_cast<const char*>(chunk->payload().data())));
  CHECK(answer.field("Cache-Control") == "public, max-age=31536000, immutable");
  CHECK(site.source.submitted == 0);
  const std::string etag = answer.field("ETag");
  const Answer same = site.ask(kChunks + "/0/1/-2/3", "If-None-Match: " + etag + "\r\n");
  CHECK(same.status == 304);
  CHECK(same.field("ETag") == etag);
  const Answer head = site.ask(kChunks + "/0/1/-2/3", "", "HEAD");
  CHECK(head.status == 200);
  CHECK(head.field("Content-Length") == "100");
}

TEST_CASE("a chunk that is not in memory is waited for, and those before it are not") {
  Site site;
  site.source.in_memory[key_at(0, 0, 0)] = scripted_chunk(key_at(0, 0, 0));
  const auto client = site.connect();
  client->send("GET " + kChunks + "/0/0/0/0 HTTP/1.1\r\nHost: a\r\n\r\nGET " + kChunks +
               "/0/5/0/5 HTTP/1.1\r\nHost: a\r\n\r\nGET " + kChunks + "/0/0/0/0 HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  CHECK(answers_in(client->text()).size() == 1);
  CHECK(site.source.waiting.size() == 1);
  site.answer_all();
  const auto all = answers_in(client->text());
  REQUIRE(all.size() == 3);
  for (const Answer& each : all) CHECK(each.status == 200);
}

TEST_CASE("who closes waits for nothing any more") {
  Site site;
  const auto client = site.connect();
  client->send("GET " + kChunks + "/0/5/0/5 HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  REQUIRE(site.source.waiting.size() == 1);
  site.connections.back()->close();
  site.io.poll();
  CHECK(site.source.waiting.empty());
  CHECK(site.admission.connections() == 0);
}

TEST_CASE("a full queue is waited for, and said when it stays full") {
  Site site;
  site.source.queue_places = 0;
  const auto client = site.connect();
  client->send("GET " + kChunks + "/0/5/0/5 HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  CHECK(client->received.empty());
  site.clock.advance(21s);
  site.source.last_mailbox->put(QueueHasRoom{});
  site.source.last_mailbox->wake();
  site.io.poll();
  const auto all = answers_in(client->text());
  REQUIRE(all.size() == 1);
  CHECK(all[0].status == 503);
  CHECK(all[0].field("Retry-After") == "1");
  CHECK(all[0].code() == "overloaded");
}

TEST_CASE("a column holds every chunk of the world once") {
  Site site;
  site.source.rows = {2, 4, MaterialId{3}};
  for (std::int32_t y = 1; y <= 5; ++y)
    site.source.in_memory[key_at(8, y, -4)] = scripted_chunk(key_at(8, y, -4));
  const Answer answer = site.ask(kChunks + "/0/8/-4");
  REQUIRE(answer.status == 200);
  const auto* at = reinterpret_cast<const unsigned char*>(answer.body.data());
  const auto number = [&](int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uint32_t{*at++} << (8 * i);
    return value;
  };
  CHECK(number(1) == 1);
  CHECK(number(1) == 0);
  const std::uint32_t runs = number(2);
  CHECK(runs == 5);
  std::int64_t next = -(std::int64_t{1} << 31);
  for (std::uint32_t run = 0; run < runs; ++run) {
    CHECK(static_cast<std::int32_t>(number(4)) == next);
    next += number(4);
    const std::uint32_t bytes = number(4);
    CHECK(bytes == 100);
    at += bytes;
  }
  CHECK(next == std::int64_t{1} << 31);
  CHECK(at == reinterpret_cast<const unsigned char*>(answer.body.data() + answer.body.size()));
}

TEST_CASE("a column has the same bytes however much is known of it") {
  // Rows 2 to 4 between rock and air.
  const auto body = [](MixedRows rows) {
    Site site;
    site.source.rows = rows;
    for (std::int32_t y = rows.first - 1; y <= rows.last + 1; ++y) {
      const ChunkKey like = key_at(0, y < 2 ? 1 : y > 4 ? 5 : y, 0);
      site.source.in_memory[key_at(8, y, -4)] = scripted_chunk(like);
    }
    const Answer answer = site.ask(kChunks + "/0/8/-4");
    CHECK(answer.status == 200);
    return answer.body;
  };
  const std::string exact = body({2, 4, MaterialId{3}});
  CHECK(exact.size() == 4 + 5 * (12 + 100));
  CHECK(body({-3, 9, MaterialId{3}}) == exact);
}

TEST_CASE("a square holds its columns row by row") {
  Site site;
  site.source.rows = {0, 0, MaterialId{3}};
  for (std::int32_t x = 2; x < 4; ++x) {
    for (std::int32_t z = -2; z < 0; ++z) {
      for (std::int32_t y = -1; y <= 1; ++y)
        site.source.in_memory[key_at(x, y, z)] = scripted_chunk(key_at(x, y, z));
    }
  }
  const Answer answer = site.ask(kChunks + "/0/2/-2/2x2");
  REQUIRE(answer.status == 200);
  const std::size_t column = 4 + 3 * (12 + 100);
  CHECK(answer.body.size() == 4 + 4 * (4 + column));
  CHECK(answer.body.substr(0, 4) == std::string("\x01\x02\x00\x00", 4));
  CHECK(site.ask(kChunks + "/0/3/-2/2x2").status == 404);
}

TEST_CASE("what is over 4 MiB has to be asked for chunk by chunk, a column as a square") {
  Site site;
  site.source.rows = {0, 39, MaterialId{3}};
  const auto fill = [&](std::size_t payload_bytes) {
    for (std::int32_t x = 0; x < 2; ++x) {
      for (std::int32_t z = 0; z < 2; ++z) {
        for (std::int32_t y = -1; y <= 40; ++y)
          site.source.in_memory[key_at(x, y, z)] = scripted_chunk(key_at(x, y, z), 0, payload_bytes);
      }
    }
  };
  const auto is_refused = [&](const std::string& path) {
    const Answer answer = site.ask(kChunks + path);
    if (answer.status == 200) return false;
    CHECK(answer.status == 400);
    CHECK(answer.code() == "too_large");
    CHECK_THAT(answer.body, Catch::Contains("this is over 4 MiB; ask for its chunks one by one"));
    return true;
  };
  fill((web::kMaxBodyBytes / 42) + 1);
  CHECK(is_refused("/0/0/0"));
  fill(web::kMaxBodyBytes / 42 - 100);  // a column is under it, two are not
  CHECK_FALSE(is_refused("/0/0/0"));
  CHECK(is_refused("/0/0/0/2x2"));
}

TEST_CASE("a chunk with edits is kept by every cache, and its path is that of its revision alone") {
  Site site;
  site.land.newest = 8;
  const ChunkKey key = key_at(1, -2, 3);
  site.edited.in_memory[key] = scripted_chunk(key, 7);
  const Answer answer = site.ask(kEdited + "/0/1/-2/3@7");
  CHECK(answer.status == 200);
  CHECK(answer.body.size() == 100);
  CHECK(answer.field("Cache-Control") == "public, max-age=31536000, immutable");
  CHECK(site.ask(kEdited + "/0/1/-2/3@7", "If-None-Match: " + answer.field("ETag") + "\r\n").status == 304);
  CHECK(site.ask(kEdited + "/0/1/-2/3@7", "", "HEAD").field("Content-Length") == "100");
  for (const char* const other : {"6", "8", "0"}) {
    const Answer moved = site.ask(kEdited + "/0/1/-2/3@" + other);
    CHECK(moved.status == 307);
    CHECK(moved.field("Location") == "3@7");
    CHECK(moved.field("Cache-Control") == "no-store");
    CHECK(moved.field("Access-Control-Allow-Origin") == "*");
    CHECK(moved.body.empty());
  }
  // What was never edited is of revision 0.
  const ChunkKey as_generated = key_at(1, -1, 3);
  site.edited.in_memory[as_generated] = scripted_chunk(as_generated);
  CHECK(site.ask(kEdited + "/0/1/-1/3@0").status == 200);
  CHECK(site.ask(kEdited + "/0/1/-1/3@7").field("Location") == "3@0");
}

namespace {

/// Of land that is edited just now: what is there, which no cache keeps.
void check_passing(const Answer& answer, const std::string& revision) {
  CHECK(answer.status == 200);
  CHECK(answer.field("Talus-Revision") == revision);
  CHECK(answer.field("Cache-Control") == "no-store");
  CHECK(answer.field("Access-Control-Expose-Headers") == "Talus-Revision");
  CHECK(answer.field("ETag").size() == 34);
  CHECK(answer.field("Location").empty());
}

}  // namespace

TEST_CASE("whoever edits a chunk, and however fast, who asks for it is redirected three times at most") {
  for (const bool column : {false, true}) {
    for (const auto between : {1ms, 100ms, 1000ms, 4900ms}) {
      Site site;
      site.edited.rows = {0, 0, MaterialId{3}};
      const ChunkKey key = key_at(1, 0, 3);
      for (const std::int32_t y : {-1, 1})
        site.edited.in_memory[key_at(1, y, 3)] = scripted_chunk(key_at(1, y, 3));
      site.land.newest = 40;
      std::uint64_t revision = 7;
      const std::string base = kEdited + (column ? "/0/1/3@" : "/0/1/0/3@");
      std::string asked = "1";
      int redirections = 0;
      for (;; ++redirections) {
        REQUIRE(redirections <= 3);
        site.edited.in_memory[key] = scripted_chunk(key, revision);
        site.land.columns[key_at(1, 0, 3)] = revision;
        site.land.newest = std::max(site.land.newest, revision);
        const Answer answer = site.ask(base + asked);
        if (answer.status == 200) {
          check_passing(answer, std::to_string(revision));
          break;
        }
        REQUIRE(answer.status == 307);
        const std::string location = answer.field("Location");
        asked = location.substr(location.find('@') + 1);
        site.clock.advance(between);
        revision = site.land.newest + 1;
      }
      // When nobody edits any more, its path is that of its revision, for every cache.
      CHECK(site.ask(base + std::to_string(revision)).field("Talus-Revision").empty());
      site.clock.advance(web::RecentRevisions::kSpan);
      (void)site.ask(base + "1");
      site.clock.advance(web::RecentRevisions::kSpan);
      CHECK(site.ask(base + asked).status == 307);
    }
  }
}

TEST_CASE("a chunk of just now has the fields of one that needs a token, and a 304 for who has its bytes") {
  const ScratchDirectory scratch;
  Site site{with_secret(scratch)};
  const ChunkKey key = key_at(1, -2, 3);
  site.land.newest = 7;
  site.edited.in_memory[key] = scripted_chunk(key, 7);
  CHECK(site.ask(kEdited + "/0/1/-2/3@6", kToken).status == 307);
  site.land.newest = 9;
  site.edited.in_memory[key] = scripted_chunk(key, 9);
  const Answer answer = site.ask(kEdited + "/0/1/-2/3@8", kToken);
  CHECK(answer.status == 200);
  CHECK(answer.field("Cache-Control") == "private, no-store");
  CHECK(answer.field("Talus-Revision") == "9");
  const Answer same = site.ask(kEdited + "/0/1/-2/3@8",
                               std::string{kToken} + "If-None-Match: " + answer.field("ETag") + "\r\n");
  CHECK(same.status == 304);
  CHECK(same.field("Talus-Revision") == "9");
}

TEST_CASE("a chunk that is edited while it is waited for comes as it is then") {
  Site site;
  const ChunkKey key = key_at(1, -2, 3);
  site.edited.revisions[key] = 7;
  for (const std::uint64_t comes : {7, 8}) {
    const auto client = site.connect();
    client->send("GET " + kEdited + "/0/1/-2/3@7 HTTP/1.1\r\nHost: a\r\n\r\n");
    site.io.poll();
    REQUIRE(site.edited.waiting.size() == 1);
    CHECK(site.source.waiting.empty());
    const MailboxPtr mailbox = site.edited.waiting.at(key);
    site.edited.mail(key, scripted_chunk(key, comes));
    mailbox->wake();
    site.io.poll();
    const auto all = answers_in(client->text());
    REQUIRE(all.size() == 1);
    CHECK(all[0].status == 200);
    if (comes == 8) check_passing(all[0], "8");
    if (comes == 7) CHECK(all[0].field("Cache-Control") == "public, max-age=31536000, immutable");
    if (comes == 7) CHECK(all[0].field("Talus-Revision").empty());
  }
}

TEST_CASE("a column with edits has the rows that were edited, and the greatest revision of its chunks") {
  Site site;
  site.land.newest = 9;
  site.edited.rows = {2, 7, MaterialId{3}};  // of which 7 was edited, far above the land
  for (std::int32_t y = 1; y <= 8; ++y) {
    site.edited.in_memory[key_at(8, y, -4)] = scripted_chunk(key_at(8, y, -4), y == 7 ? 9 : y == 3 ? 5 : 0);
  }
  site.land.columns[key_at(8, 0, -4)] = 9;
  const Answer answer = site.ask(kEdited + "/0/8/-4@9");
  REQUIRE(answer.status == 200);
  CHECK(answer.body.size() == 4 + 8 * (12 + 100));
  CHECK(answer.field("Cache-Control") == "public, max-age=31536000, immutable");
  const Answer moved = site.ask(kEdited + "/0/8/-4@5");
  CHECK(moved.status == 307);
  CHECK(moved.field("Location") == "-4@9");
  CHECK(site.source.submitted == 0);
}

TEST_CASE("where nothing is known of a column with edits, it has all rows that were edited") {
  Site site;
  site.edited.rows = {};
  for (std::int32_t y = -30; y <= 30; ++y) {
    site.edited.in_memory[key_at(8, y, -4)] =
        scripted_chunk(key_at(8, y == 20 ? 20 : 0, -4), y == 20 ? 9 : 0, y == 20 ? 50 : 100);
  }
  site.land.columns[key_at(8, 0, -4)] = 9;
  site.land.rows = {20, 20};
  const Answer answer = site.ask(kEdited + "/0/8/-4@9");
  REQUIRE(answer.status == 200);
  CHECK(answer.body.size() == 4 + 3 * 12 + 100 + 50 + 100);
}

TEST_CASE("a column that is edited while it is fetched comes as of before, and is kept by no cache") {
  for (const bool index_knows : {false, true}) {
    Site site;
    site.edited.rows = {2, 4, MaterialId{3}};
    for (std::int32_t y = 1; y <= 5; ++y)
      site.edited.in_memory[key_at(8, y, -4)] = scripted_chunk(key_at(8, y, -4), y == 3 ? 5 : 0);
    site.edited.revisions[key_at(8, 3, -4)] = 6;  // not in memory
    site.land.columns[key_at(8, 0, -4)] = 5;
    const auto client = site.connect();
    client->send("GET " + kEdited + "/0/8/-4@5 HTTP/1.1\r\nHost: a\r\n\r\n");
    site.io.poll();
    REQUIRE(site.edited.waiting.size() == 1);
    const MailboxPtr mailbox = site.edited.waiting.begin()->second;
    // Either the chunk is newer, or another chunk was edited, which came before.
    site.edited.mail(key_at(8, 3, -4), scripted_chunk(key_at(8, 3, -4), index_knows ? 5 : 6));
    if (index_knows) site.land.columns[key_at(8, 0, -4)] = 6;
    mailbox->wake();
    site.io.poll();
    const auto all = answers_in(client->text());
    REQUIRE(all.size() == 1);
    check_passing(all[0], "5");
  }
}

TEST_CASE("a square with edits is of the greatest revision of its columns") {
  Site site;
  site.edited.rows = {0, 0, MaterialId{3}};
  for (std::int32_t x = 2; x < 4; ++x) {
    for (std::int32_t z = -2; z < 0; ++z) {
      for (std::int32_t y = -1; y <= 1; ++y)
        site.edited.in_memory[key_at(x, y, z)] = scripted_chunk(key_at(x, y, z), y == 0 && x == 3 ? 3 : 0);
    }
  }
  site.land.columns[key_at(3, 0, -1)] = 3;
  site.land.newest = 3;
  CHECK(site.ask(kEdited + "/0/2/-2/2x2@3").status == 200);
  CHECK(site.ask(kEdited + "/0/2/-2/2x2@2").field("Location") == "2x2@3");
  CHECK(site.ask(kEdited + "/0/2/-2/1x1@3").field("Location") == "1x1@0");
}

TEST_CASE("the edited columns of a region are told, to be asked for again each time") {
  Site site;
  CHECK(site.ask(kStore + "/edits/0/-1/0").body == std::string("\x01\x00\x00\x00", 4));
  site.land.region = {{5, 7}, {1023, 0x1'0000'0001}};
  const Answer answer = site.ask(kStore + "/edits/0/-1/0");
  CHECK(answer.status == 200);
  CHECK(answer.body == std::string("\x01\x00\x02\x00"
                                   "\x05\x00\x07\x00\x00\x00\x00\x00\x00\x00"
                                   "\xff\x03\x01\x00\x00\x00\x01\x00\x00\x00",
                                   24));
  CHECK(answer.field("Cache-Control") == "no-cache");
  CHECK(answer.field("Access-Control-Allow-Origin") == "*");
  const std::string has = "If-None-Match: " + answer.field("ETag") + "\r\n";
  CHECK(site.ask(kStore + "/edits/0/-1/0", has).status == 304);
  CHECK(site.ask(kStore + "/edits/0/-1/0", "", "HEAD").field("Content-Length") == "24");
  site.land.region[0].revision = 8;
  CHECK(site.ask(kStore + "/edits/0/-1/0", has).status == 200);
}

TEST_CASE("the edited columns of a region count in the rates of bytes, however often they are asked for") {
  Site site;
  for (std::uint16_t place = 0; place < 1024; ++place) site.land.region.push_back({place, 7});
  constexpr std::size_t kBytes = 4 + 1024 * 10;
  site.rates.set({{{}, {kBytes, kBytes}, {}}, {}, 1s});
  const auto client = site.connect();
  // A client may owe as much as a burst.
  CHECK(site.ask(*client, kStore + "/edits/0/-1/0").body.size() == kBytes);
  int answered = 0;
  while (site.ask(*client, kStore + "/edits/0/-1/0").status == 200) REQUIRE(++answered < 5);
  CHECK(site.metrics.throttled(RateKind::session_bytes).total() > 0);
  site.clock.advance(5s);
  CHECK(site.ask(*client, kStore + "/edits/0/-1/0").status == 200);
}

TEST_CASE("paths of another store of edits are none, as all of them where none are stored") {
  for (const bool stored : {false, true}) {
    Site site;
    site.has_store = stored;
    const std::string other =
        stored ? "/v1/00000000000000020000000000000001/00000000000000000000000000000000" : kStore;
    for (const char* const path : {"/4/0/1/2/3@0", "/4/0/1/3@0", "/4/0/4/4/4x4@0", "/edits/0/0/0"}) {
      const Answer answer = site.ask(other + path);
      CHECK(answer.status == 404);
      CHECK(answer.code() == "out_of_range");
      CHECK_THAT(answer.body,
                 Catch::Contains(stored ? "00000000000000040000000000000003" : "stores no edits"));
    }
  }
}

TEST_CASE("who gets chunks as generated gets those with edits") {
  const ScratchDirectory scratch;
  for (const bool chunks_are_public : {false, true}) {
    Site site{with_secret(scratch)};
    site.settings.public_chunks = chunks_are_public;
    const ChunkKey key = key_at(0, 0, 0);
    site.edited.in_memory[key] = scripted_chunk(key, 2);
    for (const auto& path : {kEdited + "/0/0/0/0@2", kEdited + "/0/0/0/0@1", kStore + "/edits/0/0/0"}) {
      const Answer without = site.ask(path);
      CHECK((without.status == 401) != chunks_are_public);
      const Answer with = site.ask(path, kToken);
      CHECK(with.status < 400);
      CHECK(with.field("Access-Control-Allow-Origin") == (chunks_are_public ? "*" : ""));
      if (!chunks_are_public) CHECK_THAT(with.field("Cache-Control"), Catch::Contains("no-store"));
    }
    if (chunks_are_public) CHECK(site.ask(kStore + "/edits/0/0/0").field("Cache-Control") == "no-cache");
  }
}

TEST_CASE("the world tells of its edits") {
  Site site;
  const auto told = [&] { return nlohmann::json::parse(site.ask("/v1/world").body)["edits"]; };
  CHECK(told() == nlohmann::json{{"taken", true}, {"revision", 0}});
  const std::string tag = site.ask("/v1/world").field("ETag");
  site.land.newest = 5;
  site.land.taken = false;
  CHECK(told() == nlohmann::json{{"taken", false}, {"revision", 5}});
  CHECK(site.ask("/v1/world", "If-None-Match: " + tag + "\r\n").status == 200);
  Site without;
  without.has_store = false;
  CHECK(nlohmann::json::parse(without.ask("/v1/world").body)["edits"] ==
        nlohmann::json{{"taken", false}, {"revision", 0}});
}

TEST_CASE("another world and another codec are named") {
  Site site;
  CHECK_THAT(site.ask("/v1/ffff/4/0/0/0/0").body, Catch::Contains("00000000000000020000000000000001"));
  CHECK(site.ask("/v1/00000000000000020000000000000001/3/0/0/0/0").code() == "version");
}

TEST_CASE("the world is described, and its description has a tag") {
  Site site;
  const Answer answer = site.ask("/v1/world");
  CHECK(answer.status == 200);
  const auto world = nlohmann::json::parse(answer.body);
  CHECK(world["fingerprint"] == "00000000000000020000000000000001");
  CHECK(world["looks"][0] == "meadow");
  CHECK(site.ask("/v1/world", "If-None-Match: " + answer.field("ETag") + "\r\n").status == 304);
}

TEST_CASE("a stream that is asked for in HTTP/1.0 is none: 426, and the connection closes") {
  Site site;
  const auto client = site.connect();
  client->send(
      "GET /v1/stream HTTP/1.0\r\nHost: a\r\nConnection: Upgrade, keep-alive\r\nUpgrade: websocket\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
      "GET /v1/world HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  const auto all = answers_in(client->text());
  REQUIRE(all.size() == 1);
  CHECK(all[0].status == 426);
  CHECK(all[0].field("Connection") == "Upgrade, close");
  CHECK(all[0].field("Upgrade") == "websocket");
  CHECK(client->shut);
}

TEST_CASE("where a token is needed, no cache keeps a chunk unless chunks are public") {
  const ScratchDirectory scratch;
  for (const bool chunks_are_public : {false, true}) {
    Site site{with_secret(scratch)};
    site.settings.public_chunks = chunks_are_public;
    site.source.in_memory[key_at(0, 0, 0)] = scripted_chunk(key_at(0, 0, 0));
    const Answer without = site.ask(kChunks + "/0/0/0/0");
    CHECK(without.status == (chunks_are_public ? 200 : 401));
    if (!chunks_are_public) {
      CHECK(without.field("WWW-Authenticate") == "Bearer");
      CHECK(without.field("Cache-Control") == "no-store");
      CHECK(without.code() == "unauthorized");
      const Answer with = site.ask(kChunks + "/0/0/0/0", kToken);
      CHECK(with.status == 200);
      CHECK(with.field("Cache-Control") == "private, no-store");
    }
    CHECK(site.ask("/v1/world").status == 401);
    CHECK(site.ask("/v1/world", kToken).status == 200);
    CHECK(site.ask("/v1/world", "Authorization: Bearer wrong\r\n").status == 401);
  }
}

TEST_CASE("requests over the rate are told when there is room") {
  Site site;
  site.rates.set({{{}, {}, {2, 2}}, {}, 1s});
  const auto client = site.connect();
  CHECK(site.ask(*client, "/v1/world").status == 200);
  CHECK(site.ask(*client, "/v1/world").status == 200);
  const Answer refused = site.ask(*client, "/v1/world");
  CHECK(refused.status == 429);
  CHECK(refused.field("Retry-After") == "1");
  CHECK(refused.code() == "overloaded");
  site.clock.advance(2s);
  CHECK(site.ask(*client, "/v1/world").status == 200);
}

TEST_CASE("a proxy's requests count as those whom it names") {
  Site site;
  site.through_proxy = true;
  site.settings.proxies = *Networks::parse("127.0.0.1");
  const auto client = site.connect();
  CHECK(site.ask(*client, "/v1/world").status == 400);
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: 192.0.2.1\r\n").status == 200);
  // An address takes two connections here, and has a place as long as its request is answered.
  const auto wait_for_chunk = [&](std::int32_t x) {
    auto waiting = site.connect();
    waiting->send("GET " + kChunks + "/0/" + std::to_string(x) +
                  "/0/0 HTTP/1.1\r\nHost: a\r\nX-Forwarded-For: 192.0.2.1\r\n\r\n");
    site.io.poll();
    return waiting;
  };
  const auto a = wait_for_chunk(5);
  const auto b = wait_for_chunk(6);
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: 192.0.2.1\r\n").status == 503);
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: 192.0.2.2\r\n").status == 200);
  site.answer_all();
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: 192.0.2.1\r\n").status == 200);
}

TEST_CASE("what a client writes itself before a proxy's X-Forwarded-For names nobody") {
  Site site;
  site.through_proxy = true;
  site.settings.proxies = *Networks::parse("127.0.0.1");
  const auto forging = [](int n) {
    return "X-Forwarded-For: 192.0.2.10" + std::to_string(n) + "\r\nX-Forwarded-For: 192.0.2.1\r\n";
  };
  // An address takes two connections here.
  std::vector<std::shared_ptr<Loopback>> waiting;
  for (const int n : {1, 2}) {
    waiting.push_back(site.connect());
    waiting.back()->send("GET " + kChunks + "/0/" + std::to_string(n) + "/0/0 HTTP/1.1\r\nHost: a\r\n" +
                         forging(n) + "\r\n");
    site.io.poll();
  }
  CHECK(site.ask(*site.connect(), "/v1/world", forging(3)).status == 503);
}

TEST_CASE("whatever is answered counts as a request") {
  const std::string region = kStore + "/edits/0/-1/0";
  for (const std::string& target : {std::string{"/v1/world"}, std::string{"/v1/nothing"},
                                    std::string{"/v1/heights?columns=x"}, std::string{"/"}, region}) {
    Site each;
    each.rates.set({{{}, {}, {1, 1}}, {}, 1s});
    const auto client = each.connect();
    (void)each.ask(*client, target);
    CHECK(each.ask(*client, target).status == 429);
  }
  const ScratchDirectory scratch;
  Site site{with_secret(scratch)};
  site.rates.set({{{}, {}, {1, 1}}, {}, 1s});
  const auto client = site.connect();
  CHECK(site.ask(*client, "/v1/world", "Authorization: Bearer wrong\r\n").status == 401);
  CHECK(site.ask(*client, "/v1/world", "Authorization: Bearer wrong\r\n").status == 429);
}

TEST_CASE("who hangs up while its chunk is made waits for nothing any more") {
  Site site;
  const auto client = site.connect();
  client->send("GET " + kChunks + "/0/5/0/5 HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  REQUIRE(site.source.waiting.size() == 1);
  client->hung_up = true;
  site.connections.back()->clock_moved();
  site.io.poll();
  CHECK(site.source.waiting.empty());
  CHECK(site.admission.connections() == 0);
}

TEST_CASE("what every cache may keep is one copy that any page may read") {
  Site site;
  site.source.in_memory[key_at(0, 0, 0)] = scripted_chunk(key_at(0, 0, 0));
  for (const char* const fields : {"", "Origin: https://b.example\r\n"}) {
    const Answer chunk = site.ask(kChunks + "/0/0/0/0", fields);
    CHECK(chunk.field("Access-Control-Allow-Origin") == "*");
    CHECK(chunk.field("Vary").empty());
  }
}

TEST_CASE("pages of other hosts read only where they are listed") {
  Site site;
  CHECK(site.ask("/v1/world", "Origin: https://a.example\r\n").field("Access-Control-Allow-Origin") ==
        "https://a.example");
  CHECK(site.ask("/v1/world", "Origin: https://b.example\r\n").field("Access-Control-Allow-Origin").empty());
  CHECK(site.ask("/v1/stream", "Origin: https://b.example\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n")
            .status == 403);
  CHECK(site.ask("/v1/stream").status == 426);
  const Answer before = site.ask("/v1/world", "Origin: https://a.example\r\n", "OPTIONS");
  CHECK(before.status == 204);
  CHECK(before.field("Access-Control-Allow-Headers") == "Authorization");
  CHECK(site.ask("/v1/world", "", "POST").status == 405);
  Site open;
  open.settings.origins = *AllowedOrigins::parse("*");
  const Answer all = open.ask("/v1/world", "Origin: https://b.example\r\n");
  CHECK(all.field("Access-Control-Allow-Origin") == "*");
  CHECK(all.field("Vary").empty());
}

TEST_CASE("files beside /v1 need no token, and count in the rates as all requests and bytes do") {
  const ScratchDirectory scratch;
  const ScratchDirectory dist;
  const std::string page(100'000, 'x');
  dist.write("index.html", page);
  Site site{with_secret(scratch)};
  site.site = *web::Site::read(dist.path());
  site.rates.set({{{}, {150'000, 150'000}, {}}, {}, 1s});
  const auto client = site.connect();
  CHECK(site.ask(*client, "/", "", "HEAD").field("Content-Length") == "100000");
  // A client may owe as much as a burst.
  for (int i = 0; i < 5; ++i) {
    const Answer answer = site.ask(*client, "/", "Origin: https://a.example\r\n");
    if (i < 4) {
      CHECK(answer.status == 200);
      CHECK(answer.body == page);
      CHECK(answer.field("Access-Control-Allow-Origin").empty());
      CHECK(answer.field("Vary").empty());
    } else {
      CHECK(answer.status == 429);
    }
  }
  CHECK(site.ask("/v1/world").status == 401);
  CHECK(site.ask("/", "", "POST").status == 405);
}

TEST_CASE("heights are written where they are made, as JSON or as an array") {
  Site site;
  const auto client = site.connect();
  const auto answer_to = [&](const std::string& target) {
    client->send("GET " + target + " HTTP/1.1\r\nHost: a\r\n\r\n");
    site.io.poll();
    REQUIRE(site.source.waiting_heights.size() == 1);
    const auto [ticket, mailbox] = *site.source.waiting_heights.begin();
    site.source.answer_heights(ticket);  // the source writes them, as the generators do
    mailbox->wake();
    site.io.poll();
    Answer answer = answers_in(client->text()).back();
    CHECK(answer.status == 200);
    return answer;
  };
  const Answer list = answer_to("/v1/heights?columns=1,2;3,4");
  CHECK(list.field("Content-Type") == "application/json");
  CHECK(list.body == "{\"subvoxels_per_voxel\":256,\"heights\":[256,256]}\n");
  const Answer grid = answer_to("/v1/heights?x=0&z=0&w=2&h=1&step=1");
  CHECK(grid.body == "{\"subvoxels_per_voxel\":256,\"w\":2,\"h\":1,\"heights\":[256,256]}\n");
  const Answer array = answer_to("/v1/heights?x=0&z=0&w=2&h=1&step=1&format=npy");
  CHECK(array.field("Content-Type") == "application/octet-stream");
  CHECK(array.body.substr(0, 6) == "\x93NUMPY");
  CHECK(array.body.substr(array.body.size() - 8) == std::string("\0\1\0\0\0\1\0\0", 8));
}

TEST_CASE("a tile of the map is drawn once in the client's turn, and kept by every cache") {
  Site site;
  const std::string path = "/v1/00000000000000020000000000000001/map/8/-1/2.png";
  const auto client = site.connect();
  client->send("GET " + path + " HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  CHECK(client->received.empty());
  REQUIRE(site.source.waiting_maps.size() == 1);
  CHECK(site.source.waiting_maps.begin()->second == map::Tile{8, -1, 2});
  site.source.answer_map(site.source.waiting_maps.begin()->first);
  site.io.poll();
  const auto all = answers_in(client->text());
  REQUIRE(all.size() == 1);
  CHECK(all[0].status == 200);
  CHECK(all[0].body == "a map");
  CHECK(all[0].field("Content-Type") == "image/png");
  CHECK(all[0].field("Cache-Control") == "public, max-age=31536000, immutable");
  site.source.drawn = map::Tile{8, -1, 2};
  const Answer again = site.ask(path);
  CHECK(again.body == "a map");
  CHECK(site.ask(path, "If-None-Match: " + again.field("ETag") + "\r\n").status == 304);
  CHECK(site.ask("/v1/ffff/map/8/-1/2.png").status == 404);
}

TEST_CASE("who leaves has no map drawn, and a map counts for what it costs") {
  Site site;
  site.rates.set({{{100, 100}, {}, {}}, {}, 1s});
  const std::string path = "/v1/00000000000000020000000000000001/map/8/0/0.png";
  const auto client = site.connect();
  client->send("GET " + path + " HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  REQUIRE(site.source.waiting_maps.size() == 1);
  site.connections.back()->close();
  site.io.poll();
  CHECK(site.source.waiting_maps.empty());
  const auto greedy = site.connect();
  for (int i = 0; i < 2; ++i) {
    greedy->send("GET " + path + " HTTP/1.1\r\nHost: a\r\n\r\n");
    site.io.poll();
    REQUIRE(site.source.waiting_maps.size() == 1);
    site.source.answer_map(site.source.waiting_maps.begin()->first);
    site.io.poll();
  }
  // 128 of 100 are gone.
  greedy->send("GET " + path + " HTTP/1.1\r\nHost: a\r\n\r\n");
  site.io.poll();
  CHECK(site.source.waiting_maps.empty());
}
