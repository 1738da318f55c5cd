#include "runtime/log/non_blocking_sink.h"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>

#include <spdlog/logger.h>

namespace talus::server {
namespace {

/// A pipe that a logger writes to. Reading never blocks.
class LoggedPipe {
 public:
  LoggedPipe() {
    REQUIRE(::pipe2(ends_.data(), O_CLOEXEC) == 0);
    REQUIRE(::fcntl(ends_[0], F_SETFL, O_NONBLOCK) == 0);
    sink_ = std::make_shared<NonBlockingSink>(ends_[1]);
    logger_ = std::make_unique<spdlog::logger>(std::string{NonBlockingSink::kClientLogger}, sink_);
    logger_->set_pattern("%l %v");  // also of the sink
  }
  ~LoggedPipe() {
    ::close(ends_[0]);
    ::close(ends_[1]);
  }
  LoggedPipe(const LoggedPipe&) = delete;
  LoggedPipe& operator=(const LoggedPipe&) = delete;

  spdlog::logger& log() { return *logger_; }
  /// An info line of `logger` at `seconds`.
  void info_at(int seconds, std::string_view text, std::string_view logger = NonBlockingSink::kClientLogger) {
    const spdlog::log_clock::time_point time{std::chrono::seconds{seconds}};
    sink_->log({time, {}, {logger.data(), logger.size()}, spdlog::level::info, {text.data(), text.size()}});
  }
  std::string read_all() {
    std::string text;
    std::array<char, 65536> block{};
    for (ssize_t bytes = 0; (bytes = ::read(ends_[0], block.data(), block.size())) > 0;) {
      text.append(block.data(), static_cast<std::size_t>(bytes));
    }
    return text;
  }

 private:
  std::array<int, 2> ends_{};
  std::shared_ptr<NonBlockingSink> sink_;
  std::unique_ptr<spdlog::logger> logger_;
};

TEST_CASE("an unread log does not block, and reports the number of dropped lines once it is read") {
  LoggedPipe pipe;
  for (int i = 0; i < 5000; ++i) pipe.log().warn("{:0>100}", i);
  const std::string before = pipe.read_all();
  CHECK(before.size() <= 65536);
  CHECK(before.find("dropped") == std::string::npos);
  const auto written = std::count(before.begin(), before.end(), '\n');
  pipe.log().warn("after");
  const std::string after = pipe.read_all();
  CHECK_THAT(after,
             Catch::StartsWith("warning " + std::to_string(5000 - written) + " log lines were dropped"));
  CHECK_THAT(after, Catch::EndsWith("warning after\n"));
}

TEST_CASE("info lines about clients are dropped beyond the budget of a second, and other lines are not") {
  LoggedPipe pipe;
  const auto budget = NonBlockingSink::kMaxInfoLinesPerSecond;
  for (std::uint32_t i = 0; i < budget + 3; ++i) pipe.info_at(100, "x");
  CHECK(pipe.read_all().size() == budget * std::string_view{"info x\n"}.size());
  pipe.log().warn("still here");
  pipe.info_at(100, "ended", "talusd");
  const std::string text = pipe.read_all();
  CHECK_THAT(text, Catch::StartsWith("warning 3 log lines were dropped"));
  CHECK_THAT(text, Catch::Contains("warning still here\n") && Catch::EndsWith("info ended\n"));
}

TEST_CASE("each second has its own budget of info lines") {
  LoggedPipe pipe;
  const auto budget = NonBlockingSink::kMaxInfoLinesPerSecond;
  for (std::uint32_t i = 0; i < budget; ++i) pipe.info_at(100, "x");
  pipe.info_at(101, "next");
  CHECK_THAT(pipe.read_all(), Catch::EndsWith("info x\ninfo next\n"));
}

TEST_CASE("a clock that is set back does not silence info lines") {
  LoggedPipe pipe;
  const auto budget = NonBlockingSink::kMaxInfoLinesPerSecond;
  for (std::uint32_t i = 0; i < budget + 1; ++i) pipe.info_at(7200, "x");
  pipe.info_at(3600, "an hour earlier");
  CHECK_THAT(pipe.read_all(),
             Catch::EndsWith("warning 1 log lines were dropped: too many, or read too slowly\n"
                             "info an hour earlier\n"));
}

TEST_CASE("a line longer than a pipe takes at once is cut at its end") {
  LoggedPipe pipe;
  pipe.log().warn("{}", std::string(20000, 'y'));
  const std::string text = pipe.read_all();
  CHECK(text.size() == 4096);
  CHECK(text.back() == '\n');
}

}  // namespace
}  // namespace talus::server
