// Tiles of the map from a real talusd.
#include <catch2/catch.hpp>
#include <string>

#include "http_client.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

std::string map_root(HttpClient& client) {
  const std::string root = root_of(client);
  return root.substr(0, root.rfind('/')) + "/map/";
}

}  // namespace

TEST_CASE("talusd draws tiles of the map near and far, and the same again from memory") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  HttpClient client{server.http_port()};
  const std::string root = map_root(client);
  for (const std::string tile : {"12/-1/0", "6/0/0", "5/1/-1", "0/65535/-65536"}) {
    INFO(tile);
    const Answer first = client.get(root + tile + ".png");
    REQUIRE(first.status == 200);
    CHECK(first.field("Content-Type") == "image/png");
    CHECK(first.body.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(first.body.substr(16, 8) == std::string("\0\0\1\0\0\0\1\0", 8));  // 256 x 256
    const Answer second = client.get(root + tile + ".png");
    CHECK(second.body == first.body);
    CHECK(second.field("ETag") == first.field("ETag"));
  }
  CHECK(client.get(root + "0/65536/0.png").status == 404);
}

TEST_CASE("a client that requests many tiles and leaves takes no generator from others") {
  ServerProcess server{{kClassicWorld, {"TALUS_THREADS_GENERATOR", "1"}}, kWithHttp};
  HttpClient client{server.http_port()};
  const std::string root = map_root(client);
  {
    HttpClient leaving{server.http_port()};
    std::string all;
    for (int x = 0; x < 100; ++x) all += HttpClient::request(root + "6/" + std::to_string(x) + "/0.png");
    leaving.send(all);
  }
  const std::string chunk = root.substr(0, root.size() - 4) + "4/0/40/0/40";
  CHECK(client.get(chunk).status == 200);
}
