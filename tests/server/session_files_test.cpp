// A published world's files on the stream.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include <talus/protocol/limits.h>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;
using wire::ErrorCode;

namespace {

const std::string kModel(protocol::kMaxFilePartBytes + 10, 'm');

SessionBench::Options published() {
  SessionBench::Options options;
  options.published =
      std::make_shared<const PublishedWorld>(PublishedWorld{"seed = 1", {{"models/rock.vox", kModel}}});
  return options;
}

}  // namespace

TEST_CASE("the file of a published world comes by an empty name") {
  SessionBench bench{published()};
  bench.get_file(1);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::FilePart});
  CHECK(said[0].id == 1);
  CHECK(said[0].size == 8);
  CHECK(said[0].text == "seed = 1");
}

TEST_CASE("a long file comes in parts, from any offset on up to its end") {
  SessionBench bench{published()};
  bench.get_file(1, "models/rock.vox");
  bench.get_file(2, "models/rock.vox", kModel.size() - 10);
  bench.get_file(3, "models/rock.vox", kModel.size());
  std::vector<SessionFrame> said;
  for (auto more = bench.output(); !more.empty(); more = bench.output()) {
    said.insert(said.end(), more.begin(), more.end());
  }
  REQUIRE(kinds(said) == Kinds{Body::FilePart, Body::FilePart, Body::FilePart});
  CHECK(said[0].text == kModel.substr(0, protocol::kMaxFilePartBytes));
  CHECK(said[1].text == std::string(10, 'm'));
  CHECK(said[2].text.empty());
  for (const SessionFrame& each : said) CHECK(each.size == kModel.size());
}

TEST_CASE("an unknown file, and an offset beyond a file's end, are out of range") {
  SessionBench bench{published()};
  bench.get_file(1, "rock.vox");
  bench.get_file(2, "", 9);
  bench.get_file(3, "", UINT64_MAX);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error, Body::Error, Body::Error});
  for (const SessionFrame& each : said) {
    CHECK(each.code == ErrorCode::out_of_range);
    CHECK(each.about == wire::ErrorAbout::request);
  }
  CHECK(said[2].id == 3);
}

TEST_CASE("a file of a world that is not published is unsupported") {
  SessionBench bench;
  bench.get_file(1);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == ErrorCode::unsupported);
  CHECK(said[0].id == 1);
}

TEST_CASE("a file's id is one of the requests'") {
  SessionBench bench{published()};
  bench.get_heights(1);
  bench.get_file(1);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == ErrorCode::duplicate_id);
  bench.get_file(0);
  CHECK(bench.output().at(0).code == ErrorCode::malformed);
  CHECK(bench.session.closing());
}

TEST_CASE("of many requests for parts a few are in memory at once; the others may be cancelled") {
  SessionBench bench{published()};
  for (std::uint32_t id = 1; id <= 100; ++id) bench.get_file(id, "models/rock.vox");
  CHECK(bench.session.queued_bytes() < 3 * std::size_t{protocol::kMaxFilePartBytes});
  bench.cancel(100);
  std::size_t parts = 0;
  std::size_t cancelled = 0;
  for (auto more = bench.output(1); !more.empty(); more = bench.output(1)) {
    for (const SessionFrame& each : more) {
      if (each.kind == Body::FilePart) ++parts;
      if (each.kind == Body::Error && each.id == 100 && each.code == ErrorCode::cancelled) ++cancelled;
    }
  }
  CHECK(parts == 99);
  CHECK(cancelled == 1);
}

TEST_CASE("the bytes of a file count towards the session's rate") {
  SessionBench::Options options = published();
  options.rates = {{{}, {1000, 1000}, {}}, {}, std::chrono::seconds{1}};
  SessionBench bench{options};
  bench.get_file(1, "models/rock.vox");
  CHECK(kinds(bench.output()) == Kinds{Body::FilePart});
  bench.get_file(2, "models/rock.vox");
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == ErrorCode::overloaded);
  CHECK(said[0].retry_after_ms > 0);
}

TEST_CASE("a session that was sent away answers the files that it was asked for, and takes no more") {
  SessionBench bench{published()};
  bench.get_file(1);
  bench.get_file(2, "models/rock.vox");
  bench.get_file(3, "models/rock.vox");
  bench.session.go_away("the test ends", std::chrono::milliseconds{1});
  bench.session.pump();
  bench.get_file(4);
  Kinds all;
  for (auto more = bench.output(1); !more.empty(); more = bench.output(1)) {
    for (const SessionFrame& each : more) all.push_back(each.kind);
  }
  CHECK(std::count(all.begin(), all.end(), Body::FilePart) == 3);
  CHECK(std::count(all.begin(), all.end(), Body::Error) == 1);
  CHECK(bench.session.closing());
}
