#include "log/patient_sink.h"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include <spdlog/logger.h>

namespace talus::server {
namespace {

/// A pipe that a logger writes into; reading never waits.
class LoggedPipe {
 public:
  LoggedPipe() {
    REQUIRE(::pipe2(ends_.data(), O_CLOEXEC) == 0);
    REQUIRE(::fcntl(ends_[0], F_SETFL, O_NONBLOCK) == 0);
    sink_ = std::make_shared<PatientSink>(ends_[1]);
    logger_ = std::make_unique<spdlog::logger>(std::string{PatientSink::kOfClients}, sink_);
    logger_->set_pattern("%l %v");
  }
  ~LoggedPipe() {
    ::close(ends_[0]);
    ::close(ends_[1]);
  }
  LoggedPipe(const LoggedPipe&) = delete;
  LoggedPipe& operator=(const LoggedPipe&) = delete;

  spdlog::logger& log() { return *logger_; }
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
  std::shared_ptr<PatientSink> sink_;
  std::unique_ptr<spdlog::logger> logger_;
};

TEST_CASE("A log that nobody reads holds nobody up, and tells what it lost when it is read again") {
  LoggedPipe pipe;
  for (int i = 0; i < 5000; ++i) pipe.log().warn("{:0>100}", i);
  const std::string before = pipe.read_all();
  CHECK(before.size() <= 65536);
  CHECK(before.find("left out") == std::string::npos);
  pipe.log().warn("after");
  const std::string after = pipe.read_all();
  CHECK(after.find("log lines were left out") != std::string::npos);
  CHECK(after.find("warning after\n") != std::string::npos);
}

TEST_CASE("Clients' info lines past the budget of a second are left out and counted; all else is said") {
  LoggedPipe pipe;
  const auto most = PatientSink::kInfoLinesASecond;
  // Twice two seconds' budget, in case a second ends on the way.
  for (std::uint32_t i = 0; i < 4 * most; ++i) pipe.log().info("x");
  pipe.log().warn("still here");
  pipe.log().clone("talusd")->info("ended");
  const std::string text = pipe.read_all();
  CHECK(std::count(text.begin(), text.end(), 'x') < 4 * most);
  CHECK(text.find("log lines were left out") != std::string::npos);
  CHECK(text.find("warning still here\n") != std::string::npos);
  CHECK(text.find("info ended\n") != std::string::npos);
}

TEST_CASE("A line longer than a pipe takes at once is cut, not torn") {
  LoggedPipe pipe;
  pipe.log().warn("{}", std::string(20000, 'y'));
  const std::string text = pipe.read_all();
  CHECK(text.size() == 4096);
  CHECK(text.back() == '\n');
}

}  // namespace
}  // namespace talus::server
