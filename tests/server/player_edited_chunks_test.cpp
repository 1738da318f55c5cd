// Players' HTTP: chunks with edits, by their revisions, and the index of what was edited.
#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "player_site.h"

using namespace talus;
using namespace talus::server;

TEST_CASE("a chunk with edits is kept by every cache, and its path depends only on its revision") {
  PlayerSite site;
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

TEST_CASE("a request for a chunk is redirected three times at most, however fast the chunk is edited") {
  for (const bool column : {false, true}) {
    for (const auto between : {1ms, 100ms, 1000ms, 4900ms}) {
      PlayerSite site;
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

TEST_CASE("a new chunk has the fields of one that needs a token, and a 304 for a client with its bytes") {
  const ScratchDirectory scratch;
  PlayerSite site{with_secret(scratch)};
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
  PlayerSite site;
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
  PlayerSite site;
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

TEST_CASE("a column with edits but unknown rows has all rows that were edited") {
  PlayerSite site;
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
    PlayerSite site;
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
  PlayerSite site;
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

TEST_CASE("the edited columns of a region are listed, to be requested again each time") {
  PlayerSite site;
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
  PlayerSite site;
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

TEST_CASE("paths of another store of edits are not found, and all such paths if no edits are stored") {
  for (const bool stored : {false, true}) {
    PlayerSite site;
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

TEST_CASE("a client that may read chunks as generated may read chunks with edits") {
  const ScratchDirectory scratch;
  for (const bool chunks_are_public : {false, true}) {
    PlayerSite site{with_secret(scratch)};
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

TEST_CASE("the world's document describes its edits") {
  PlayerSite site;
  const auto told = [&] { return nlohmann::json::parse(site.ask("/v1/world").body)["edits"]; };
  CHECK(told() == nlohmann::json{{"taken", true}, {"revision", "0"}});
  const std::string tag = site.ask("/v1/world").field("ETag");
  site.land.newest = UINT64_MAX;
  site.land.taken = false;
  CHECK(told() == nlohmann::json{{"taken", false}, {"revision", "18446744073709551615"}});
  CHECK(site.ask("/v1/world", "If-None-Match: " + tag + "\r\n").status == 200);
  PlayerSite without;
  without.has_store = false;
  CHECK(nlohmann::json::parse(without.ask("/v1/world").body)["edits"] ==
        nlohmann::json{{"taken", false}, {"revision", "0"}});
}
