#include "config/access/blocked_flows.h"

#include <catch2/catch.hpp>
#include <string>

#include "config/access/access_control.h"
#include "scratch_directory.h"

using namespace talus::server;

namespace {

BlockedFlows list(const std::string& text) {
  auto parsed = BlockedFlows::parse(text);
  INFO((parsed ? std::string{} : parsed.error()));
  REQUIRE(parsed.has_value());
  return *std::move(parsed);
}

std::size_t line_for(const BlockedFlows& blocked, const std::string& address) {
  const auto* const line = blocked.find(asio::ip::make_address(address));
  return line == nullptr ? 0 : line->number();
}

}  // namespace

TEST_CASE("a list names addresses, networks and subjects") {
  const BlockedFlows blocked = list(
      "# the flood of Monday\n\n"
      "  203.0.113.9\r\n"
      "198.51.100.0/24\n"
      "2001:db8:0:1::/64\n"
      "2001:db8:0:1::7\n"
      "subject alice of the hills \n"
      "subject \\xc3\\x85sa\n"
      "subject subject\n");
  CHECK(blocked.size() == 7);
  CHECK(line_for(blocked, "203.0.113.9") == 3);
  CHECK(line_for(blocked, "::ffff:203.0.113.9") == 3);
  CHECK(line_for(blocked, "203.0.113.8") == 0);
  CHECK(line_for(blocked, "198.51.100.255") == 4);
  CHECK(line_for(blocked, "198.51.101.0") == 0);
  CHECK(line_for(blocked, "2001:db8:0:1:ffff::1") == 5);
  CHECK(line_for(blocked, "2001:db8:0:1::7") == 6);
  CHECK(line_for(blocked, "2001:db8:0:2::") == 0);
  CHECK(blocked.find_subject("alice of the hills") != nullptr);
  CHECK(blocked.find_subject("alice") == nullptr);
  CHECK(blocked.find_subject("") == nullptr);
  CHECK(blocked.find_subject("subject") != nullptr);
  // As the log shows it.
  CHECK(blocked.find_subject("\xc3\x85sa") != nullptr);
}

TEST_CASE("an IPv4 network does not reach into IPv6, and all of one family can be blocked") {
  CHECK(line_for(list("0.0.0.0/0"), "192.0.2.1") == 1);
  CHECK(line_for(list("0.0.0.0/0"), "2001:db8::1") == 0);
  CHECK(line_for(list("::/0"), "2001:db8::1") == 1);
}

TEST_CASE("a subject that ends as if it were cut can be blocked") {
  const BlockedFlows blocked = list("subject a..\\x2e\nsubject b\\x2e\n");
  CHECK(blocked.find_subject("a...") != nullptr);
  CHECK(blocked.find_subject("a..") == nullptr);
  CHECK(blocked.find_subject("b\\x2e") != nullptr);
  CHECK(blocked.find_subject("b.") == nullptr);
}

TEST_CASE("each line is new to the log once") {
  const BlockedFlows blocked = list("192.0.2.1\nsubject a\n");
  CHECK(blocked.find(asio::ip::make_address("192.0.2.1"))->meet());
  CHECK_FALSE(blocked.find(asio::ip::make_address("192.0.2.1"))->meet());
  CHECK(blocked.find_subject("a")->meet());
  CHECK_FALSE(blocked.find_subject("a")->meet());
}

TEST_CASE("a bad line is an error that names its number and what is wrong") {
  const auto [line, part] = GENERATE(
      table<std::string, std::string>({{"subject", "no NAME after subject"},
                                       {"subject alice...", "take the whole subject from /flows.json"},
                                       {"subjects alice", "is not an address"},
                                       {"alice", "is not an address"},
                                       {"203.0.113", "is not an address"},
                                       {"203.0.113.256", "is not an address"},
                                       {"203.0.113.9:4780", "is not an address"},
                                       {"[2001:db8::1]", "is not an address"},
                                       {"fe80::1%1", "is not an address"},
                                       {"203.0.113.9 # him", "is not an address"},
                                       {"203.0.113.9, 203.0.113.10", "is not an address"},
                                       {"203.0.113.9/", "has no length from 0 to 32"},
                                       {"203.0.113.0/33", "has no length from 0 to 32"},
                                       {"203.0.113.0/x", "has no length from 0 to 32"},
                                       {"2001:db8::/129", "has no length from 0 to 128"},
                                       {"2001:db8::/0064", "has no length from 0 to 128"},
                                       {"203.0.113.9/24", "has bits set after its length"},
                                       {"2001:db8::1/64", "has bits set after its length"},
                                       {"\x1b[2J", "\\x1b[2J"}}));
  CAPTURE(line);
  const auto parsed = BlockedFlows::parse("# fine\n192.0.2.1\n" + line + "\n192.0.2.2\n");
  REQUIRE_FALSE(parsed.has_value());
  CHECK_THAT(parsed.error(), Catch::StartsWith("line 3: ") && Catch::Contains(part));
  CHECK(parsed.error().find('\n') == std::string::npos);
}

TEST_CASE("a bad list is an error of its setting, and a reload with it keeps the old one") {
  const ScratchDirectory scratch;
  Access settings;
  settings.blocked_file = scratch.write("blocked", "192.0.2.1\n");
  AccessControl access{settings, *load_keys(settings)};
  const auto address = asio::ip::make_address("192.0.2.1");
  CHECK(access.blocks(address));
  (void)scratch.write("blocked", "192.0.2.2\nrubbish\n");
  const auto failed = access.reload(settings);
  REQUIRE_FALSE(failed.has_value());
  CHECK_THAT(failed.error(), Catch::StartsWith("access.blocked_file ") &&
                                 Catch::Contains("blocked: line 2: ") && Catch::Contains("old list stays"));
  CHECK(access.blocks(address));
  settings.blocked_file.clear();
  REQUIRE(access.reload(settings).has_value());
  CHECK_FALSE(access.blocks(address));
}
