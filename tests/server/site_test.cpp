// Files that talusd serves at /: what is read at the start, and what a request gets.
#include "web/site.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "scratch_directory.h"
#include "web/accept_encoding.h"
#include "web/site_answer.h"

using namespace talus::server;
using namespace talus::server::web;
namespace fs = std::filesystem;

namespace {

const std::string kHashed = "assets/main-Ab3dEf9_.js";

/// A directory as a bundler leaves it.
struct Dist {
  ScratchDirectory scratch;
  Dist() {
    fs::create_directory(scratch / "assets");
    scratch.write("index.html", "<!doctype html>");
    scratch.write("map.html", "<!doctype html><title>map");
    scratch.write(kHashed, "let a = 1;");
    scratch.write(kHashed + ".gz", "gzipped");
    scratch.write(kHashed + ".br", "brotlied");
    scratch.write(".DS_Store", "not served");
  }
  [[nodiscard]] std::shared_ptr<const Site> read() const {
    const auto site = Site::read(scratch.path());
    REQUIRE(site);
    return *site;
  }
  [[nodiscard]] std::string why_not() const {
    const auto site = Site::read(scratch.path());
    REQUIRE_FALSE(site);
    return site.error();
  }
};

http::Request request_of(const std::string& target, std::vector<http::Field> fields = {}) {
  return {http::Method::get, target, std::move(fields), true, false};
}

std::string field_of(const http::Response& response, const std::string& name) {
  for (const http::Field& field : response.fields) {
    if (field.name == name) return field.value;
  }
  return "";
}

}  // namespace

TEST_CASE("a site has its files by their paths, and a folder's page at the folder") {
  const Dist dist;
  const auto site = dist.read();
  CHECK(site->files() == 3);
  REQUIRE(site->find("/") != nullptr);
  CHECK(site->find("/") == site->find("/index.html"));
  CHECK(site->find("/")->content_type == "text/html; charset=utf-8");
  CHECK(site->find("/map.html") != nullptr);
  REQUIRE(site->find("/" + kHashed) != nullptr);
  CHECK(site->find("/" + kHashed)->hashed);
  CHECK_FALSE(site->find("/map.html")->hashed);
  for (const std::string path :
       {"", "index.html", "/assets", "/assets/", "/assets/../index.html", "/./index.html", "//index.html",
        "/.DS_Store", "/index.html/", "/%69ndex.html", "/INDEX.HTML"}) {
    CHECK(site->find(path) == nullptr);
  }
  CHECK(site->find("/" + kHashed + ".gz") == nullptr);
}

TEST_CASE("a name has a hash if its last eight letters are not a word") {
  const Dist dist;
  for (const std::string name : {"assets/icon-settings.svg", "assets/index.js", "assets/a-1234567.js"})
    dist.scratch.write(name, "x");
  for (const std::string name :
       {"assets/a-12345678.js", "assets/map-B-_x9abc.css", "assets/a-B_x9abcd.js.map"})
    dist.scratch.write(name, "x");
  dist.scratch.write("page-12345678.js", "x");
  const auto site = dist.read();
  for (const std::string name :
       {"assets/icon-settings.svg", "assets/index.js", "assets/a-1234567.js", "page-12345678.js"}) {
    INFO(name);
    CHECK_FALSE(site->find("/" + name)->hashed);
  }
  for (const std::string name :
       {"assets/a-12345678.js", "assets/map-B-_x9abc.css", "assets/a-B_x9abcd.js.map"}) {
    INFO(name);
    CHECK(site->find("/" + name)->hashed);
  }
}

TEST_CASE("a directory that is not a site is refused in one line with the reason") {
  SECTION("no page") {
    const ScratchDirectory empty;
    CHECK_THAT(Site::read(empty.path()).error(), Catch::Contains("has no index.html"));
    CHECK_THAT(Site::read(empty / "nowhere").error(), Catch::Contains("nowhere: No such file"));
    CHECK_THAT(Site::read(empty.write("file", "x")).error(), Catch::Contains("Not a directory"));
  }
  const Dist dist;
  SECTION("a name that would need escapes in a URL") {
    dist.scratch.write("a b.html", "x");
    CHECK_THAT(dist.why_not(), Catch::Contains("a b.html: this name"));
  }
  SECTION("a link out") {
    const ScratchDirectory elsewhere;
    fs::create_symlink(elsewhere.write("secret", "x"), dist.scratch / "link.txt");
    CHECK_THAT(dist.why_not(), Catch::Contains("link.txt: is a link that leads out"));
  }
  SECTION("a folder out, whose name begins as the directory's does") {
    const fs::path beside = dist.scratch.path().string() + "-beside";
    fs::create_directory(beside);
    fs::create_directory_symlink(beside, dist.scratch / "folder");
    CHECK_THAT(dist.why_not(), Catch::Contains("folder: is a link that leads out"));
    fs::remove(beside);
  }
  SECTION("a link to itself") {
    fs::create_directory_symlink(".", dist.scratch / "again");
    CHECK_THAT(dist.why_not(), Catch::Contains("folders deep"));
  }
  SECTION("a pipe") {
    REQUIRE(::mkfifo((dist.scratch / "pipe").c_str(), 0600) == 0);
    CHECK_THAT(dist.why_not(), Catch::Contains("pipe: is not a regular file"));
  }
  SECTION("too many files") {
    for (std::size_t i = 0; i < Site::kMaxFiles; ++i) dist.scratch.write("f" + std::to_string(i), "");
    CHECK_THAT(dist.why_not(), Catch::Contains("has over 1000 files"));
  }
  SECTION("too many bytes") {
    fs::resize_file(dist.scratch.write("large", ""), Site::kMaxBytes);
    CHECK_THAT(dist.why_not(), Catch::Contains("has over 64 MiB"));
  }
}

TEST_CASE("a link inside the directory is followed") {
  const Dist dist;
  fs::create_symlink("map.html", dist.scratch / "same.html");
  CHECK(dist.read()->find("/same.html") != nullptr);
}

TEST_CASE("a client that can decompress gets the smallest form, and each form has its own tag") {
  const Dist dist;
  const auto site = dist.read();
  const auto ask = [&](const std::string& accepts) {
    return site_answer(site.get(), request_of("/" + kHashed, {{"Accept-Encoding", accepts}}));
  };
  const http::Response best = ask("gzip, deflate, br");
  CHECK(best.content() == "brotlied");
  CHECK(field_of(best, "Content-Encoding") == "br");
  CHECK(field_of(best, "Vary") == "Accept-Encoding");
  CHECK(best.cache_control == "public, max-age=31536000, immutable");
  CHECK(best.content_type == "text/javascript; charset=utf-8");
  const http::Response gzipped = ask("gzip");
  CHECK(gzipped.content() == "gzipped");
  CHECK(gzipped.etag.value() != best.etag.value());
  CHECK(ask("br;q=0, gzip;q=0.5").content() == "gzipped");
  for (const http::Response& plain :
       {ask("identity"), ask("*"), site_answer(site.get(), request_of("/" + kHashed))}) {
    CHECK(plain.content() == "let a = 1;");
    CHECK(field_of(plain, "Content-Encoding").empty());
    CHECK(field_of(plain, "Vary") == "Accept-Encoding");
  }
  CHECK(field_of(site_answer(site.get(), request_of("/")), "Vary").empty());
}

TEST_CASE("a page is revalidated, and is not sent if the client has it") {
  const Dist dist;
  const auto site = dist.read();
  const http::Response page = site_answer(site.get(), request_of("/?x=1&y=2"));
  CHECK(page.status == 200);
  CHECK(page.cache_control == http::kNoCache);
  CHECK_THAT(field_of(page, "Content-Security-Policy"), Catch::Contains("script-src 'self';"));
  CHECK(field_of(page, "X-Content-Type-Options") == "nosniff");
  CHECK(field_of(page, "Referrer-Policy") == "no-referrer");
  const http::Response same = site_answer(
      site.get(), request_of("/", {{"If-None-Match", std::string{http::text_of(page.etag.value())}}}));
  CHECK(same.status == 304);
  CHECK(same.content().empty());
  CHECK(same.etag == page.etag);
}

TEST_CASE("pages may compile WebAssembly if the site has some") {
  const Dist dist;
  dist.scratch.write("assets/decoder-Ab3dEf9_.wasm", "\0asm");
  const auto site = dist.read();
  for (const char* const path : {"/", "/nothing"}) {
    CHECK_THAT(field_of(site_answer(site.get(), request_of(path)), "Content-Security-Policy"),
               Catch::Contains("script-src 'self' 'wasm-unsafe-eval';"));
  }
}

TEST_CASE("a missing page names the viewer's place, for any path") {
  const Dist dist;
  const auto site = dist.read();
  const http::Response missing = site_answer(site.get(), request_of("/a/b/c"));
  CHECK(missing.status == 404);
  CHECK(missing.cache_control == http::kNoStore);
  CHECK_THAT(missing.body, Catch::Contains("href=\"./../../\""));
  CHECK_FALSE(field_of(missing, "Content-Security-Policy").empty());
  const http::Response none = site_answer(nullptr, request_of("/"));
  CHECK(none.status == 404);
  CHECK_THAT(none.body, Catch::Contains("--web"));
}

TEST_CASE("Accept-Encoding lists names in any case, with weights") {
  for (const std::string list : {"br", "BR", "gzip, br", "gzip,br;q=1", " br ; q=0.1", "br;q=0.01", "br;"})
    CHECK(accepts_encoding(list, "br"));
  for (const std::string list : {"", "b", "brr", "br;q=0", "br;Q=0.000", "br; q=0", ",,", "gzip", "*"})
    CHECK_FALSE(accepts_encoding(list, "br"));
}
