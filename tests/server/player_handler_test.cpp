// Players' HTTP: the world, who may read, rates, proxies, heights and maps.
#include <catch2/catch.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "logged_lines.h"
#include "player_site.h"
#include "scratch_directory.h"
#include "signed_tokens.h"

using namespace talus;
using namespace talus::server;

TEST_CASE("another world and another codec are named") {
  PlayerSite site;
  CHECK_THAT(site.ask("/v1/ffff/4/0/0/0/0").body, Catch::Contains("00000000000000020000000000000001"));
  CHECK(site.ask("/v1/00000000000000020000000000000001/3/0/0/0/0").code() == "version");
}

TEST_CASE("the world is described, and its description has a tag") {
  PlayerSite site;
  const Answer answer = site.ask("/v1/world");
  CHECK(answer.status == 200);
  const auto world = nlohmann::json::parse(answer.body);
  CHECK(world["fingerprint"] == "00000000000000020000000000000001");
  CHECK(world["looks"][0] == "meadow");
  CHECK(site.ask("/v1/world", "If-None-Match: " + answer.field("ETag") + "\r\n").status == 304);
}

TEST_CASE("the files of a published world are served as they are, for ever; of others there are none") {
  const std::string base = "/v1/00000000000000020000000000000001/";
  PlayerSite site;
  for (const char* const path : {"world.toml", "files/a", "files/"}) {
    const Answer answer = site.ask(base + path);
    CHECK(answer.status == 404);
    CHECK(answer.code() == site.ask(base + "no/path").code());
  }
  PlayerSite of_public;
  of_public.world_files = std::make_shared<const web::WorldFiles>(std::make_shared<const PublishedWorld>(
      PublishedWorld{"seed = 1\n", {{"a b+/\xC3\xA9.vox", std::string{"VOX \0", 5}}}}));
  const Answer spec = of_public.ask(base + "world.toml");
  CHECK(spec.status == 200);
  CHECK(spec.body == "seed = 1\n");
  CHECK(spec.field("Content-Type") == "application/toml");
  CHECK(spec.field("Cache-Control") == "public, max-age=31536000, immutable");
  CHECK(of_public.ask(base + "world.toml", "If-None-Match: " + spec.field("ETag") + "\r\n").status == 304);
  CHECK(of_public.ask(base + "files/a%20b+/%c3%A9.vox").body == std::string{"VOX \0", 5});
  for (const char* const path : {"files/", "files/a", "files/%zz", "files/a%20b%20/%c3%A9.vox"}) {
    CHECK(of_public.ask(base + path).status == 404);
  }
  CHECK(of_public.ask(base + "world.toml?x=1").status == 400);
  CHECK(of_public.ask("/v1/00000000000000020000000000000002/world.toml").code() == "out_of_range");
}

TEST_CASE("a published world's files need the token that its chunks need") {
  const ScratchDirectory scratch;
  PlayerSite site{with_secret(scratch)};
  site.world_files = std::make_shared<const web::WorldFiles>(
      std::make_shared<const PublishedWorld>(PublishedWorld{"seed = 1\n", {}}));
  const std::string path = "/v1/00000000000000020000000000000001/world.toml";
  CHECK(site.ask(path).status == 401);
  const Answer answer = site.ask(path, kToken);
  CHECK(answer.status == 200);
  CHECK(answer.field("Cache-Control") == "private, no-store");
}

TEST_CASE("a client over its rate waits for a file, or is refused") {
  PlayerSite site;
  site.world_files = std::make_shared<const web::WorldFiles>(
      std::make_shared<const PublishedWorld>(PublishedWorld{std::string(100'000, '#'), {}}));
  site.rates.set({{{}, {1000, 1000}, {}}, {}, 1s});
  const std::string path = "/v1/00000000000000020000000000000001/world.toml";
  const auto client = site.connect();
  CHECK(site.ask(*client, path).status == 200);
  CHECK(site.ask(*client, path).status == 429);
}

TEST_CASE("a stream requested in HTTP/1.0 is refused: 426, and the connection closes") {
  PlayerSite site;
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

TEST_CASE("if a token is required, no cache keeps a chunk unless chunks are public") {
  const ScratchDirectory scratch;
  for (const bool chunks_are_public : {false, true}) {
    PlayerSite site{with_secret(scratch)};
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

TEST_CASE("a client without a valid token gets the reason, and how to send one") {
  const ScratchDirectory scratch;
  Access settings;
  settings.signing_key_file = scratch.write("key", kKeyText);
  settings.revoked_file = scratch.write("revoked", "sub 2100-01-01T00:00:00Z gone\n");
  settings.blocked_file = scratch.write("blocked", "subject rude\n");
  PlayerSite site{settings};
  const auto bearer = [&](const std::string& subject, std::chrono::seconds lasts = 1h) {
    const auto now = site.clock.wall();
    return "Authorization: Bearer " +
           *make_signed_token(Secret{kKeyText}, {subject, {Right::read}, now + lasts}, now) + "\r\n";
  };
  REQUIRE(site.ask("/v1/world", bearer("a")).status == 200);

  const auto [fields, text, challenge] = GENERATE_REF(table<std::string, std::string, std::string>(
      {{"", "this server asks for a token", "Bearer"},
       {bearer("a", -1h), "the token has expired",
        R"(Bearer error="invalid_token", error_description="the token has expired")"},
       {bearer("gone"), "the token was revoked",
        R"(Bearer error="invalid_token", error_description="the token was revoked")"},
       {"Authorization: Bearer guess\r\n", "the token is not accepted",
        R"(Bearer error="invalid_token", error_description="the token is not accepted")"}}));
  for (const std::string& target : {std::string{"/v1/world"}, kChunks + "/0/0/0/0"}) {
    const Answer answer = site.ask(target, fields);
    CHECK(answer.status == 401);
    CHECK(answer.code() == "unauthorized");
    CHECK(answer.field("WWW-Authenticate") == challenge);
    CHECK_THAT(answer.text(), Catch::StartsWith(text) && Catch::Contains("Authorization: Bearer TOKEN"));
  }

  // No other token helps whom the operator has blocked.
  const Answer blocked = site.ask("/v1/world", bearer("rude"));
  CHECK(blocked.status == 403);
  CHECK(blocked.code() == "unauthorized");
  CHECK(blocked.field("WWW-Authenticate").empty());
  CHECK_THAT(blocked.text(), Catch::Contains("blocked you; only the operator can let you in again"));
}

TEST_CASE("requests over the rate get the time to retry") {
  PlayerSite site;
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

TEST_CASE("a proxy's requests count for the clients that it names") {
  PlayerSite site;
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
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: ::ffff:192.0.2.1\r\n").status == 503);
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: 192.0.2.2\r\n").status == 200);
  site.answer_all();
  CHECK(site.ask(*client, "/v1/world", "X-Forwarded-For: 192.0.2.1\r\n").status == 200);
}

TEST_CASE("a client's own values before a proxy's X-Forwarded-For name no client") {
  PlayerSite site;
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

TEST_CASE("every answer counts as a request") {
  const std::string region = kStore + "/edits/0/-1/0";
  for (const std::string& target : {std::string{"/v1/world"}, std::string{"/v1/nothing"},
                                    std::string{"/v1/heights?columns=x"}, std::string{"/"}, region}) {
    PlayerSite each;
    each.rates.set({{{}, {}, {1, 1}}, {}, 1s});
    const auto client = each.connect();
    (void)each.ask(*client, target);
    CHECK(each.ask(*client, target).status == 429);
  }
  const ScratchDirectory scratch;
  PlayerSite site{with_secret(scratch)};
  site.rates.set({{{}, {}, {1, 1}}, {}, 1s});
  const auto client = site.connect();
  CHECK(site.ask(*client, "/v1/world", "Authorization: Bearer wrong\r\n").status == 401);
  CHECK(site.ask(*client, "/v1/world", "Authorization: Bearer wrong\r\n").status == 429);
}

TEST_CASE("a client that hangs up while its chunk is made no longer waits") {
  PlayerSite site;
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

TEST_CASE("an answer for every cache is one copy that any page may read") {
  PlayerSite site;
  site.source.in_memory[key_at(0, 0, 0)] = scripted_chunk(key_at(0, 0, 0));
  for (const char* const fields : {"", "Origin: https://b.example\r\n"}) {
    const Answer chunk = site.ask(kChunks + "/0/0/0/0", fields);
    CHECK(chunk.field("Access-Control-Allow-Origin") == "*");
    CHECK(chunk.field("Vary").empty());
  }
}

TEST_CASE("if origins are listed, only they and the server's own host may read answers of /v1") {
  PlayerSite site;
  site.settings.origins = *AllowedOrigins::parse("https://play.example");
  site.source.rows = {0, 0, MaterialId{3}};
  for (const std::int32_t y : {-1, 0, 1})
    site.source.in_memory[key_at(0, y, 0)] = scripted_chunk(key_at(0, y, 0));
  site.source.drawn = map::Tile{8, 0, 0};
  const std::string map = "/v1/00000000000000020000000000000001/map/8/0/0.png";
  for (const std::string& target : {std::string{"/v1/world"}, kChunks + "/0/0/0/0", kChunks + "/0/0/0", map,
                                    kStore + "/edits/0/0/0", std::string{"/v1/heights?columns=x"}}) {
    CAPTURE(target);
    const auto reader = [&](const std::string& origin) {
      const Answer answer = site.ask(target, origin.empty() ? "" : "Origin: " + origin + "\r\n");
      CHECK(answer.field("Vary") == "Origin");  // a cache holds an answer for each
      return answer.field("Access-Control-Allow-Origin");
    };
    CHECK(reader("https://play.example") == "https://play.example");
    CHECK(reader("https://a.example") == "https://a.example");
    CHECK(reader("https://b.example").empty());
    CHECK(reader("").empty());
  }
}

TEST_CASE("no cache keeps a copy for an arbitrary origin") {
  PlayerSite site;
  site.settings.origins = *AllowedOrigins::parse("https://play.example");
  site.source.in_memory[key_at(0, 0, 0)] = scripted_chunk(key_at(0, 0, 0));
  const std::string chunk = kChunks + "/0/0/0/0";
  const std::string listed = "Origin: https://play.example\r\n";
  const std::string tag = "If-None-Match: " + site.ask(chunk).field("ETag") + "\r\n";
  for (const std::string& target : {chunk, kStore + "/edits/0/0/0", std::string{"/v1/world"}}) {
    CAPTURE(target);
    const std::string kept = site.ask(target).field("Cache-Control");
    CHECK(kept.find("no-store") == std::string::npos);
    CHECK(site.ask(target, listed).field("Cache-Control") == kept);
    for (const char* const fields :
         {"Origin: https://b.example\r\n", "Origin: https://a.example\r\n", "Origin: null\r\n",
          "Origin: https://play.example\r\nOrigin: https://b.example\r\n"}) {
      CAPTURE(fields);
      const Answer answer = site.ask(target, fields);
      CHECK(answer.status == 200);
      CHECK(answer.field("Cache-Control").find("no-store") != std::string::npos);
    }
  }
  CHECK(site.ask(chunk, listed + tag).status == 304);
  CHECK(site.ask(chunk, listed + tag).field("Cache-Control") == site.ask(chunk).field("Cache-Control"));
  const Answer strange = site.ask(chunk, "Origin: https://b.example\r\n" + tag);
  CHECK(strange.status == 304);
  CHECK(strange.field("Cache-Control") == "no-store");
}

TEST_CASE("pages of other hosts may read only if they are listed") {
  PlayerSite site;
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
  PlayerSite open;
  open.settings.origins = *AllowedOrigins::parse("*");
  const Answer all = open.ask("/v1/world", "Origin: https://b.example\r\n");
  CHECK(all.field("Access-Control-Allow-Origin") == "*");
  CHECK(all.field("Vary").empty());
}

TEST_CASE("files next to /v1 need no token, and count in the rates as all requests and bytes do") {
  const ScratchDirectory scratch;
  const ScratchDirectory dist;
  const std::string page(100'000, 'x');
  dist.write("index.html", page);
  PlayerSite site{with_secret(scratch)};
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

TEST_CASE("heights are written by the source that made them, as JSON or as an array") {
  PlayerSite site;
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
  PlayerSite site;
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

TEST_CASE("a client that leaves has no map drawn, and a map counts with its cost") {
  PlayerSite site;
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
  const std::weak_ptr connection = site.connections.back();
  site.connections.pop_back();
  CHECK_FALSE(connection.expired());
  greedy->hung_up = true;
  connection.lock()->clock_moved();
  site.io.poll();
  CHECK(connection.expired());  // it waits for its rate no longer
}

TEST_CASE("a list in several fields of one name is read as one") {
  PlayerSite site;
  site.source.in_memory[key_at(0, 0, 0)] = scripted_chunk(key_at(0, 0, 0));
  const std::string tag = site.ask(kChunks + "/0/0/0/0").field("ETag");
  CHECK(site.ask(kChunks + "/0/0/0/0", "If-None-Match: \"x\"\r\nIf-None-Match: " + tag + "\r\n").status ==
        304);
  const std::string upgrade =
      "Connection: keep-alive\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  CHECK(site.ask("/v1/stream", upgrade + "Upgrade: h2c\r\nUpgrade: websocket\r\n").status == 101);
  // Fields that are not lists may not come twice.
  CHECK(site.ask("/v1/stream", upgrade + "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n").status ==
        426);
  CHECK(site.ask("/v1/stream",
                 upgrade + "Upgrade: websocket\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n")
            .status == 400);
}

TEST_CASE("a request with two tokens is refused") {
  const ScratchDirectory scratch;
  PlayerSite site{with_secret(scratch)};
  CHECK(site.ask("/v1/world", kToken).status == 200);
  CHECK(site.ask("/v1/world", kToken + "Authorization: Bearer other\r\n").status == 401);
}

TEST_CASE("a field is asked for by its whole name, even if that has a blank or a comma") {
  PlayerSite site;
  const auto ask = [&](const std::string& fields) {
    return site.ask("/v1/heights?columns=1%2C2&fields=" + fields).text();
  };
  const auto client = site.connect();
  for (const char* const fields :
       {"red%20rock", "red+rock", "a%2Cb,temperature", "temperature%2Cred%20rock"}) {
    CAPTURE(fields);
    client->send(std::string{"GET /v1/heights?columns=1%2C2&fields="} + fields +
                 " HTTP/1.1\r\nHost: a\r\n\r\n");
    site.io.poll();
    REQUIRE(site.source.waiting_heights.size() == 1);
    const auto [ticket, mailbox] = *site.source.waiting_heights.begin();
    site.source.answer_heights(ticket);
    mailbox->wake();
    site.io.poll();
    CHECK(answers_in(client->text()).back().status == 200);
  }
  CHECK_THAT(ask("a,b"), Catch::Contains("no 'a'"));
  CHECK_THAT(ask("%zz"), Catch::Contains("%25 is a percent sign"));
}

TEST_CASE("each refused origin is logged once, up to a limit") {
  const auto lines = std::make_shared<LoggedLines>();
  PlayerSite site;
  site.runner.log = lines;
  const auto ask = [&](const std::string& origin, const std::string& target = "/v1/world") {
    (void)site.ask(target, "Origin: " + origin + "\r\n");
  };
  ask("https://a.example");  // the server's own host
  const std::size_t before = lines->count();
  ask("https://b.example");
  CHECK(lines->count() == before + 1);
  CHECK_THAT(lines->text(),
             Catch::Contains("pages of origin \"https://b.example\" may not read or stream; http.origins"));
  ask("https://b.example");
  ask("https://b.example", "/v1/stream");
  CHECK(lines->count() == before + 1);
  for (int i = 0; i < 200; ++i) ask("https://c" + std::to_string(i) + ".example");
  CHECK(lines->count() == before + web::RefusedOrigins::kMax);
}

TEST_CASE("an IPv4 client whose proxy writes its address as IPv6 is logged by its IPv4 address") {
  const auto lines = std::make_shared<LoggedLines>();
  PlayerSite site;
  site.runner.log = lines;
  site.through_proxy = true;
  site.settings.proxies = *Networks::parse("127.0.0.1");
  (void)site.ask("/v1/world", "X-Forwarded-For: ::ffff:192.0.2.1\r\nOrigin: https://b.example\r\n");
  CHECK_THAT(lines->text(), Catch::Contains("conn 1 192.0.2.1: pages of origin"));
}

TEST_CASE("a token of this server that is refused for a claim says which") {
  const ScratchDirectory scratch;
  Access settings;
  settings.signing_key_file = scratch.write("key", kKeyText);
  PlayerSite site{settings};
  const auto bearer = [](const std::string& claims) {
    return "Authorization: Bearer " + raw_token(kHs256, claims) + "\r\n";
  };
  CHECK(site.ask("/v1/world", bearer(R"({"exp": 1800009999.5})")).status == 200);
  const Answer refused = site.ask("/v1/world", bearer(R"({"exp": 1800009999, "rights": "raed"})"));
  CHECK(refused.status == 401);
  CHECK_THAT(refused.text(),
             Catch::StartsWith("the token is not accepted: its rights: \"raed\" is wrong; give"));
  CHECK(refused.field("WWW-Authenticate") ==
        R"(Bearer error="invalid_token", error_description="the token is not accepted")");
}
