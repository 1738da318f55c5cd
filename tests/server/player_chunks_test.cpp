// Players' HTTP: chunks, columns and squares as generated.
#include <catch2/catch.hpp>
#include <string>

#include "player_site.h"
#include "web/columns_body.h"

using namespace talus;
using namespace talus::server;

TEST_CASE("paths have chunks as generated, whatever sessions are sent") {
  PlayerSite site;
  const ChunkKey key{{1, 2, 3}, Lod{}};
  site.source.in_memory[key] = scripted_chunk(key);
  site.edited.in_memory[key] = scripted_chunk(key, 5, 50);
  const std::string path = "/v1/" + to_string(site.world.fingerprint) + "/4/0/1/2/3";
  CHECK(site.ask(path).body.size() == 100);
  CHECK(site.edited.submitted == 0);
}

TEST_CASE("a chunk in memory is answered at once, for every cache to keep") {
  PlayerSite site;
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

TEST_CASE("a request waits for a chunk that is not in memory, and earlier chunks do not wait") {
  PlayerSite site;
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

TEST_CASE("a closed connection no longer waits") {
  PlayerSite site;
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
  PlayerSite site;
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
  PlayerSite site;
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
    PlayerSite site;
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
  PlayerSite site;
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

TEST_CASE("an answer over 4 MiB must be requested chunk by chunk, a column as a square") {
  PlayerSite site;
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
