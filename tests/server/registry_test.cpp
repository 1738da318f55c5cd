#include "net/registry.h"

#include <catch2/catch.hpp>

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

struct FakePeer final : Peer {
  void go_away(const std::string& reason, std::chrono::milliseconds) override { told.push_back(reason); }
  void access_changed() override { told.emplace_back("look at your token"); }
  void rates_changed() override { told.emplace_back("look at your rates"); }
  std::vector<std::string> told;
};

}  // namespace

TEST_CASE("all peers are told to go, and those that come later") {
  Registry registry;
  const auto before = std::make_shared<FakePeer>();
  const auto gone = std::make_shared<FakePeer>();
  const auto later = std::make_shared<FakePeer>();
  registry.add(1, before);
  registry.add(2, gone);
  registry.remove(2);
  CHECK(before->told.empty());
  registry.tell_all_to_go("the end", 1s);
  registry.add(3, later);
  CHECK(before->told == std::vector<std::string>{"the end"});
  CHECK(later->told == std::vector<std::string>{"the end"});
  CHECK(gone->told.empty());
}

TEST_CASE("all open peers learn that tokens were revoked or flows blocked, and of new rates") {
  Registry registry;
  const auto open = std::make_shared<FakePeer>();
  const auto gone = std::make_shared<FakePeer>();
  registry.add(1, open);
  registry.add(2, gone);
  registry.remove(2);
  registry.access_changed();
  registry.rates_changed();
  CHECK(open->told == std::vector<std::string>{"look at your token", "look at your rates"});
  CHECK(gone->told.empty());
}

TEST_CASE("who waits for the last peer is told once, at once where there is none") {
  Registry registry;
  int told = 0;
  registry.when_empty([&] { ++told; });
  CHECK(told == 1);
  const auto peer = std::make_shared<FakePeer>();
  registry.add(1, peer);
  registry.add(2, peer);
  registry.when_empty([&] { ++told; });
  registry.remove(1);
  CHECK(told == 1);
  registry.remove(2);
  CHECK(told == 2);
  registry.add(3, peer);
  registry.remove(3);
  CHECK(told == 2);
}
