// Messages of the shared log that this talusd does not know: who passes over them, and who stops there.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "cluster/entry_codec.h"
#include "cluster_in_memory.h"
#include "sealed_again.h"

namespace talus::server {
namespace {

using namespace testing;
using namespace std::chrono_literals;
using cluster::StoreLoss;
using Kind = edits::EntryResult::Kind;

/// Messages that this talusd does not know, and those to come may.
std::vector<store::Bytes> unknown_messages() {
  const std::vector<store::Bytes> good{bytes_of_entry(attach(8))};
  std::vector<store::Bytes> messages(2, cluster::encode_batch(foreign_head(), nullptr, good));
  messages[0][0] = std::byte{9};
  messages[1][1] = std::byte{9};
  for (store::Bytes& each : messages) each = sealed_again(each);
  std::vector<store::Bytes> entries{good[0], bytes_of_entry(attach(9))};
  entries[1][0] = std::byte{7};
  messages.push_back(cluster::encode_batch(foreign_head(), nullptr, entries));
  return messages;
}

TEST_CASE("a message of a format that the stream has not enabled is passed over by all servers alike") {
  ClusterInMemory cluster{2};
  SECTION("nor any other") {}
  SECTION("but that which is known") {
    cluster.stream.enable({cluster::kLogFormat, 1});
  }
  SECTION("but from a later message on") {
    cluster.stream.enable({cluster::kLogFormat + 1, 6});
  }
  cluster.open();
  cluster.until_applied();
  for (const store::Bytes& each : unknown_messages()) cluster.stream.append(each);
  const std::vector<store::Bytes> good{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.until_applied();
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(cluster.log(i).status().skipped == 3);
    CHECK(cluster.log(i).status().head.position == 1);
    CHECK_FALSE(cluster.log(i).status().stuck);
  }
  // From where it is enabled on nobody passes over such.
  cluster.stream.enable({cluster::kLogFormat + 1, 6});
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.log(0).status().stuck && cluster.log(1).status().stuck; });
  // Who reads all of it later does as they did.
  cluster.nodes.push_back(
      std::make_unique<ClusterNode>(cluster.scratch / "late", ends_of(cluster.stream, 900), 900));
  REQUIRE(cluster.nodes.back()->open() == "");
  until([&] { return cluster.log(2).status().stuck; });
  CHECK(cluster.log(2).status().skipped == 3);
  CHECK(cluster.log(2).status().head.hash == cluster.log(0).status().head.hash);
}

TEST_CASE("the first enabled format that this talusd cannot read stops it") {
  ClusterInMemory cluster{1};
  cluster.stream.describe(fmt::format("log format {} from message 5, {} from message 9",
                                      cluster::kLogFormat + 1, cluster::kLogFormat + 2));
  cluster.open();
  for (const store::Bytes& each : unknown_messages()) cluster.stream.append(each);  // 2 to 4
  cluster.until_applied();
  CHECK(cluster.log(0).status().skipped == 3);
  CHECK_FALSE(cluster.log(0).status().stuck);
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.log(0).status().stuck || cluster.log(0).status().skipped > 3; });
  CHECK(cluster.log(0).status().stuck);
  CHECK(cluster.log(0).status().sequence == 4);
}

TEST_CASE("a description of formats that is not understood stops a server, and it says so") {
  ClusterInMemory cluster{1};
  cluster.stream.describe("log format 2 from message 5.");
  cluster.open();
  const std::vector<store::Bytes> good{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.until_applied();  // what it knows it applies
  CHECK(cluster.log(0).status().head.position == 1);
  cluster.stream.append(unknown_messages().front());
  // It is stuck before it says why.
  until([&] { return cluster.log(0).status().read_only || cluster.log(0).status().skipped > 0; });
  CHECK(cluster.log(0).status().stuck);
  CHECK(cluster.log(0).status().skipped == 0);
  CHECK_THAT(cluster.log(0).status().read_only.value_or(""),
             Catch::Contains("message 3") && Catch::Contains("it has format 9") &&
                 Catch::Contains("description") && Catch::Contains("talusd cluster check"));
  // It was a slip: once that is mended the server passes over it, as all others.
  cluster.stream.describe("log format 2 from message 5");
  cluster.nodes[0]->close();
  cluster.open();
  cluster.until_applied();
  CHECK(cluster.log(0).status().skipped == 1);
}

TEST_CASE("an unknown message is not skipped if the stream has been replaced meanwhile") {
  ClusterInMemory cluster{1};
  cluster.nodes[0]->settings.poll_interval = 1h;  // so that it is this message by which it is found
  cluster.open();
  cluster.until_applied();
  cluster.stream.make_anew();
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.lost_of(0).has_value() || cluster.log(0).status().skipped > 0; });
  CHECK(cluster.lost_of(0) == StoreLoss::other);
  CHECK(cluster.log(0).status().skipped == 0);
}

TEST_CASE("a genesis of a newer talusd stops a server, and it says what would be right") {
  ClusterInMemory cluster{1};
  cluster.stream.replace_first(of_newer_format(empty_genesis()));
  cluster.open();
  until([&] {
    return cluster.log(0).status().read_only ==
           "message 1 of the log cannot be applied: it has format 9; this talusd reads up to 1; upgrade it";
  });
}

TEST_CASE("a message that is not known waits for a leader that knows it") {
  ClusterInMemory cluster{1};
  cluster.nodes[0]->settings.poll_interval = 1h;  // so that it asks for this message alone
  cluster.open();
  cluster.until_applied();
  cluster.stream.say_fewer(1);
  cluster.stream.append(unknown_messages().front());
  const std::uint64_t asked = cluster.stream.asked;
  until([&] { return cluster.stream.asked > asked + 3; });
  CHECK(cluster.log(0).status().skipped == 0);
  cluster.stream.enable({cluster::kLogFormat + 1, 2});
  cluster.stream.say_fewer(0);
  until([&] { return cluster.log(0).status().stuck; });
  CHECK(cluster.log(0).status().skipped == 0);
}

TEST_CASE("a message of a newer talusd stops a server there, and it says why") {
  ClusterInMemory cluster{1};
  cluster.stream.enable({cluster::kLogFormat + 1, 2});
  std::string why;
  const std::vector<store::Bytes> good{bytes_of_entry(attach(8))};
  SECTION("a format") {
    store::Bytes message = cluster::encode_batch(foreign_head(), nullptr, good);
    message[0] = std::byte{9};
    cluster.stream.append(sealed_again(message));
    why = "message 2 of the log cannot be applied: it has format 9; this talusd reads up to 1; upgrade it";
  }
  SECTION("a kind") {
    store::Bytes message = cluster::encode_batch(foreign_head(), nullptr, good);
    message[1] = std::byte{9};
    cluster.stream.append(sealed_again(message));
    why = "message 2 of the log cannot be applied: it is of kind 9, which this talusd does not know";
  }
  SECTION("an entry") {
    std::vector<store::Bytes> entries = good;
    entries.push_back(bytes_of_entry(attach(9)));
    entries[1][0] = std::byte{7};
    cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, entries));
    why = "message 2 of the log cannot be applied: its entry 2 is one that this talusd does not know";
  }
  SECTION("an entry behind one that is damaged") {
    std::vector<store::Bytes> entries{bytes_of_entry(attach(8)), bytes_of_entry(attach(9))};
    entries[0].pop_back();
    entries[1][1] = std::byte{7};
    cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, entries));
    why = "message 2 of the log cannot be applied: its entry 2 is one that this talusd does not know";
  }
  // What is behind it is sound, and must not be applied.
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.open();
  until([&] { return cluster.log(0).status().not_ready.find("cannot be applied") != std::string::npos; });
  const auto status = cluster.log(0).status();
  CAPTURE(status.not_ready);
  CHECK(status.not_ready.starts_with(why));
  CHECK(status.stuck);
  CHECK(status.head.position == 0);
  CHECK(status.skipped == 0);
  Answers answers;
  const auto refused = answers.send(cluster.log(0), attach());
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().message.starts_with(why));
  CHECK_FALSE(cluster.lost_of(0).has_value());  // another store would not help
}

TEST_CASE("a message that no talusd wrote is passed over by all servers alike") {
  ClusterInMemory cluster{2};
  const std::vector<store::Bytes> entries{bytes_of_entry(attach(8)), bytes_of_entry(attach(9))};
  const store::Bytes good = cluster::encode_batch(foreign_head(), nullptr, entries);
  store::Bytes bad = good;
  SECTION("damaged") {
    bad[40] ^= std::byte{1};
  }
  SECTION("nothing") {
    bad.clear();
  }
  SECTION("an unknown word") {
    bad.assign(5, std::byte{'h'});
  }
  SECTION("of no format") {
    bad.assign(100, std::byte{0});
  }
  SECTION("of a newer one, without the checksum that all have") {
    bad[0] = std::byte{9};
  }
  SECTION("too large") {
    bad.assign(cluster::kMaxMessageBytes + 1, std::byte{1});
  }
  SECTION("of another store") {
    cluster::BatchHead head = foreign_head();
    head.identity.store_id = {9, 9};
    bad = cluster::encode_batch(head, nullptr, entries);
  }
  SECTION("of another world") {
    cluster::BatchHead head = foreign_head();
    head.identity.fingerprint = {9, 9};
    bad = cluster::encode_batch(head, nullptr, entries);
  }
  SECTION("a second genesis") {
    bad = empty_genesis();
  }
  SECTION("fields that end early") {
    bad.resize(bad.size() - 20);
    bad = sealed_again(bad);
  }
  SECTION("an entry that is damaged behind one that is not") {
    std::vector<store::Bytes> damaged = entries;
    damaged[1].pop_back();
    bad = cluster::encode_batch(foreign_head(), nullptr, damaged);
  }
  cluster.stream.append(bad);
  cluster.stream.append(good);
  cluster.open();
  cluster.until_applied();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()));
  cluster.until_applied();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto status = cluster.log(i).status();
    CAPTURE(i, status.not_ready, status.read_only.value_or(""));
    CHECK(status.skipped == 1);
    CHECK(status.head.position == 3);  // of the three that attached
    CHECK_FALSE(status.read_only.has_value());
  }
  // It is behind them when they start again.
  for (auto& node : cluster.nodes) node->close();
  cluster.open();
  cluster.until_applied();
  CHECK(cluster.log(0).status().skipped == 0);
}

TEST_CASE("a message that comes altered is asked of the log's leader, and applied as others have it") {
  ClusterInMemory cluster{1};
  std::uint64_t altered = 0;
  SECTION("a batch") {
    altered = 3;
  }
  SECTION("the genesis") {
    altered = 1;
  }
  cluster.nodes.push_back(std::make_unique<ClusterNode>(
      cluster.scratch / "altered",
      [&] {
        auto end = std::make_unique<StreamEnd>(cluster.stream, 77);
        end->alter(altered);
        return end;
      },
      900));
  cluster.open();
  for (std::uint64_t editor = 8; editor < 11; ++editor) {
    const std::vector<store::Bytes> entries{bytes_of_entry(attach(editor))};
    cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, entries));
  }
  cluster.until_applied();
  CHECK(cluster.log(1).status().skipped == 0);
  CHECK(cluster.log(1).status().head.position == 3);
  CHECK(cluster.log(1).status().head.hash == cluster.log(0).status().head.hash);
}

TEST_CASE("players may read while no server can read the next message, but not if other servers can") {
  ClusterInMemory cluster{2};
  cluster.stream.enable({cluster::kLogFormat + 1, 2});
  for (auto& node : cluster.nodes) node->settings.sure_of_stuck = 300ms;
  cluster.open();
  until([&] { return cluster.log(0).status().ready && cluster.log(1).status().ready; });
  store::Bytes message = cluster::encode_batch(foreign_head(), nullptr, {});
  message[0] = std::byte{9};
  cluster.stream.append(sealed_again(message));
  until([&] { return cluster.log(0).status().stuck && cluster.log(1).status().stuck; });
  const auto began = std::chrono::steady_clock::now();
  // Well over the time in which it would be too far behind the end, if it were looked at so.
  while (std::chrono::steady_clock::now() - began < 600ms) {
    const auto status = cluster.log(0).status();
    if (!status.ready) FAIL(status.not_ready);
    CHECK(status.read_only.value_or("").find("it has format 9") != std::string::npos);
    std::this_thread::sleep_for(20ms);
  }
  // Started again it serves as well, once it knows that it is no worse than others.
  cluster.nodes[1]->close();
  REQUIRE(cluster.nodes[1]->open() == "");
  until([&] { return cluster.log(1).status().stuck; });
  until([&] { return cluster.log(1).status().ready; });
  // A newer talusd goes on.
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, {}));
  until([&] { return !cluster.log(0).status().ready && !cluster.log(1).status().ready; });
}

}  // namespace
}  // namespace talus::server
