// Chunks of the View that are edited after they were sent: what changed comes, or the chunk again.
#include <catch2/catch.hpp>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

const ChunkKey kKey = chunk_at(5);

struct Bench : SessionBench {
  /// `remembers`: the source knows which voxels an edit changed.
  explicit Bench(bool remembers = true, std::uint64_t window_bytes = 4U << 20)
      : SessionBench{{.greet = false}}, remembers_{remembers} {
    limits.window_bytes = window_bytes;
    hello();
    (void)output();
  }
  /// The View of kKey alone, which is written.
  void see() {
    if (!source.in_memory.contains(kKey)) source.in_memory[kKey] = scripted_chunk(kKey);
    move_view(5, 0);
    REQUIRE(kinds(output()) == Kinds{Body::Chunk});
  }
  /// The first voxels change, the first of them to material 7. The chunk's new version is not in memory.
  void edit(std::uint64_t revision, std::size_t voxels = 1) {
    source.revisions[kKey] = revision;
    voxels_ = voxels;
    if (!remembers_) return;
    source.changes = [this](ChunkKey key, std::uint64_t since) -> std::optional<ChangedVoxels> {
      ChangedVoxels changed{source.revisions.at(key), {}};
      if (since >= changed.revision) return changed;
      for (std::uint16_t i = 0; i < voxels_; ++i) changed.voxels.push_back({i, MaterialId(7 + i % 5)});
      return changed;
    };
  }
  void tell(std::uint64_t previous, std::uint64_t revision) {
    mailbox->put_changes(
        std::make_shared<const std::vector<ChunkChange>>(1, ChunkChange{kKey, previous, revision}));
    take_mail();
  }

 private:
  const bool remembers_;
  std::size_t voxels_ = 1;
};

}  // namespace

TEST_CASE("an edit of a chunk that was sent is broadcast") {
  Bench bench;
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::EditBroadcast});
  CHECK(said[0].key == kKey);
  CHECK(said[0].previous_revision == 0);
  CHECK(said[0].revision == 3);
  CHECK(said[0].voxels == std::vector<Override>{{0, MaterialId{7}}});
  CHECK(bench.output().empty());
}

TEST_CASE("several edits that were not written yet are one broadcast, from what the client has") {
  Bench bench;
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  bench.edit(4);
  bench.tell(3, 4);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::EditBroadcast});
  CHECK(said[0].previous_revision == 0);
  CHECK(said[0].revision == 4);
}

TEST_CASE("a chunk of which no change is remembered comes again") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 3);
  bench.tell(0, 3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].id == 0);
  CHECK(said[0].revision == 3);
}

TEST_CASE("a chunk that is to be sent again and is not in memory is asked for") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  CHECK(bench.output().empty());
  REQUIRE(bench.source.waiting.contains(kKey));
  bench.source.mail(kKey, scripted_chunk(kKey, 3));  // and is not kept there
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 3);
  CHECK(bench.run_dry().empty());
}

TEST_CASE("an answer from before the edit is asked for again") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  CHECK(bench.output().empty());
  bench.source.mail(kKey, scripted_chunk(kKey, 0));
  bench.take_mail();
  CHECK(bench.output().empty());
  CHECK(bench.source.waiting.contains(kKey));
}

TEST_CASE("if the source is full, a chunk to be sent again waits for room") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.source.queue_places = 0;
  bench.tell(0, 3);
  CHECK(bench.output().empty());
  CHECK(bench.source.waiting.empty());
  const std::size_t refused = bench.source.refused;
  bench.tell(3, 4);  // changes of others' are no room
  CHECK(bench.source.refused == refused);
  bench.source.queue_places = 10;
  bench.mailbox->put(QueueHasRoom{});
  bench.take_mail();
  CHECK(bench.source.waiting.contains(kKey));
}

TEST_CASE("if a chunk to be sent again fails, the client gets an Error, and may ask for it") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  CHECK(bench.output().empty());
  bench.source.fail(kKey);
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].about == wire::ErrorAbout::view_chunk);
  CHECK(said[0].key == kKey);
}

TEST_CASE("more voxels than a broadcast has, or than the chunk is large, are the chunk again") {
  Bench bench;
  bench.see();
  SECTION("too many") {
    bench.edit(3, Delivery::kMaxBroadcastVoxels + 1);
    bench.source.in_memory[kKey] = scripted_chunk(kKey, 3, 100'000);
  }
  SECTION("smaller as a chunk") {
    bench.edit(3, 1000);
    bench.source.in_memory[kKey] = scripted_chunk(kKey, 3, 0);
  }
  bench.tell(0, 3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 3);
}

TEST_CASE("as many voxels as a broadcast has are one") {
  Bench bench;
  bench.see();
  bench.edit(3, Delivery::kMaxBroadcastVoxels);
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 3, 100'000);
  bench.tell(0, 3);
  CHECK(kinds(bench.output()) == Kinds{Body::EditBroadcast});
}

TEST_CASE("an edit between a chunk's making and its writing is found when it is written") {
  Bench bench;
  bench.move_view(5, 0);
  bench.source.mail(kKey, scripted_chunk(kKey));
  bench.edit(3);
  bench.tell(0, 3);  // the chunk waits to be written: nothing to do yet
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 0);
  const auto then = bench.output();
  REQUIRE(kinds(then) == Kinds{Body::EditBroadcast});
  CHECK(then[0].previous_revision == 0);
}

TEST_CASE("an edit between an Unchanged's making and its writing is found when it is written") {
  Bench bench;
  bench.say_view(5, 0, 0, {scripted_chunk(kKey)}, {kKey});
  bench.apply_view();
  bench.edit(3);
  bench.tell(0, 3);
  bench.source.mail(kKey, scripted_chunk(kKey));
  bench.take_mail();
  CHECK(kinds(bench.output()) == Kinds{Body::Unchanged, Body::EditBroadcast});
}

TEST_CASE("an edit that is reported late is broadcast once more, without harm") {
  Bench bench;
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 3);
  bench.edit(3);
  bench.move_view(5, 0);
  CHECK(bench.output().at(0).revision == 3);
  bench.tell(0, 3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::EditBroadcast});
  CHECK(said[0].revision == 3);  // what the client has: it ignores it
}

TEST_CASE("edits of chunks that are not in the View, or not sent, are not broadcast") {
  Bench bench;
  bench.tell(0, 1);
  bench.move_view(5, 0);
  bench.tell(1, 2);
  CHECK(bench.output().empty());
  CHECK(bench.source.waiting.size() == 1);
}

TEST_CASE("a chunk that left the View is forgotten, and returns in its newest version") {
  Bench bench;
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  bench.move_view(8, 0);
  CHECK(bench.output().empty());
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 3);
  bench.move_view(5, 0);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 3);
}

TEST_CASE("a chunk that was asked for again, and left the View, is cancelled") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.tell(0, 3);
  CHECK(bench.output().empty());
  REQUIRE(bench.source.waiting.contains(kKey));
  bench.move_view(8, 0);
  CHECK_FALSE(bench.source.waiting.contains(kKey));
}

TEST_CASE("updates need credit to begin, and broadcasts use none") {
  Bench bench{true, 100};
  bench.see();  // the window is overdrawn
  const std::uint64_t sent = scripted_chunk(kKey)->frame_bytes();
  bench.edit(3);
  bench.tell(0, 3);
  CHECK(bench.output().empty());
  bench.credit(sent);
  CHECK(kinds(bench.output()) == Kinds{Body::EditBroadcast});
  bench.credit(sent + 1);
  CHECK(bench.session.closing());
}

TEST_CASE("a chunk that is sent again counts as any") {
  Bench bench{false};
  bench.see();
  bench.edit(3);
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 3);
  bench.tell(0, 3);
  CHECK(bench.output().size() == 1);
  bench.credit(2 * scripted_chunk(kKey)->frame_bytes());
  CHECK_FALSE(bench.session.closing());
}

TEST_CASE("an edited chunk that the client holds is confirmed in its turn, with its revision") {
  const bool for_view = GENERATE(true, false);
  Bench bench;
  const EncodedChunkPtr chunk = scripted_chunk(kKey, 3);
  bench.source.in_memory[kKey] = chunk;
  if (for_view) {
    bench.say_view(5, 0, 0, {chunk}, {kKey});
    bench.apply_view();
  } else {
    bench.get_chunk(1, kKey, chunk);
  }
  CHECK(bench.session.queued_bytes() == 0);  // no control frame
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Unchanged});
  CHECK(said[0].revision == 3);
  CHECK(bench.output().empty());
  bench.edit(4);
  bench.tell(3, 4);
  CHECK(kinds(bench.output()) == (for_view ? Kinds{Body::EditBroadcast} : Kinds{}));
}

TEST_CASE("an edit is not broadcast for a chunk that was only the answer to a request") {
  Bench bench;
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2);
  bench.get_chunk(1, kKey);
  CHECK(bench.output().at(0).revision == 2);
  bench.edit(3);
  bench.tell(2, 3);
  CHECK(bench.output().empty());
}

TEST_CASE("if any chunk may have changed, all edited ones are broadcast from the generated chunk") {
  Bench bench;
  bench.source.in_memory[chunk_at(4)] = scripted_chunk(chunk_at(4));
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2);
  bench.move_view(5, 1);
  bench.answer_all();
  CHECK(bench.output().size() == 9);
  bench.edit(3);
  bench.mailbox->put_changes(nullptr);
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::EditBroadcast});
  CHECK(said[0].key == kKey);
  CHECK(said[0].previous_revision == 0);
  CHECK(said[0].revision == 3);
}

TEST_CASE("ViewComplete does not wait for updates") {
  Bench bench{true, 100};
  bench.source.in_memory[kKey] = scripted_chunk(kKey);
  bench.view_number = 9;
  bench.move_view(5, 0);
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
  bench.edit(3);
  bench.tell(0, 3);
  CHECK(kinds(bench.output()) == Kinds{Body::ViewComplete});
}

TEST_CASE("the source learns where to send changes, and forgets a session that ended") {
  Bench bench;
  bench.move_view(5, 0);
  CHECK(bench.source.watcher == bench.mailbox);
  bench.session.abandon();
  CHECK(bench.source.watcher == nullptr);
}

TEST_CASE("updates that wait are memory of the session") {
  Bench bench{true, 1 << 20};
  bench.move_view(0, 10);
  const auto sent = bench.run_dry();
  REQUIRE(sent.size() == 21 * 21);
  std::uint64_t bytes = 0;
  for (const SessionFrame& each : sent) bytes += each.frame_bytes;
  const std::uint64_t before = bench.memory.used(MemoryUse::sessions);
  for (const SessionFrame& each : sent) {
    bench.source.revisions[each.key] = 1;
    bench.mailbox->put_changes(
        std::make_shared<const std::vector<ChunkChange>>(1, ChunkChange{each.key, 0, 1}));
  }
  bench.take_mail();
  CHECK(bench.memory.used(MemoryUse::sessions) >= before + sent.size() * 64);
  bench.move_view(100, 0);
  CHECK(bench.memory.used(MemoryUse::sessions) <= before);
}

namespace {

constexpr std::size_t kWholeBytes = 24'500;

/// Chunks that are edited whole, in sight of one whose client knows EditBroadcast.
struct EditedWhole : Bench {
  std::vector<ChunkKey> edited{};
  std::uint64_t revision = 0;

  explicit EditedWhole(std::int32_t radius) {
    limits.window_bytes = std::uint64_t{1} << 40;
    payload_of_source(100);
    move_view(5, static_cast<std::uint16_t>(radius));
    for (const SessionFrame& each : run_dry()) edited.push_back(each.key);
  }
  void payload_of_source(std::size_t bytes) { source.payload_bytes = bytes; }
  void edit_all() {
    ++revision;
    std::vector<ChunkChange> changes;
    for (const ChunkKey key : edited) {
      source.in_memory[key] = scripted_chunk(key, revision, kWholeBytes);
      changes.push_back({key, revision - 1, revision});
    }
    mailbox->put_changes(std::make_shared<const std::vector<ChunkChange>>(std::move(changes)));
    take_mail();
  }
};

}  // namespace

TEST_CASE("a chunk that was sent again pauses before it is sent once more, then in its newest version") {
  EditedWhole bench{0};
  bench.edit_all();
  REQUIRE(kinds(bench.output()) == Kinds{Body::Chunk});
  CHECK(bench.session.sendable_at() == Clock::time_point::max());
  const auto until = bench.clock.now() + ResendPauses::kPause;
  for (int edits = 0; edits < 10; ++edits) {
    bench.edit_all();
    CHECK(bench.output().empty());
    CHECK(bench.session.sendable_at() == until);
    bench.clock.advance(std::chrono::milliseconds{20});
  }
  bench.clock.advance(until - bench.clock.now());
  CHECK(bench.session.sendable_at() <= bench.clock.now());
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 11);
  CHECK(bench.session.sendable_at() == Clock::time_point::max());
}

TEST_CASE("paused chunks are forgotten with the View, and by a session that ends") {
  EditedWhole bench{0};
  bench.edit_all();
  CHECK(bench.output().size() == 1);
  bench.edit_all();
  CHECK(bench.output().empty());
  REQUIRE(bench.session.sendable_at() != Clock::time_point::max());
  if (GENERATE(true, false)) {
    bench.move_view(50, 0);
  } else {
    bench.session.abandon();
  }
  CHECK(bench.session.sendable_at() == Clock::time_point::max());
  bench.clock.advance(ResendPauses::kPause);
  CHECK(bench.output().empty());
}

TEST_CASE("a View comes while all that the client holds is edited whole, again and again") {
  EditedWhole bench{4};
  REQUIRE(bench.edited.size() == 81);
  bench.payload_of_source(3000);
  bench.edit_all();
  bench.view_number = 2;
  bench.move_view(5 + 9, 13);  // what it holds, and 648 chunks more
  std::size_t resent = 0;
  std::size_t viewed = 0;
  bool complete = false;
  while (!complete && viewed + resent < std::size_t{16} << 20) {
    bench.answer_all();
    for (const SessionFrame& each : bench.output(16 << 10)) {
      complete = complete || each.kind == Body::ViewComplete;
      if (each.kind == Body::Chunk) (each.revision > 0 ? resent : viewed) += each.frame_bytes;
    }
    // A link of 100 kB a second.
    bench.clock.advance(std::chrono::milliseconds{160});
    bench.edit_all();
  }
  CHECK(complete);
  CHECK(resent <= viewed + 2 * kWholeBytes);
  CHECK(resent + 4 * kWholeBytes >= viewed);
}

TEST_CASE("chunks that are to be sent again take no more than half of the room for what waits") {
  Bench bench{false};
  bench.limits.queued_bytes = 100'000;
  bench.move_view(5, 4);
  const auto sent = bench.run_dry();
  std::vector<ChunkChange> changes;
  for (const SessionFrame& each : sent) {
    bench.source.revisions[each.key] = 1;
    changes.push_back({each.key, 0, 1});
  }
  bench.mailbox->put_changes(std::make_shared<const std::vector<ChunkChange>>(std::move(changes)));
  bench.take_mail();
  CHECK(bench.output().empty());
  CHECK(bench.source.waiting.size() == Delivery::kMaxUpdatesUnderWay);
  // They come, and wait for the client; the View begins all the same.
  while (!bench.source.waiting.empty()) {
    const ChunkKey key = bench.source.waiting.begin()->first;
    bench.source.mail(key, scripted_chunk(key, 1, 5000));
  }
  bench.take_mail();
  bench.move_view(5 + 9, 13);
  CHECK(bench.source.waiting.size() > 0);
}

TEST_CASE("small chunks are sent again at once, however often, as broadcasts are") {
  const bool remembers = GENERATE(true, false);
  Bench bench{remembers};
  bench.see();
  for (std::uint64_t revision = 1; revision < 10; ++revision) {
    // Of the one the chunk is smaller than a broadcast, of the other it is all that goes.
    bench.edit(revision, 1000);
    bench.source.in_memory[kKey] = scripted_chunk(kKey, revision, remembers ? 0 : 3000);
    bench.tell(revision - 1, revision);
    const auto said = bench.output();
    REQUIRE(kinds(said) == Kinds{Body::Chunk});
    CHECK(said[0].revision == revision);
  }
}
