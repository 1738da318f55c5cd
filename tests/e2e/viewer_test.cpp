// Files at / of a real talusd.
#include <asio/error.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "http_client.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

TEST_CASE("talusd serves a directory of files as of its start, next to /v1") {
  const ScratchDirectory dist;
  const std::string large(300'000, 'a');
  dist.write("index.html", "<!doctype html>");
  std::filesystem::create_directory(dist / "assets");
  dist.write("assets/index-0123abcd.js", large);
  dist.write("assets/index-0123abcd.js.gz", "compressed");
  ServerProcess server{{kClassicWorld}, {"--http", "127.0.0.1:0", "--web", dist.path().string()}};
  std::filesystem::remove(dist / "index.html");
  HttpClient client{server.http_port()};
  const Answer page = client.get("/");
  CHECK(page.status == 200);
  CHECK(page.body == "<!doctype html>");
  CHECK(page.field("Content-Type") == "text/html; charset=utf-8");
  CHECK(client.get("/", "If-None-Match: " + page.field("ETag") + "\r\n").status == 304);
  CHECK(client.get("/assets/index-0123abcd.js").body == large);
  const Answer compressed = client.get("/assets/index-0123abcd.js", "Accept-Encoding: gzip, br\r\n");
  CHECK(compressed.body == "compressed");
  CHECK(compressed.field("Content-Encoding") == "gzip");
  client.send("HEAD /assets/index-0123abcd.js HTTP/1.1\r\nHost: talus\r\n\r\n" + HttpClient::request("/"));
  CHECK(client.read(true).field("Content-Length") == "300000");
  CHECK(client.read().body == page.body);
  for (const std::string path :
       {"/../../etc/passwd", "/assets/..%2f..%2fetc/passwd", "//etc/passwd", "/assets", "/%00"}) {
    CHECK(client.get(path).status == 404);
  }
  CHECK(client.get("/v1/world").status == 200);
}

TEST_CASE("a directory that cannot be served ends talusd with one line") {
  const ScratchDirectory dist;
  const ProgramResult ended = run_talusd({"--http", "127.0.0.1:0", "--web", dist.path().string()});
  CHECK(ended.status == 1);
  CHECK_THAT(ended.err,
             Catch::Contains("http.web: ") && Catch::Contains("has no index.html") && Catch::EndsWith("\n"));
  CHECK(run_talusd({"--check-config", "--web", dist.path().string()}).status == 1);
}
