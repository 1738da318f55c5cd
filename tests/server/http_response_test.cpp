#include <catch2/catch.hpp>

#include "net/http/response.h"

using namespace talus::server::http;

namespace {

std::string head_of(const Response& response, bool keep_alive, std::chrono::sys_seconds date) {
  std::string head;
  append_head(head, response, keep_alive, date);
  return head;
}

}  // namespace

TEST_CASE("a response's head says its status, date, length and what becomes of the connection") {
  const std::chrono::sys_seconds date{std::chrono::seconds{784'111'777}};
  CHECK(head_of({404, kPlainText, "nothing\n"}, true, date) ==
        "HTTP/1.1 404 Not Found\r\nDate: Sun, 06 Nov 1994 08:49:37 GMT\r\n"
        "Content-Type: text/plain; charset=utf-8\r\nCache-Control: no-store\r\nConnection: keep-alive\r\n"
        "Content-Length: 8\r\n\r\n");
}

TEST_CASE("further fields stand in the head") {
  const std::string head = head_of({405, kPlainText, "", {{"Allow", "GET, HEAD"}}}, false, {});
  CHECK_THAT(head, Catch::Contains("\r\nAllow: GET, HEAD\r\n") &&
                       Catch::Contains("\r\nConnection: close\r\n") && Catch::EndsWith("\r\n\r\n"));
}

TEST_CASE("a tag and leave for every page are in the head only if they are given") {
  Response response{200, kPlainText, "a"};
  CHECK_THAT(head_of(response, true, {}), !Catch::Contains("ETag") && !Catch::Contains("Access-Control"));
  response.any_origin = true;
  response.etag.emplace().fill('7');
  CHECK_THAT(head_of(response, true, {}),
             Catch::Contains("\r\nETag: 7777777777777777777777777777777777\r\n") &&
                 Catch::Contains("\r\nAccess-Control-Allow-Origin: *\r\n"));
  response.any_origin = false;  // the lines before it are kept for the next answer
  CHECK_THAT(head_of(response, true, {}), !Catch::Contains("Access-Control"));
}

TEST_CASE("an invalid request gets its error as one line") {
  const Response response = response_to({431, "too much"});
  CHECK(response.status == 431);
  CHECK(response.body == "too much\n");
}

TEST_CASE("responses that cannot have a body say nothing of one") {
  for (const int status : {204, 304}) {
    const std::string head = head_of({status, kPlainText, "", {{"ETag", "\"a\""}}, kNoCache}, true, {});
    CHECK_THAT(head, !Catch::Contains("Content-") && Catch::Contains("\r\nCache-Control: no-cache\r\n") &&
                         Catch::Contains("\r\nETag: \"a\"\r\n"));
  }
  CHECK_THAT(head_of({101}, true, {}), !Catch::Contains("Content-") && !Catch::Contains("Cache-Control") &&
                                           Catch::Contains("\r\nConnection: Upgrade\r\n"));
}
