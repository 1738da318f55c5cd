#include "app/settings.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <talus/protocol/limits.h>

#include "admin/admin_server.h"
#include "app/readiness.h"
#include "chunks/generation/patch.h"
#include "config/fields.h"
#include "edits/local_log.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

/// The default world, eroded in so many steps.
terrain::World eroded(int steps) {
  std::ifstream in{TALUS_SOURCE_DIR "/core/worlds/classic.toml"};
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  const std::string method = "method = \"erosion\"\nerosion_steps = " + std::to_string(steps) + "\n";
  auto world = terrain::World::parse(method + text, "test.toml", nullptr);
  INFO((world ? std::string{} : world.error().message));
  REQUIRE(world.has_value());
  return *std::move(world);
}

}  // namespace

TEST_CASE("pages of the same machine may read from a server that only this machine reaches") {
  Config config;
  const auto allows = [&](const std::string& host) {
    config.http.listen = protocol::Endpoint{host, 4782};
    return web_settings(config).origins.allow("http://localhost:5173", host);
  };
  for (const char* const host : {"127.0.0.1", "localhost", "::1"}) CHECK(allows(host));
  for (const char* const host : {"0.0.0.0", "::", "192.168.0.2", "play.example"}) CHECK_FALSE(allows(host));
  config.proxies = *Networks::parse("127.0.0.1");
  CHECK_FALSE(allows("127.0.0.1"));
}

TEST_CASE("an HTTP client of the port for game clients learns where the viewer is") {
  Config config;
  CHECK_THAT(http_place(config), Catch::EndsWith("talusd serves the viewer with --http HOST:PORT --web DIR"));
  config.http.listen = protocol::Endpoint{"0.0.0.0", 4782};
  CHECK_THAT(http_place(config), Catch::EndsWith("HTTP is at http://HOST:4782/"));
  config.http.web = "dist";
  config.tls.certificate = "chain.pem";
  CHECK_THAT(http_place(config), Catch::EndsWith("the viewer is at https://HOST:4782/"));
  config.http.listen->port = 0;
  CHECK_THAT(http_place(config), Catch::EndsWith("https://HOST:PORT, which talusd's log names"));
}

TEST_CASE("every edge of a patch that can be configured is one that patches may have") {
  const Field& field = *find_field("generation.patch_tiles");
  std::vector<int> edges;
  for (int tiles = -1; tiles <= 64; ++tiles) {
    Config config;
    if (!set_from_number(field, config, tiles)) continue;
    const int edge = measured_patch_size(config, terrain::default_world(), SystemClock{}).tiles;
    edges.push_back(edge);
    CHECK(is_patch_edge(edge));
  }
  REQUIRE(edges.size() == 6);  // the first is of 0, and measured
  CHECK(std::vector(edges.begin() + 1, edges.end()) == std::vector{1, 2, 4, 8, 16});
  for (const int tiles : {-4, 0, 3, 5, 6, 12}) CHECK_FALSE(is_patch_edge(tiles));
}

TEST_CASE("heights of the slope method are limited by their number alone") {
  const auto classic = terrain::World::parse(terrain::classic_world_toml(), "classic.toml").value();
  CHECK(height_tiles_per_request(classic, 1h) == protocol::kMaxHeightsPerRequest);
  // Talus takes the ground around a column.
  CHECK(height_tiles_per_request(terrain::default_world(), 100us) == protocol::kMaxHeightsPerRequest);
  CHECK(height_tiles_per_request(terrain::default_world(), 4ms) == 1000);
}

TEST_CASE("heights of eroded land are limited by what a tile was measured to cost") {
  const terrain::World world = eroded(8);
  CHECK(height_tiles_per_request(world, 4ms) == 250);
  CHECK(height_tiles_per_request(world, 33ms) == 30);
  CHECK(height_tiles_per_request(world, 5s) == 1);
  CHECK(height_tiles_per_request(world, 1ns) == protocol::kMaxHeightsPerRequest);
  CHECK(height_tiles_per_request(world, 0ns) == protocol::kMaxHeightsPerRequest);
}

TEST_CASE("the world's limit of height tiles is the session's") {
  CHECK(session_limits(Config{}, eroded(32), {}, 100ms).height_tiles_per_request == 10);
}

TEST_CASE("the configuration's patch_tiles are kept, and chosen if absent") {
  class FreeTime final : public Clock {
    [[nodiscard]] time_point now() const override { return {}; }
    [[nodiscard]] std::chrono::sys_seconds wall() const override { return {}; }
    [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override { return {}; }
  } clock;
  Config config;
  CHECK(measured_patch_size(config, terrain::default_world(), clock).tiles == kMaxChosenTiles);
  // With little memory patches are smaller, unless they are set.
  config.threads.generator = 2;
  for (const std::uint64_t mebibytes : {72U, 128U, 256U, 2'048U}) {
    CAPTURE(mebibytes);
    config.limits.memory_bytes = mebibytes << 20U;
    const PatchSize size = measured_patch_size(config, terrain::default_world(), clock);
    CHECK(2 * size.bytes_at_work() + ground_bytes(config, terrain::default_world()) <=
          config.limits.memory_bytes / GeneratorMemory::kLargestShare);
    CHECK(size.reduced == (mebibytes < 256));
    CHECK((describe(size).find("limits.memory_bytes") != std::string::npos) == size.reduced);
    CHECK(generation_settings(config, terrain::default_world(), size).piece_bytes == size.bytes_at_work());
  }
  config.limits.memory_bytes = std::uint64_t{72} << 20U;
  config.generation.patch_tiles = 8;
  CHECK(measured_patch_size(config, terrain::default_world(), clock).tiles == 8);
}

TEST_CASE("the log names the cost of terrain, and what to change if it is expensive") {
  CHECK(describe(patch_size(4, 100us, 0)) ==
        "terrain takes 97 ns a column here, 1.6 ms a patch of 4 x 4 tiles, 0 us a chunk");
  CHECK_THAT(describe(patch_size(2, 20ms, 0)),
             Catch::StartsWith(
                 "terrain takes 19531 ns a column here, 80.0 ms a patch of 2 x 2 tiles, 0 us a chunk: ") &&
                 Catch::Contains("erosion_steps") && Catch::Contains("threads.generator") &&
                 !Catch::Contains("[[object]]"));
  PatchSize size = patch_size(4, 100us, 0);
  size.chunk_time = kChunkTime;
  CHECK_THAT(describe(size), Catch::EndsWith(" tiles, 250 us a chunk"));
  size.chunk_time += 1ns;
  CHECK_THAT(describe(size),
             Catch::Contains("expensive") && Catch::Contains("[[object]]") && !Catch::Contains("erosion"));
}

TEST_CASE("sessions, runners and handshakes get the configuration's times and bounds") {
  Config config;
  config.limits.handshake_timeout = 1s;
  config.limits.idle_timeout = 2s;
  config.limits.write_timeout = 3s;
  config.limits.frame_bytes = 5000;
  config.limits.queued_bytes_per_session = 6000;
  const RunnerLimits limits = runner_limits(config);
  CHECK(limits.timeouts.handshake == 1s);
  CHECK(limits.timeouts.idle == 2s);
  CHECK(limits.timeouts.write == 3s);
  CHECK(limits.frame_bytes == 5000);
  CHECK(limits.queued_bytes == 6000);
  CHECK(handshake_settings(config).timeout == 1s);
}

TEST_CASE("every rate of the configuration has its burst") {
  Config config;
  config.rates.session_chunks = 1000;
  config.rates.address_bytes = 0;
  config.rates.burst = 500ms;
  const RateLimits limits = rate_limits(config);
  CHECK(limits.session.chunks == Rate{1000, 500});
  CHECK_FALSE(limits.address.bytes.limited());
}

TEST_CASE("the default burst holds the mixed chunks of a View of the largest radius") {
  const Config config;
  const std::uint64_t columns =
      (2 * config.limits.view_horizontal_radius + 1) * (2 * config.limits.view_horizontal_radius + 1);
  CHECK(rate_limits(config).session.chunks.burst >= 3 * columns);
}

TEST_CASE("one address takes a day at least to fill the index of edited chunks, whatever the budget") {
  Config config;
  config.threads = {4, 4};
  CHECK(rate_limits(config).address.new_chunks.per_second == 7'200);
  CHECK(edit_state_settings(config).index_bytes == std::size_t{512} << 20U);
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  for (const std::uint64_t mebibytes : {0U, 128U, 256U, 1'024U, 2'048U, 65'536U}) {
    CAPTURE(mebibytes);
    config.limits.memory_bytes = mebibytes * kMebibyte;
    const Rate new_chunks = rate_limits(config).address.new_chunks;
    REQUIRE(new_chunks.limited());
    const std::uint64_t in_a_day = (new_chunks.burst + 86'400 * new_chunks.per_second) / kNewChunkTokens;
    CHECK(in_a_day * ChunkIndex::kMaxBytesEach <= edit_state_settings(config).index_bytes);
    CHECK(new_chunks.burst >= 100 * kNewChunkTokens);  // an edit of 64 chunks, and what slides
  }
  // However few an hour, an edit of 64 chunks has them.
  config.limits.memory_bytes = 0;
  config.rates.address_new_chunks = 1;
  CHECK(rate_limits(config).address.new_chunks.burst >= 100 * kNewChunkTokens);
  config.rates.address_new_chunks = 0;
  CHECK_FALSE(rate_limits(config).address.new_chunks.limited());
}

TEST_CASE(
    "edits take so little of the memory budget that the server opens again, with all generators at work") {
  Config config;
  config.threads = {4, 4};
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  for (const std::uint64_t mebibytes : {72U, 100U, 128U, 256U, 512U, 2'048U, 65'536U}) {
    CAPTURE(mebibytes);
    config.limits.memory_bytes = mebibytes * kMebibyte;
    const EditStateSettings edits = edit_state_settings(config);
    MemoryBudget budget{config.limits.memory_bytes, 8};
    budget.set(MemoryUse::generators, config.limits.memory_bytes / GeneratorMemory::kLargestShare);
    budget.set(MemoryUse::sessions, config.limits.memory_bytes);
    budget.set(MemoryUse::edits, edits.index_bytes + edits.recent_bytes);
    budget.set(MemoryUse::store, store_memory(config).max_bytes());
    budget.set(MemoryUse::sessions, 1);
    CHECK(budget.takes_connections());
    CHECK(edits.dirty_bytes <= config.limits.memory_bytes / 64);
    CHECK(edits.dirty_bytes >= std::min(EditStateSettings{}.dirty_bytes, config.limits.memory_bytes / 128));
    CHECK(edits.editor_bytes <= config.limits.memory_bytes / 12);
    CHECK(edits.index_bytes > kMebibyte);
    CHECK(edits.cache_bytes <= config.limits.memory_bytes / 8);
  }
  config.limits.memory_bytes = 0;
  CHECK(edit_state_settings(config) == EditStateSettings{});
  CHECK(store_memory(config).max_bytes() == store::StoreMemory{}.max_bytes());
}

TEST_CASE(
    "with all that edits may take for a day, and until they are flushed, a server without sessions opens") {
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  for (const std::uint64_t threads : {1U, 4U, 64U}) {
    Config config;
    config.threads = {threads, threads};
    for (const std::uint64_t mebibytes : {0U, 72U, 100U, 128U, 256U, 512U, 2'048U, 65'536U}) {
      CAPTURE(threads, mebibytes);
      config.limits.memory_bytes = std::max(min_memory_bytes(config), mebibytes * kMebibyte);
      const EditStateSettings edits = edit_state_settings(config);
      MemoryBudget budget{config.limits.memory_bytes, io_threads(config) + generator_threads(config)};
      budget.set(MemoryUse::sessions, config.limits.memory_bytes);
      REQUIRE_FALSE(budget.takes_connections());
      budget.set(MemoryUse::generators, config.limits.memory_bytes / GeneratorMemory::kLargestShare);
      budget.set(MemoryUse::store, store_memory(config).max_bytes());
      const std::uint64_t waits = 4 * edits.dirty_bytes;  // as a StoreWriter keeps it, but for a batch
      budget.set(MemoryUse::edits,
                 edits.index_bytes + edits.recent_bytes + edits.editor_bytes + waits + LocalLog::kBatchBytes);
      budget.set(MemoryUse::sessions, 0);
      CHECK(budget.takes_connections());
    }
  }
}

TEST_CASE("files that are kept in memory to be served leave less to edits") {
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  Config config;
  config.threads = {4, 4};
  for (const std::uint64_t site_bytes : {8 * kMebibyte, 64 * kMebibyte}) {
    for (const std::uint64_t mebibytes : {96U, 256U, 320U, 2'048U}) {
      config.limits.memory_bytes = mebibytes * kMebibyte;
      if (!check_memory(config, site_bytes)) continue;
      CAPTURE(site_bytes, mebibytes);
      const EditStateSettings edits = edit_state_settings(config, site_bytes);
      MemoryBudget budget{config.limits.memory_bytes, 8};
      budget.add(MemoryUse::program, static_cast<std::int64_t>(site_bytes));
      budget.set(MemoryUse::generators, config.limits.memory_bytes / GeneratorMemory::kLargestShare);
      budget.set(MemoryUse::store, store_memory(config, site_bytes).max_bytes());
      budget.set(MemoryUse::edits, edits.index_bytes + edits.recent_bytes);
      budget.set(MemoryUse::sessions, config.limits.memory_bytes);
      budget.set(MemoryUse::sessions, 1);
      CHECK(budget.takes_connections());
      const Rate new_chunks = rate_limits(config, site_bytes).address.new_chunks;
      CHECK((24 * 3'600 + 8 * 3'600) * new_chunks.per_second / kNewChunkTokens * ChunkIndex::kMaxBytesEach <=
            std::max<std::uint64_t>(edits.index_bytes, kMebibyte));
      CHECK(check_index_memory(config, edits.index_bytes, site_bytes).has_value());
    }
  }
  // An index that fits without them does not with them.
  config.data = "/srv/talus";
  config.limits.memory_bytes = 320 * kMebibyte;
  const std::uint64_t index_bytes = 70 * kMebibyte;
  CHECK(check_index_memory(config, index_bytes).has_value());
  const auto refused = check_index_memory(config, index_bytes, 64 * kMebibyte);
  REQUIRE_FALSE(refused.has_value());
  config.limits.memory_bytes = std::stoull(refused.error().substr(refused.error().find("at least ") + 9));
  CHECK(check_index_memory(config, index_bytes, 64 * kMebibyte).has_value());
}

TEST_CASE("an address that is given a rate of editors has it, whatever the budget") {
  Config config;
  for (const std::uint64_t bytes : {std::uint64_t{0}, min_memory_bytes(config), std::uint64_t{2} << 30U}) {
    config.limits.memory_bytes = bytes;
    for (const std::uint64_t an_hour : {1U, 511U, 512U, 513U, 4'096U, 65'536U}) {
      CAPTURE(bytes, an_hour);
      config.rates.address_editors = an_hour;
      CHECK(rate_limits(config).address.editors == Rate{an_hour, an_hour * 8 * 3'600});
    }
  }
}

TEST_CASE("by default one address takes a quarter of the editors in a day at most, whatever the budget") {
  Config config;
  CHECK(rate_limits(config).address.editors.per_second == 512);
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  for (const std::uint64_t mebibytes : {0U, 72U, 128U, 256U, 1'024U, 2'048U, 65'536U}) {
    CAPTURE(mebibytes);
    config.limits.memory_bytes = mebibytes * kMebibyte;
    const Rate editors = rate_limits(config).address.editors;
    REQUIRE(editors.limited());
    const std::uint64_t in_a_day = (editors.burst + 86'400 * editors.per_second) / 3'600;
    CHECK(in_a_day * EditState::kUsedEditorBytes * 4 <= edit_state_settings(config).editor_bytes);
    CHECK(in_a_day * 4 <= edits::kMaxEditors);
    CHECK(editors.burst / 3'600 >= 128);
  }
  config.rates.address_editors = 0;
  CHECK_FALSE(rate_limits(config).address.editors.limited());
}

TEST_CASE(
    "with the default budget as many may edit as a world can have, and edits are flushed as without one") {
  const Config config;
  const EditStateSettings edits = edit_state_settings(config);
  CHECK(edits.editor_bytes >= (edits::kMaxEditors + edits::kOperatorEditors) * EditState::kUsedEditorBytes);
  CHECK(edits.dirty_bytes == EditStateSettings{}.dirty_bytes);
  CHECK(EditStateSettings{}.editor_bytes >= edits.editor_bytes);
}

TEST_CASE(
    "the store's buffers are as large as RocksDB is best with if the budget has room, otherwise smaller") {
  Config config;
  config.threads = {4, 4};
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  CHECK(store_memory(config).max_bytes() == 72 * kMebibyte);  // of the default budget, as without any
  std::size_t before = 0;
  for (const std::uint64_t mebibytes : {72U, 100U, 128U, 256U, 512U, 1'024U, 2'048U}) {
    CAPTURE(mebibytes);
    config.limits.memory_bytes = mebibytes * kMebibyte;
    const std::size_t most = store_memory(config).max_bytes();
    CHECK(most >= before);
    CHECK(most <= config.limits.memory_bytes / 16);
    before = most;
  }
}

TEST_CASE(
    "an index larger than its share is accepted, and one that would refuse every client is an error of one "
    "line") {
  Config config;
  config.data = "/srv/talus";
  config.threads = {4, 4};
  config.limits.memory_bytes = std::uint64_t{256} << 20U;
  const std::size_t share = edit_state_settings(config).index_bytes;
  CHECK(check_index_memory(config, share).has_value());
  CHECK(check_index_memory(config, share + (std::size_t{1} << 20U)).has_value());
  constexpr std::uint64_t kMuch = std::uint64_t{512} << 20U;
  const auto refused = check_index_memory(config, kMuch);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(),
             Catch::StartsWith("limits.memory_bytes: 268435456 is too little for the edits in "
                               "/srv/talus, whose index of edited chunks takes 536870912 "
                               "bytes: ") &&
                 Catch::EndsWith(", or 0 for no limit"));
  // What it says is right is enough.
  const std::string& text = refused.error();
  config.limits.memory_bytes = std::stoull(text.substr(text.find("at least ") + 9));
  CHECK(config.limits.memory_bytes > std::uint64_t{1} << 30U);
  CHECK(check_index_memory(config, kMuch).has_value());
  config.limits.memory_bytes -= std::uint64_t{1} << 20U;
  CHECK_FALSE(check_index_memory(config, kMuch).has_value());
  config.limits.memory_bytes = 0;
  CHECK(check_index_memory(config, kMuch).has_value());
}

TEST_CASE("a server that refuses new connections for want of memory is not ready, and says why") {
  constexpr std::uint64_t kBudget = std::uint64_t{800} << 20U;
  MemoryBudget memory{kBudget};
  CHECK(readiness_of(false, nullptr, nullptr, memory).ready);
  memory.set(MemoryUse::sessions, kBudget / 8 * 5);
  const Readiness full = readiness_of(false, nullptr, nullptr, memory);
  CHECK_FALSE(full.ready);
  CHECK_THAT(full.text,
             Catch::StartsWith("new connections are refused: this server's memory is all in use, ") &&
                 Catch::EndsWith("limits.memory_bytes is 838860800"));
  memory.set(MemoryUse::sessions, kBudget / 2);  // with the program still above the half
  CHECK_FALSE(readiness_of(false, nullptr, nullptr, memory).ready);
  memory.set(MemoryUse::sessions, kBudget / 4);
  CHECK(readiness_of(false, nullptr, nullptr, memory).ready);
  // All reasons are named, the gravest first; that no edits are taken is none by itself.
  cluster::ClusterLog::State log;
  log.ready = true;
  log.read_only = "no quorum";
  CHECK(readiness_of(false, &log, nullptr, memory).ready);
  memory.set(MemoryUse::sessions, kBudget);
  CHECK_FALSE(readiness_of(false, &log, nullptr, memory).ready);
  log.ready = false;
  log.not_ready = "behind";
  CHECK_THAT(
      readiness_of(true, &log, nullptr, memory).text,
      Catch::StartsWith("draining; behind; new connections are refused: ") && Catch::EndsWith("; no quorum"));
}

TEST_CASE("a server that is alone says why it takes no edits, and is not ready once its store is gone") {
  const MemoryBudget memory{std::uint64_t{800} << 20U};
  LocalLog::State log;
  CHECK(readiness_of(false, nullptr, &log, memory).text == "ready");
  log.read_only = "the disk is full";
  CHECK(readiness_of(false, nullptr, &log, memory).ready);
  CHECK(readiness_of(false, nullptr, &log, memory).text == "ready; no edits are taken: the disk is full");
  log.read_only = "db was deleted";
  log.gone = true;
  CHECK_FALSE(readiness_of(false, nullptr, &log, memory).ready);
  CHECK(readiness_of(false, nullptr, &log, memory).text == "db was deleted");
  log = {};
  log.disk_wait = "a write waits";
  CHECK(readiness_of(false, nullptr, &log, memory).ready);
  CHECK(readiness_of(false, nullptr, &log, memory).text == "ready; edits wait: a write waits");
  log.read_only = "the disk is full";
  CHECK(readiness_of(false, nullptr, &log, memory).text == "ready; no edits are taken: the disk is full");
}

TEST_CASE("a server to which the log's messages do not come by themselves is ready, and says why") {
  const MemoryBudget memory{std::uint64_t{800} << 20U};
  cluster::ClusterLog::State log;
  log.ready = true;
  CHECK(readiness_of(false, &log, nullptr, memory).text == "ready");
  log.late = "not allowed";
  CHECK(readiness_of(false, &log, nullptr, memory).ready);
  CHECK_THAT(readiness_of(false, &log, nullptr, memory).text, Catch::Contains("late: not allowed"));
  log.read_only = "no quorum";
  CHECK_THAT(readiness_of(false, &log, nullptr, memory).text, Catch::Contains("no quorum"));
}

TEST_CASE("the operators' port, proxies and TLS need descriptors of their own") {
  const Config plain;
  Config both;
  both.admin = protocol::Endpoint{"127.0.0.1", 0};
  both.proxies = *Networks::parse("127.0.0.1");
  CHECK(descriptors_wanted(both) ==
        descriptors_wanted(plain) + AdminServer::kMaxConnections + both.limits.handshakes_in_flight);
  Config secured;
  secured.tls = {"certificate.pem", "key.pem"};
  CHECK(descriptors_wanted(secured) == descriptors_wanted(plain) + secured.limits.handshakes_in_flight);
}

TEST_CASE("the least memory budget opens again when all clients have left, whatever a load took") {
  MemoryBudget budget{kMinMemoryBytes};
  GeneratorMemory generators{budget, 64, make_logger("off", "text")};
  generators.note_patch(std::size_t{1} << 30);
  budget.set(MemoryUse::sessions, kMinMemoryBytes);
  CHECK_FALSE(budget.takes_work());
  CHECK_FALSE(budget.takes_connections());
  budget.set(MemoryUse::sessions, 0);
  CHECK(budget.takes_work());
  CHECK(budget.takes_connections());
}

TEST_CASE("many threads raise the least memory budget, by what each keeps") {
  Config config;
  config.threads = {8, 8};
  CHECK(min_memory_bytes(config) == kMinMemoryBytes);
  config.threads = {64, 64};
  const std::uint64_t least = min_memory_bytes(config);
  const std::uint64_t program = MemoryBudget{least, 128}.used(MemoryUse::program);
  CHECK(program == MemoryBudget::kProgramBytes + 112 * MemoryBudget::kThreadBytes);
  CHECK(least == 3 * program);
  config.limits.memory_bytes = least;
  CHECK(check_memory(config).has_value());
  config.limits.memory_bytes = least - 1;
  CHECK_FALSE(check_memory(config).has_value());
}

TEST_CASE("less memory than that is refused in a line that names the setting, its value and the least") {
  Config config;
  config.threads = {1, 1};
  for (const std::uint64_t bytes : {std::uint64_t{0}, kMinMemoryBytes, Config{}.limits.memory_bytes}) {
    config.limits.memory_bytes = bytes;
    CHECK(check_memory(config).has_value());
  }
  for (const std::uint64_t bytes : {std::uint64_t{1}, kMinMemoryBytes - 1}) {
    config.limits.memory_bytes = bytes;
    const auto refused = check_memory(config);
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::StartsWith("limits.memory_bytes: " + std::to_string(bytes)) &&
                                    Catch::Contains(std::to_string(kMinMemoryBytes)));
  }
}
