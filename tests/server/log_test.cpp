// Log lines: untrusted text in them, and their JSON form.
#include <algorithm>
#include <string>

#include <rapidcheck.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/log/escape.h"
#include "runtime/log/json_lines.h"
#include "runtime/log/program_line.h"
#include "runtime/log/text_lines.h"
#include "runtime/log/utc_time.h"

using namespace talus::server;

namespace {

std::string json_line(const std::string& text) {
  spdlog::memory_buf_t out;
  JsonLines{}.format({"talusd", spdlog::level::warn, text}, out);
  return {out.data(), out.size()};
}

}  // namespace

TEST_CASE("escaped text is printable ASCII and bounded, whatever it was") {
  CHECK(rc::check([](const std::string& text) {
    const std::string safe = escaped(text, 20);
    RC_ASSERT(safe.size() <= 20 * 4 + 3);
    for (const char c : safe) RC_ASSERT(c >= ' ' && c <= '~');
  }));
}

TEST_CASE("printable text is left as it is") {
  CHECK(escaped("talus-client 1.0 (x86)") == "talus-client 1.0 (x86)");
  CHECK(escaped("a\nb\"\\") == "a\\x0ab\\x22\\x5c");
}

TEST_CASE("a time is text in UTC, in English") {
  using std::chrono::seconds;
  using std::chrono::sys_seconds;
  CHECK(utc_time(sys_seconds{seconds{784111777}}, "%a, %d %b %Y %H:%M:%S") == "Sun, 06 Nov 1994 08:49:37");
  CHECK(utc_time(sys_seconds{seconds{-1}}, "%Y-%m-%dT%H:%M:%S") == "1969-12-31T23:59:59");
}

TEST_CASE("a line of text has no control characters but its end, whatever it says") {
  spdlog::memory_buf_t out;
  TextLines{}.format({"talusd", spdlog::level::warn,
                      "/a\x1b[2J\nb\x7f\xc3\xa9\xc2\x9b"
                      "c\x9b\xe2\x82: cannot be read"},
                     out);
  const std::string line{out.data(), out.size()};
  CHECK_THAT(line, Catch::EndsWith(
                       " warning /a\\x1b[2J\\x0ab\\x7f\xc3\xa9\\xc2\\x9bc\\x9b\\xe2\\x82: cannot be read\n"));
  CHECK(std::count(line.begin(), line.end(), '\n') == 1);
}

TEST_CASE("a cut text ends in dots, and one that just fits does not") {
  CHECK(escaped("12345", 5) == "12345");
  CHECK(escaped("123456", 5) == "12345...");
}

TEST_CASE("a line before there is a log is one line, in the log's format, and obeyed by no terminal") {
  const std::string text = "/tmp/\x1b[31m\n\"a\"\xff: no such file";
  CHECK(program_line("text", LogLevel::error, text) ==
        "talusd: /tmp/\\x1b[31m\\x0a\"a\"\\xff: no such file\n");
  CHECK(program_line("text", LogLevel::warn, "a") == "talusd: warning: a\n");
  const std::string line = program_line("json", LogLevel::error, text);
  CHECK(std::count(line.begin(), line.end(), '\n') == 1);
  const auto object = nlohmann::json::parse(line);
  CHECK(object.at("level") == "error");
  CHECK(object.at("text") == "/tmp/\\x1b[31m\\x0a\"a\"\\xff: no such file");
}

TEST_CASE("a log line is one JSON object, whatever its text") {
  const std::string text = GENERATE(as<std::string>{}, "plain", "a \"quote\"\nand a line",
                                    "not UTF-8: \xff\xfe", std::string{"nul\0here", 8});
  const std::string line = json_line(text);
  CHECK(std::count(line.begin(), line.end(), '\n') == 1);
  const auto object = nlohmann::json::parse(line);
  CHECK(object.at("level") == "warning");
  if (text.find('\xff') == std::string::npos) CHECK(object.at("text") == text);
  CHECK(object.at("time").get<std::string>().size() == std::string{"2026-01-01T00:00:00.000Z"}.size());
}

TEST_CASE("a line with fields has them if lines are JSON, and only its text if they are text") {
  spdlog::details::log_msg line{spdlog::source_loc{"http", 1, R"({"status":200})"}, "talusd",
                                spdlog::level::info, "GET /"};
  spdlog::memory_buf_t json;
  JsonLines{}.format(line, json);
  const auto object = nlohmann::json::parse(std::string{json.data(), json.size()});
  CHECK(object["text"] == "GET /");
  CHECK(object["http"]["status"] == 200);
  spdlog::memory_buf_t text;
  TextLines{}.format(line, text);
  CHECK_THAT((std::string{text.data(), text.size()}), Catch::EndsWith("info GET /\n"));
}
