#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "net/http/request_parser.h"

using namespace talus::server::http;

namespace {

/// Requests of `text`, fed in pieces of `piece` bytes, and the error that ends them.
struct ParseResult {
  std::vector<Request> requests;
  int error = 0;  // status; 0: none
  bool mid_request = false;
};

ParseResult parse(const std::string& text, std::size_t piece = SIZE_MAX, const RequestBounds& bounds = {}) {
  RequestParser parser{bounds};
  ParseResult parsed;
  for (std::size_t at = 0; at < text.size();) {
    const auto bytes = std::as_bytes(std::span{text}).subspan(at, std::min(piece, text.size() - at));
    const auto taken = parser.feed(bytes);
    if (!taken) {
      parsed.error = taken.error().status;
      return parsed;
    }
    at += *taken;
    if (!parser.has_request()) continue;
    parsed.requests.push_back(parser.request());
    parser.pop();
  }
  parsed.mid_request = parser.mid_request();
  return parsed;
}

const std::string kGet = "GET /metrics?all=1 HTTP/1.1\r\nHost: talus\r\nX-A:  b c \r\nAccept:\r\n\r\n";

int error_of(const std::string& text, const RequestBounds& bounds = {}) {
  return parse(text, SIZE_MAX, bounds).error;
}

}  // namespace

TEST_CASE("a target that is a whole URL gives its path") {
  const auto path_of = [](const std::string& target) {
    const ParseResult parsed = parse("GET " + target + " HTTP/1.1\r\nHost: b\r\n\r\n");
    REQUIRE(parsed.requests.size() == 1);
    return std::string{parsed.requests.front().path()};
  };
  CHECK(path_of("http://a/-/healthy") == "/-/healthy");
  CHECK(path_of("HTTP://a:9100/-/healthy?b=/c") == "/-/healthy");
  CHECK(path_of("https://[::1]:9100/metrics") == "/metrics");
  CHECK(path_of("http://a") == "/");
  CHECK(path_of("http://a?b=/c") == "/");
  CHECK(path_of("ftp://a/metrics") == "ftp://a/metrics");
  CHECK(path_of("/metrics/http://a/b") == "/metrics/http://a/b");
}

TEST_CASE("a request gives its method, target, path and fields") {
  const ParseResult parsed = parse(kGet);
  REQUIRE(parsed.requests.size() == 1);
  const Request& request = parsed.requests.front();
  CHECK(request.method == Method::get);
  CHECK(request.target == "/metrics?all=1");
  CHECK(request.path() == "/metrics");
  CHECK(request.fields.size() == 3);
  CHECK(request.list("x-a") == "b c");
  CHECK(request.has("accept"));
  CHECK(request.list("accept").empty());
  CHECK_FALSE(request.has("cookie"));
  CHECK(request.bearer_token().empty());
  CHECK(request.keep_alive);
}

TEST_CASE("a bearer token's scheme is accepted in any case, and other credentials are ignored") {
  const auto token = [](std::string credentials) {
    Request request;
    request.fields.push_back({"Authorization", std::move(credentials)});
    return request.bearer_token();
  };
  CHECK(token("Bearer aB.c") == "aB.c");
  CHECK(token("bearer aB.c") == "aB.c");
  CHECK(token("BEARER aB.c") == "aB.c");
  CHECK(token("Bearer  aB.c") == "aB.c");
  CHECK(token("Bearer").empty());
  CHECK(token("Bearer ").empty());
  CHECK(token("Basic aB.c").empty());
}

TEST_CASE("fields of one name are one list, in their order") {
  const Request request{Method::get, "/", {{"a", "1, 2"}, {"B", "3"}, {"A", "4"}}};
  CHECK(request.list("A") == "1, 2, 4");
  CHECK(request.list("c").empty());
}

TEST_CASE("a request is the same however its bytes are cut") {
  const std::string text = kGet + "HEAD /-/ready HTTP/1.0\r\nConnection: keep-alive\r\n\r\n" + kGet;
  const ParseResult whole = parse(text);
  REQUIRE(whole.requests.size() == 3);
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    const ParseResult cut = parse(text, piece);
    REQUIRE(cut.error == 0);
    REQUIRE(cut.requests.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(cut.requests[i].target == whole.requests[i].target);
      CHECK(cut.requests[i].method == whole.requests[i].method);
      CHECK(cut.requests[i].keep_alive == whole.requests[i].keep_alive);
      REQUIRE(cut.requests[i].fields.size() == whole.requests[i].fields.size());
      for (std::size_t f = 0; f < whole.requests[i].fields.size(); ++f) {
        CHECK(cut.requests[i].fields[f].name == whole.requests[i].fields[f].name);
        CHECK(cut.requests[i].fields[f].value == whole.requests[i].fields[f].value);
      }
    }
  }
}

TEST_CASE("equal requests of one connection are distinguished") {
  // Of which each comes whole, and some differ from the one before in their target alone.
  const std::string fields = " HTTP/1.1\r\nHost: a\r\nX: y\r\n\r\n";
  const std::vector<std::string> all{"GET /a" + fields,
                                     "GET /b?c=1,2;3" + fields,
                                     "GET /" + fields,
                                     "HEAD /a" + fields,
                                     "GET http://b/c" + fields,
                                     "GET /d HTTP/1.1\r\nHost: a\r\nX: yy\r\n\r\n",
                                     "GET /e HTTP/1.1\r\nHost: a\r\nX: yy\r\n\r\n",
                                     "GET /e HTTP/1.0\r\nHost: a\r\nX: yy\r\n\r\n",
                                     "GET /f HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n",
                                     "GET /g" + fields};
  std::string text;
  for (const std::string& each : all) text += each;
  const ParseResult together = parse(text);
  const ParseResult by_bytes = parse(text, 1);
  REQUIRE(together.requests.size() == all.size());
  REQUIRE(by_bytes.requests.size() == all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Request alone = parse(all[i]).requests.at(0);
    for (const Request& request : {together.requests[i], by_bytes.requests[i]}) {
      CHECK(request.target == alone.target);
      CHECK(request.method == alone.method);
      CHECK(request.keep_alive == alone.keep_alive);
      CHECK(request.list("Host") == "a");
      CHECK(request.fields.size() == alone.fields.size());
      CHECK(request.fields.back().value == alone.fields.back().value);
    }
  }
  CHECK(parse("GET /a" + fields + "GET /\x01" + fields).error == 400);
  CHECK(parse("GET /a" + fields + "GET a" + fields).error == 400);
  CHECK(parse("GET /a" + fields + "GET /" + std::string(RequestBounds{}.target_bytes, 'b') + fields).error ==
        414);
}

TEST_CASE("a request takes no byte of the next one") {
  RequestParser parser;
  const std::string text = kGet + "GET / HTTP/1.1\r\n";
  const auto taken = parser.feed(std::as_bytes(std::span{text}));
  REQUIRE(taken.has_value());
  CHECK(*taken == kGet.size());
  CHECK(parser.has_request());
  CHECK(parser.feed(std::as_bytes(std::span{text})).value() == 0);
}

TEST_CASE("half a request is neither a request nor an error") {
  const ParseResult parsed = parse(kGet.substr(0, kGet.size() - 1));
  CHECK(parsed.requests.empty());
  CHECK(parsed.error == 0);
  CHECK(parsed.mid_request);
  CHECK_FALSE(parse(kGet).mid_request);
}

TEST_CASE("the version and the field decide if a connection is kept open") {
  const auto keeps = [](const std::string& text) { return parse(text).requests.at(0).keep_alive; };
  CHECK(keeps("GET / HTTP/1.1\r\nHost: a\r\n\r\n"));
  CHECK_FALSE(keeps("GET / HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n"));
  CHECK_FALSE(keeps("GET / HTTP/1.0\r\n\r\n"));
  CHECK(keeps("GET / HTTP/1.0\r\nConnection: keep-alive\r\n\r\n"));
}

TEST_CASE("a request that is not HTTP is a 400") {
  CHECK(error_of("\x16\x03\x01 this is not HTTP\r\n\r\n") == 400);
  CHECK(error_of("GET / HTTP/1.1\r\nHost: a\r\nNo colon\r\n\r\n") == 400);
  CHECK(error_of("GET / HTTP/1.1\r\nHost: a\r\nX: a\x01\r\n\r\n") == 400);
  CHECK(error_of("GET / HTTP/1.1\r\nHost: a\r\nX : b\r\n\r\n") == 400);
}

TEST_CASE("an HTTP/1.1 request without one Host is a 400") {
  CHECK(error_of("GET / HTTP/1.1\r\n\r\n") == 400);
  CHECK(error_of("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n") == 400);
}

TEST_CASE("another version of HTTP, or a missing one, is a 400") {
  for (const char* const version :
       {" HTTP/2.0", " HTTP/0.9", " HTTP/11.1", " HTTP/1", " HTTPS/1.1", " http/1.1", ""})
    CHECK(error_of(std::string{"GET /"} + version + "\r\nHost: a\r\n\r\n") == 400);
}

TEST_CASE("a line that ends with LF alone is a 400, however its bytes are cut") {
  for (const char* const text : {"GET / HTTP/1.1\nHost: a\r\n\r\n", "GET / HTTP/1.1\r\nHost: a\n\r\n",
                                 "GET / HTTP/1.1\r\nHost: a\r\n\n", "\nGET / HTTP/1.1\r\nHost: a\r\n\r\n"}) {
    for (const std::size_t piece : {std::size_t{1}, std::size_t{3}, SIZE_MAX}) {
      CHECK(parse(text, piece).error == 400);
    }
  }
}

TEST_CASE("a header line that continues the one before it is a 400, however its bytes are cut") {
  for (const char* const fields : {"X: a\r\n b\r\n", "X: a\r\n\tb\r\n", "X:\r\n a\r\n", "X: a\r\n \r\n",
                                   " X: a\r\n", "\tX: a\r\n", "Content-Length:\r\n 0\r\n"}) {
    const std::string text = std::string{"GET / HTTP/1.1\r\nHost: a\r\n"} + fields + "\r\n";
    INFO(text);
    for (std::size_t piece = 1; piece <= text.size(); ++piece) CHECK(parse(text, piece).error == 400);
  }
  CHECK(error_of("GET / HTTP/1.1\r\n Host: a\r\n\r\n") == 400);
  const ParseResult spaces = parse("GET / HTTP/1.1\r\nHost: a\r\nX:  \t \r\nY: \t b\t \r\n\r\n");
  REQUIRE(spaces.requests.size() == 1);
  CHECK(spaces.requests.front().list("X").empty());
  CHECK(spaces.requests.front().list("Y") == "b");
}

TEST_CASE("HTTP/1.0 asks for no other protocol, and nothing that follows is a request") {
  const std::string fields = "Host: a\r\nConnection: Upgrade, keep-alive\r\nUpgrade: websocket\r\n\r\n";
  const Request old = parse("GET / HTTP/1.0\r\n" + fields).requests.at(0);
  CHECK_FALSE(old.upgrade);
  CHECK_FALSE(old.keep_alive);
  const Request now = parse("GET / HTTP/1.1\r\n" + fields).requests.at(0);
  CHECK(now.upgrade);
  CHECK(now.keep_alive);
}

TEST_CASE("a malformed Host is a 400") {
  const auto error = [](const std::string& host) {
    return error_of("GET / HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
  };
  for (const char* const host : {"a b", "a/b", "a@b", "a#b", "a?b", "a\\b", "<a>", "h\xc3\xb6he"}) {
    CAPTURE(host);
    CHECK(error(host) == 400);
  }
  for (const char* const host : {"", "a", "a.example:80", "[::1]:80", "a_b", "a."}) {
    CAPTURE(host);
    CHECK(error(host) == 0);
  }
}

TEST_CASE("a method that HTTP does not have is a 400, and one that it has is a request") {
  for (const char* const method : {"FETCH", "get", "G\xC3\x8BT", "GET\t", "PRI", ""})
    CHECK(error_of(std::string{method} + " / HTTP/1.1\r\nHost: a\r\n\r\n") == 400);
  for (const char* const method : {"DELETE", "TRACE", "PATCH"}) {
    const ParseResult parsed = parse(std::string{method} + " / HTTP/1.1\r\nHost: a\r\n\r\n");
    REQUIRE(parsed.requests.size() == 1);
    CHECK(parsed.requests.front().method == Method::other);
  }
  const ParseResult options = parse("OPTIONS * HTTP/1.1\r\nHost: a\r\n\r\n");
  REQUIRE(options.requests.size() == 1);
  CHECK(options.requests.front().method == Method::options);
}

TEST_CASE("a client that would rather speak another protocol is served by this one") {
  const std::string upgrade = "Connection: Upgrade\r\nUpgrade: h2c\r\n";
  CHECK(parse("GET / HTTP/1.1\r\nHost: a\r\n" + upgrade + "\r\n" + kGet).requests.size() == 2);
  CHECK(parse("CONNECT a:1 HTTP/1.1\r\nHost: a\r\n\r\n").requests.at(0).method == Method::other);
}

TEST_CASE("a body is a 413 and an expectation of one a 417") {
  const std::string head = "POST / HTTP/1.1\r\nHost: a\r\n";
  CHECK(error_of(head + "Content-Length: 1\r\n\r\n") == 413);
  CHECK(error_of(head + "Content-Length: 99999999999999\r\n\r\n") == 413);
  CHECK(error_of(head + "Transfer-Encoding: chunked\r\n\r\n") == 413);
  CHECK(error_of(head + "Expect: 100-continue\r\n\r\n") == 417);
  CHECK(error_of(head + "Content-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n") == 400);
  CHECK(error_of(head + "Content-Length: -1\r\n\r\n") == 400);
  CHECK(parse(head + "Content-Length: 0\r\n\r\n").requests.at(0).method == Method::other);
}

TEST_CASE("a target up to the bound is taken, one byte more is a 414") {
  const RequestBounds bounds;
  const auto get = [](std::size_t bytes) {
    return "GET /" + std::string(bytes - 1, 'a') + " HTTP/1.1\r\nHost: a\r\n\r\n";
  };
  CHECK(parse(get(bounds.target_bytes)).requests.size() == 1);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, SIZE_MAX}) {
    CHECK(parse(get(bounds.target_bytes + 1), piece).error == 414);
  }
}

TEST_CASE("fields up to the bounds are taken, one more or one byte more is a 431") {
  const RequestBounds bounds;
  const auto get = [](const std::string& fields) {
    return "GET / HTTP/1.1\r\nHost: a\r\n" + fields + "\r\n";
  };
  std::string most;
  for (std::size_t field = 1; field < bounds.fields; ++field) most += "X: y\r\n";
  CHECK(parse(get(most)).requests.size() == 1);
  CHECK(error_of(get(most + "X: y\r\n")) == 431);

  CHECK(parse(get("X: " + std::string(bounds.field_bytes - 1, 'y') + "\r\n")).requests.size() == 1);
  CHECK(error_of(get("X: " + std::string(bounds.field_bytes, 'y') + "\r\n")) == 431);
  CHECK(error_of(get(std::string(bounds.field_bytes + 1, 'x') + ": y\r\n")) == 431);
}

TEST_CASE("a head of more than its bound is a 431, whatever it is made of") {
  const RequestBounds bounds;
  std::string fields;
  for (int field = 0; field < 10; ++field) fields += "X: " + std::string(4000, 'y') + "\r\n";
  CHECK(error_of("GET / HTTP/1.1\r\nHost: a\r\n" + fields + "\r\n") == 431);
  std::string empty_lines;
  for (std::size_t line = 0; line <= bounds.head_bytes; ++line) empty_lines += "\r\n";
  CHECK(error_of(empty_lines) == 431);
}

TEST_CASE("after an error nothing more is taken") {
  RequestParser parser;
  const std::string wrong = "?\r\n\r\n";
  CHECK_FALSE(parser.feed(std::as_bytes(std::span{wrong})).has_value());
  CHECK_FALSE(parser.feed(std::as_bytes(std::span{kGet})).has_value());
}
