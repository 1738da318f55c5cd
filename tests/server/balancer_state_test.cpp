#include "net/balancer_state.h"

#include <catch2/catch.hpp>
#include <string>

using namespace talus::server;

namespace {

// As HAProxy 2.6 sends it.
const std::string kSaid =
    "UP 1/2; address=10.0.0.7; port=4781; name=talus/a; node=lb; weight=1/3; scur=250/500; qcur=0";

std::string with(const std::string& part, const std::string& other) {
  std::string text = kSaid;
  return text.replace(text.find(part), part.size(), other);
}

}  // namespace

TEST_CASE("a balancer says how many sessions it has, here and in all") {
  CHECK(read_balancer_state(kSaid) == BalancerState{1, 3, 250, 500});
  CHECK(read_balancer_state("UP; weight=2/3; scur=0/0") == BalancerState{2, 3, 0, 0});
}

TEST_CASE("an invalid state of a running server has no effect") {
  for (const std::string& text :
       {std::string{}, std::string{"UP"}, with("UP 1/2", "DOWN"), with("UP 1/2", "NOLB 1/2"),
        with("weight=1/3", "weight=0/3"), with("weight=1/3", "weight=4/3"), with("weight=1/3", "weight=1"),
        with("weight=1/3", "weight=/"), with("scur=250/500", "scur=501/500"),
        with("scur=250/500", "scur=-1/500"), with("scur=250/500", "scur=1/99999999999999999999"),
        with("scur=250/500", "scur=1/16777217"), with("scur=250/500", "sour=250/500"),
        std::string(9000, ';')}) {
    CAPTURE(text.substr(0, 120));
    CHECK_FALSE(read_balancer_state(text).has_value());
  }
}

TEST_CASE("a check may ask for another tolerance, and be about the sessions of some ports") {
  CHECK(read_balancer_query("") == BalancerQuery{});
  CHECK(read_balancer_query("above_percent=25") == BalancerQuery{25, std::nullopt});
  CHECK(read_balancer_query("above_percent=0") == BalancerQuery{0, std::nullopt});
  CHECK(read_balancer_query("above_percent=1000") == BalancerQuery{1000, std::nullopt});
  CHECK(read_balancer_query("ports=0") == BalancerQuery{std::nullopt, PortRange{0, 0}});
  CHECK(read_balancer_query("ports=4780") == BalancerQuery{std::nullopt, PortRange{4780, 4780}});
  CHECK(read_balancer_query("above_percent=25&ports=4800-4863") == BalancerQuery{25, PortRange{4800, 4863}});
  CHECK(read_balancer_query("ports=4800-65535&above_percent=25") ==
        BalancerQuery{25, PortRange{4800, 65535}});
  CHECK(read_balancer_query("ports=4800%2D4863") == BalancerQuery{std::nullopt, PortRange{4800, 4863}});
}

TEST_CASE("a check that asks for anything else is not understood, in which part is said") {
  for (const char* wrong :
       {"above_percent=", "above_percent=1001", "above_percent=-1", "above_percent=5%", "above_percent=%zz",
        "above_percent=25&x=1", "above=25", "x&above_percent=25", "ports=", "ports=-", "ports=4800-",
        "ports=-4800", "ports=4801-4800", "ports=4800-65536", "ports=4800-4863-4900", "ports=1&ports=2",
        "port=4780", "ports=4780,4781", "ports=80&&above_percent=1"}) {
    CAPTURE(wrong);
    CHECK_FALSE(read_balancer_query(wrong).has_value());
  }
  const auto refused = read_balancer_query("above_percent=25&port=4780&x");
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error() ==
        "'port=4780' is not one of above_percent=PERCENT (at most 1000), ports=PORT and ports=FIRST-LAST (at "
        "most 65535), each once");
  const auto long_one = read_balancer_query(std::string(9000, 'x'));
  REQUIRE_FALSE(long_one.has_value());
  CHECK(long_one.error().size() < 300);
}

TEST_CASE("more than its share and some is too many, by weight") {
  CHECK(sessions_above_share({1, 3, 250, 500}, 10) == 250 - 167 - 17);
  CHECK(sessions_above_share({1, 3, 184, 500}, 10) == 0);
  CHECK(sessions_above_share({1, 3, 185, 500}, 10) == 1);
  CHECK(sessions_above_share({2, 3, 340, 500}, 0) == 6);
  CHECK(sessions_above_share({1, 1, 500, 500}, 0) == 0);
  CHECK(sessions_above_share({1, 3, 1, 1}, 0) == 0);  // a player alone stays
}
