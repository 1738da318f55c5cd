#include <catch2/catch.hpp>

#include "http/response.h"

using namespace talus::server::http;

TEST_CASE("a response's head says its status, date, length and what becomes of the connection") {
  const std::chrono::sys_seconds date{std::chrono::seconds{784'111'777}};
  CHECK(head_of({404, kPlainText, "nothing\n"}, true, date) ==
        "HTTP/1.1 404 Not Found\r\nDate: Sun, 06 Nov 1994 08:49:37 GMT\r\n"
        "Content-Type: text/plain; charset=utf-8\r\nContent-Length: 8\r\nCache-Control: no-store\r\n"
        "Connection: keep-alive\r\n\r\n");
}

TEST_CASE("further fields stand in the head") {
  const std::string head = head_of({405, kPlainText, "", {{"Allow", "GET, HEAD"}}}, false, {});
  CHECK_THAT(head, Catch::Contains("\r\nAllow: GET, HEAD\r\n") &&
                       Catch::Contains("\r\nConnection: close\r\n") && Catch::EndsWith("\r\n\r\n"));
}

TEST_CASE("a request that is no request gets its error as one line") {
  const Response response = response_to({431, "too much"});
  CHECK(response.status == 431);
  CHECK(response.body == "too much\n");
}
