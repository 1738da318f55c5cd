#include <talus/progress/progress_bar.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

using talus::progress_line;
using talus::ProgressBar;

namespace {

/// A bar's output on a clock of its own.
class Output {
 public:
  [[nodiscard]] ProgressBar::Place place(bool terminal, bool lines) {
    return {file_.get(), terminal, lines, [this] { return now_; }};
  }
  void wait(std::chrono::milliseconds time) { now_ += time; }

  [[nodiscard]] std::string text() const {
    std::rewind(file_.get());
    std::array<char, 1024> bytes{};
    return {bytes.data(), std::fread(bytes.data(), 1, bytes.size(), file_.get())};
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{std::tmpfile(), &std::fclose};
  ProgressBar::Clock::time_point now_{};
};

}  // namespace

TEST_CASE("a progress line says how far, how fast and how long still") {
  CHECK(progress_line(0.5, 240, 2.0, "chunks") ==
        "[############............]  50 %  120.0 chunks/s  2 s left");
  CHECK(progress_line(0.25, 100, 100.0, "chunks") ==
        "[######..................]  25 %  1.0 chunks/s  5 min 0 s left");
}

TEST_CASE("a high rate has a prefix") {
  CHECK(progress_line(1, 2'400, 1, "columns") ==
        "[########################] 100 %  2.4 k columns/s  0 s left");
  CHECK(progress_line(1, 3'000'000, 1, "columns") ==
        "[########################] 100 %  3.0 M columns/s  0 s left");
}

TEST_CASE("a progress line stays a line before the beginning and past the end") {
  CHECK(progress_line(0, 0, 0, "rows") == "[........................]   0 %");
  CHECK(progress_line(1.7, 10, 10.0, "rows") == "[########################] 100 %  1.0 rows/s  0 s left");
}

TEST_CASE("without a terminal, a line every ten seconds reports the progress") {
  using namespace std::chrono_literals;
  Output output;
  ProgressBar bar{"map", "columns", output.place(false, true)};
  bar.expect(400);
  for (int tenth = 0; tenth < 250; ++tenth) {
    output.wait(100ms);
    bar.advance(1);
  }
  CHECK(output.text() ==
        "map: 25 %, 10.0 columns/s, 30 s left\n"
        "map: 50 %, 10.0 columns/s, 20 s left\n");
}

TEST_CASE("log lines appear only on a terminal") {
  using namespace std::chrono_literals;
  for (const bool terminal : {false, true}) {
    Output output;
    ProgressBar bar{"joining", "bytes", output.place(terminal, false)};
    output.wait(20s);
    bar.show(0.5, 10);
    CHECK(output.text().empty() == !terminal);
  }
}
