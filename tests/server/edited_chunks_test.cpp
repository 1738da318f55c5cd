// That chunks which change can stand before chunks as generated: a ChunkSource of chunks that were edited,
// with a cache of its own and no way to invalidate the other's.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <mutex>

#include "fake_generator.h"

using namespace talus;
using namespace talus::server;

namespace {

class EditedChunks final : public ChunkSource {
 public:
  explicit EditedChunks(ChunkSource& base) : base_{base} {}

  void edit(ChunkKey key, const Chunk& chunk) {
    const std::lock_guard lock{mutex_};
    const auto before = edited_.find(key);
    const std::uint64_t revision = before == edited_.end() ? kBaseRevision : before->second->revision();
    edited_[key] = encode_shared(chunk, revision + 1);
  }

  [[nodiscard]] EncodedChunkPtr find(ChunkKey key) override {
    EncodedChunkPtr edited = newer(key, kBaseRevision);
    return edited != nullptr ? edited : base_.find(key);
  }
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override {
    const std::lock_guard lock{mutex_};
    const auto found = edited_.find(key);
    return found != edited_.end() && found->second->revision() > revision ? found->second : nullptr;
  }
  [[nodiscard]] MixedRows column(ChunkKey key) override {
    MixedRows rows = base_.column(key);
    const std::lock_guard lock{mutex_};
    for (const auto& [at, chunk] : edited_) {
      if (column_of(at) != column_of(key)) continue;
      rows.first = std::min(rows.first, at.coord.y);
      rows.last = std::max(rows.last, at.coord.y);
    }
    return rows;
  }
  [[nodiscard]] int columns_together() const override { return base_.columns_together(); }
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys,
                                   Urgency urgency) override {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (EncodedChunkPtr edited = newer(keys[i], kBaseRevision)) {
        mailbox->put(ChunkReady{keys[i], std::move(edited)});
        mailbox->wake();
      } else if (base_.submit(mailbox, keys.subspan(i, 1), urgency) == 0) {
        return i;
      }
    }
    return keys.size();
  }
  void hasten(ClientId client, std::span<const ChunkKey> keys) override { base_.hasten(client, keys); }
  void cancel(ClientId client, std::span<const ChunkKey> keys) override { base_.cancel(client, keys); }
  void set_wanted(ClientId client, std::span<const LevelBox> boxes) override {
    base_.set_wanted(client, boxes);
  }
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) override {
    base_.submit_heights(mailbox, ticket, std::move(query));
  }
  void cancel_heights(ClientId client, std::uint64_t ticket) override {
    base_.cancel_heights(client, ticket);
  }

 private:
  ChunkSource& base_;
  std::mutex mutex_;
  std::map<ChunkKey, EncodedChunkPtr> edited_;
};

constexpr ChunkKey kKey{{1, 2, 3}, Lod{}};
const Chunk kBuilt = Chunk::uniform(MaterialId{5});

struct Bench {
  FakeService fake;
  EditedChunks chunks{fake.service};
  WaitingClient client;

  EncodedChunkPtr get(ChunkKey key) {
    REQUIRE(chunks.submit(client.mailbox(), {&key, 1}, Urgency::later) == 1);
    client.await(client.answers().size() + 1);
    return client.answers().back().second.value();
  }
};

std::uint64_t revision_in_frame(const EncodedChunk& chunk) {
  std::vector<std::byte> frame;
  chunk.append_frame(frame, 1, kKey);
  return (*protocol::read_message(frame))->body_as_Chunk()->revision();
}

}  // namespace

TEST_CASE("what was not edited is the base chunk, found and generated as without the edits") {
  Bench bench;
  bench.chunks.edit({{9, 9, 9}, Lod{}}, kBuilt);
  CHECK(bench.chunks.find(kKey) == nullptr);
  const EncodedChunkPtr chunk = bench.get(kKey);
  CHECK(chunk == bench.fake.service.find(kKey));
  CHECK(bench.chunks.find(kKey) == chunk);
  CHECK(revision_in_frame(*chunk) == 0);
}

TEST_CASE("an edited chunk is found with its revision, and nothing is generated for it") {
  Bench bench;
  bench.chunks.edit(kKey, kBuilt);
  bench.chunks.edit(kKey, kBuilt);
  const EncodedChunkPtr chunk = bench.chunks.find(kKey);
  CHECK(chunk->hash() == content_hash(kBuilt));
  CHECK(revision_in_frame(*chunk) == 2);
  CHECK(bench.get(kKey) == chunk);
  CHECK(bench.fake.work->chunks == 0);
}

TEST_CASE("an edit of a cached base chunk hides it and leaves it as it is") {
  Bench bench;
  const EncodedChunkPtr base = bench.get(kKey);
  bench.chunks.edit(kKey, kBuilt);
  CHECK(bench.chunks.find(kKey)->revision() == 1);
  CHECK(bench.fake.service.find(kKey) == base);
}

TEST_CASE("an edit while the base chunk is being generated is not lost: the answer has a newer version") {
  Bench bench;
  bench.fake.work->close_gate();
  REQUIRE(bench.chunks.submit(bench.client.mailbox(), {&kKey, 1}, Urgency::later) == 1);
  bench.fake.work->await_somebody_at_gate();
  bench.chunks.edit(kKey, kBuilt);
  bench.fake.work->open_gate();
  bench.client.await(1);
  const EncodedChunkPtr answer = bench.client.answers()[0].second.value();
  CHECK(answer->revision() == kBaseRevision);
  const EncodedChunkPtr newer = bench.chunks.newer(kKey, answer->revision());
  REQUIRE(newer != nullptr);
  CHECK(newer->revision() == 1);
  CHECK(bench.chunks.newer(kKey, newer->revision()) == nullptr);
  // The running job put the base chunk into the base's cache, where it belongs.
  CHECK(bench.chunks.find(kKey) == newer);
}

TEST_CASE("a row with an edited chunk is mixed, whatever the terrain knows") {
  Bench bench;
  bench.fake.work->first_mixed = 0;
  bench.fake.work->last_mixed = 0;
  (void)bench.get({{1, 0, 3}, Lod{}});
  CHECK(bench.chunks.column(kKey).uniform_at(2) == kAir);
  bench.chunks.edit(kKey, kBuilt);
  CHECK_FALSE(bench.chunks.column(kKey).uniform_at(2).has_value());
  CHECK(bench.chunks.column(kKey).uniform_at(3) == kAir);
  CHECK(bench.chunks.column({{0, 2, 3}, Lod{}}).uniform_at(2) == kAir);
}

TEST_CASE("room in the generators' queue is told through the edits") {
  FakeService fake{1, 1};
  EditedChunks chunks{fake.service};
  fake.work->close_gate();
  WaitingClient first;
  WaitingClient late;
  REQUIRE(chunks.submit(first.mailbox(), {&kKey, 1}, Urgency::later) == 1);
  constexpr ChunkKey kFar{{100, 0, 0}, Lod{}};
  REQUIRE(chunks.submit(late.mailbox(), {&kFar, 1}, Urgency::later) == 0);
  fake.work->open_gate();
  late.await_room();
}
