#include "net/registry.h"

#include <catch2/catch.hpp>

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

struct FakePeer final : Peer {
  explicit FakePeer(std::optional<Clock::time_point> session = Clock::time_point{1s}) : since{session} {}
  [[nodiscard]] std::optional<Clock::time_point> session_since() const override { return since; }
  void go_away(const std::string& reason, std::chrono::milliseconds) override { told.push_back(reason); }
  void access_changed() override { told.emplace_back("look at your token"); }
  void rates_changed() override { told.emplace_back("look at your rates"); }
  std::optional<Clock::time_point> since;
  std::vector<std::string> told;
};

}  // namespace

TEST_CASE("all peers are asked to leave, and later ones too") {
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

TEST_CASE("the longest connected of some peers are asked to leave first, and each only once") {
  Registry registry;
  std::vector<std::shared_ptr<FakePeer>> peers;
  for (const ConnectionId id : {30, 10, 20}) {
    peers.push_back(std::make_shared<FakePeer>(Clock::time_point{1s * id}));
    registry.add(id, peers.back());
  }
  const auto web = std::make_shared<FakePeer>(std::nullopt);
  registry.add(5, web);
  const auto told = [&] {
    std::vector<std::size_t> counts;
    for (const auto& peer : peers) counts.push_back(peer->told.size());
    return counts;
  };
  CHECK(registry.sessions().staying == 3);
  CHECK(registry.tell_to_go(1, {}, Clock::time_point::max(), "more room", 0ms) == 1);
  CHECK(told() == std::vector<std::size_t>{0, 1, 0});
  CHECK(registry.tell_to_go(9, {}, Clock::time_point{30s}, "more room", 0ms) == 1);
  CHECK(told() == std::vector<std::size_t>{0, 1, 1});
  CHECK(registry.sessions().staying == 1);
  CHECK(registry.sessions().leaving == 2);
  registry.remove(10);
  CHECK(registry.sessions().leaving == 1);
  CHECK(web->told.empty());
  registry.tell_others_to_go("the end");
  CHECK(web->told == std::vector<std::string>{"the end"});
  registry.tell_all_to_go("the end", 0ms);
  CHECK(told() == std::vector<std::size_t>{1, 1, 1});
  CHECK(web->told.size() == 1);
}

TEST_CASE("a waiter for the last peer is notified once, at once if there is no peer") {
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
