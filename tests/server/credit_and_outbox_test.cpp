#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include <rapidcheck.h>

#include "frames.h"
#include "player/view/credit.h"
#include "player/view/outbox.h"

using namespace talus;
using namespace talus::server;

namespace {

EncodedChunkPtr chunk_of(std::size_t payload_bytes) {
  return std::make_shared<const EncodedChunk>(ContentHash{}, std::vector<std::byte>(payload_bytes));
}

Outbox::Entry entry(std::uint32_t id, std::size_t payload_bytes) {
  return {id, {{static_cast<std::int32_t>(id), 0, 0}, Lod{}}, chunk_of(payload_bytes)};
}

constexpr std::size_t kAll = std::size_t{1} << 40;

/// What goes for an update: a frame or a chunk, the whole chunk in a turn of its own, or nothing.
struct Update {
  protocol::Frame frame{};
  EncodedChunkPtr chunk{};
  bool whole = false;
};

constexpr std::optional<protocol::Frame> kItself;
constexpr auto kNoUpdates = [](ChunkKey) { return Update{}; };
constexpr auto kNoResends = [](ChunkKey) { return EncodedChunkPtr{}; };

struct WriteTotals {
  std::size_t chunks = 0;
  std::size_t chunk_bytes = 0;
};

/// One write. write(entry) may replace the entry's chunk, or returns a frame that goes in its place;
/// write_update(key) returns what goes for an update, and write_resend(key) the whole chunk; null: nothing.
template <typename Write, typename WriteUpdate, typename WriteResend>
WriteTotals write_all(Outbox& outbox, const Outbox::WriteLimits& limits, Credit& credit, Output& output,
                      Write&& write, WriteUpdate&& write_update, WriteResend&& write_resend) {
  using Turn = Outbox::Write::Turn;
  Outbox::Write out{outbox, limits, credit, output};
  for (;;) {
    const Turn turn = out.next();
    if (turn == Turn::none) return {out.chunks(), out.chunk_bytes()};
    if (turn == Turn::broadcasts) {
      const ChunkKey key = out.take_update();
      const Update update = write_update(key);
      if (update.whole) outbox.push_resend(key);
      if (update.chunk != nullptr) {
        out.append(update.chunk, 0, key);
      } else {
        out.append(update.frame);
      }
    } else if (turn == Turn::resends) {
      const ChunkKey key = out.take_resend();
      if (const EncodedChunkPtr chunk = write_resend(key)) out.append(chunk, 0, key);
    } else {
      Outbox::Entry entry = out.take_chunk();
      if (const std::optional<protocol::Frame> instead = write(entry)) {
        out.append(*instead);
      } else {
        out.append(entry.chunk, entry.request_id, entry.key);
      }
    }
  }
}

struct OutboxFrames {
  std::vector<std::byte> bytes;
  std::vector<std::uint32_t> ids;
};

OutboxFrames take(Outbox& outbox, const Outbox::WriteLimits& limits, Credit& credit) {
  OutboxFrames taken;
  Output output;
  (void)write_all(
      outbox, limits, credit, output,
      [&](Outbox::Entry& entry) {
        taken.ids.push_back(entry.request_id);
        return kItself;
      },
      kNoUpdates, kNoResends);
  taken.bytes = flat(output);
  return taken;
}

}  // namespace

TEST_CASE("credit lets a window and at most one frame more go out") {
  CHECK(rc::check([] {
    const auto window = *rc::gen::inRange<std::uint64_t>(1, 5000);
    Credit credit{window};
    std::uint64_t sent = 0;
    std::uint64_t taken = 0;
    for (const int step : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 2000))) {
      const auto bytes = static_cast<std::uint64_t>(step) + 1;
      if (credit.may_send()) {
        RC_ASSERT(sent - taken < window);
        credit.sent(bytes);
        sent += bytes;
      } else {
        RC_ASSERT(sent - taken >= window);
        taken += std::min(bytes, sent - taken);
        RC_ASSERT(credit.taken(taken).has_value());
      }
    }
  }));
}

TEST_CASE("credit refuses totals that cannot be") {
  Credit credit{100};
  credit.sent(80);
  CHECK(credit.taken(50).has_value());
  CHECK(credit.taken(50).has_value());
  CHECK_FALSE(credit.taken(49).has_value());
  CHECK_FALSE(credit.taken(81).has_value());
  CHECK(credit.taken(80).has_value());
}

TEST_CASE("control frames go first and need no credit") {
  Outbox outbox;
  Credit none{0};
  outbox.push_chunk(entry(1, 10));
  outbox.push_control(protocol::Frame(7));
  CHECK(take(outbox, {}, none).bytes.size() == 7);
  CHECK_FALSE(outbox.sendable(none));
  Credit some{1};
  CHECK(outbox.sendable(some));
}

TEST_CASE("the outbox takes until there is enough, and counts what it sent") {
  Outbox outbox;
  Credit credit{kAll};
  for (std::uint32_t id = 1; id <= 10; ++id) outbox.push_chunk(entry(id, 1000));
  const std::size_t frame_bytes = chunk_of(1000)->frame_bytes();
  const OutboxFrames taken = take(outbox, {3 * frame_bytes}, credit);
  CHECK(taken.bytes.size() == 3 * frame_bytes);
  CHECK(taken.ids == std::vector<std::uint32_t>{1, 2, 3});
  CHECK(credit.taken(3 * frame_bytes).has_value());
  CHECK_FALSE(credit.taken(3 * frame_bytes + 1).has_value());
}

TEST_CASE("an output copies all waiting bytes, but only the heads of large chunks") {
  Outbox outbox;
  CHECK(outbox.bytes_to_copy(Output::kCopyAll) == 0);
  CHECK(outbox.bytes_to_copy(0) == 0);
  for (std::uint32_t id = 1; id <= 10; ++id) outbox.push_chunk(entry(id, 10'000));
  outbox.push_control(protocol::Frame(100));
  CHECK(outbox.bytes_to_copy(Output::kCopyAll) == outbox.control_bytes() + outbox.chunk_bytes());
  CHECK(outbox.bytes_to_copy(20'000) == outbox.control_bytes() + outbox.chunk_bytes());
  for (const std::size_t shared_from : {std::size_t{0}, std::size_t{2000}}) {
    const std::size_t told = outbox.bytes_to_copy(shared_from);
    CHECK(told > 10 * 64);
    CHECK(told < 10 * 1000);
  }
}

TEST_CASE("an emptied outbox counts no bytes, however it was emptied") {
  CHECK(rc::check([] {
    Outbox outbox;
    Credit credit{kAll};
    for (const auto id : *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 50U))) {
      outbox.push_chunk(entry(id, id));
      outbox.push_control(protocol::Frame(id));
    }
    const auto dropped = *rc::gen::inRange(0U, 50U);
    outbox.drop_chunks([&](const Outbox::Entry& each) { return each.request_id < dropped; });
    while (outbox.sendable(credit)) {
      for (const std::uint32_t id : take(outbox, {}, credit).ids) RC_ASSERT(id >= dropped);
    }
    RC_ASSERT(outbox.control_bytes() == 0);
    RC_ASSERT(outbox.chunk_bytes() == 0);
  }));
}

TEST_CASE("limits of chunks bound the chunks that are taken, and no control frame") {
  Outbox outbox;
  Credit credit{kAll};
  outbox.push_control(protocol::Frame(10));
  for (std::uint32_t id = 1; id <= 5; ++id) outbox.push_chunk(entry(id, 100));
  CHECK(take(outbox, {kAll, 0, kAll}, credit).bytes.size() == 10);
  CHECK(take(outbox, {kAll, 2, kAll}, credit).ids.size() == 2);
  CHECK(take(outbox, {kAll, kAll, 0}, credit).ids.empty());
  CHECK(take(outbox, {kAll, kAll, 1}, credit).ids.size() == 1);
}

TEST_CASE("requests and the View share by bytes, within one chunk, while both have chunks") {
  CHECK(rc::check([] {
    constexpr std::size_t kLargest = 3000;
    Outbox outbox;
    Credit credit{1};  // one chunk a turn
    std::map<bool, std::size_t> sent;
    std::uint64_t all = 0;
    for (const int rounds : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 20))) {
      for (int round = 0; round < rounds; ++round) {
        for (const std::uint32_t id : {0U, 1U}) {  // both are never without a chunk
          while (outbox.chunks(id == 0 ? Outbox::Lane::view : Outbox::Lane::requests) < 2) {
            outbox.push_chunk(entry(id, *rc::gen::inRange<std::size_t>(1, kLargest)));
          }
        }
        const OutboxFrames taken = take(outbox, {}, credit);
        RC_ASSERT(taken.ids.size() == 1);
        sent[taken.ids[0] == 0] += taken.bytes.size();
        all += taken.bytes.size();
        RC_ASSERT(credit.taken(all).has_value());
        const std::size_t ahead = std::max(sent[true], sent[false]) - std::min(sent[true], sent[false]);
        RC_ASSERT(ahead <= chunk_of(kLargest)->frame_bytes());
      }
    }
  }));
}

TEST_CASE("bytes sent by a lane while the other was empty do not count against it") {
  Outbox outbox;
  Credit credit{kAll};
  for (int chunk = 0; chunk < 50; ++chunk) outbox.push_chunk(entry(1, 1000));
  CHECK(take(outbox, {}, credit).ids.size() == 50);
  for (int chunk = 0; chunk < 10; ++chunk) {
    outbox.push_chunk(entry(1, 1000));
    outbox.push_chunk(entry(0, 1000));
  }
  const OutboxFrames taken = take(outbox, {kAll, 10, kAll}, credit);
  CHECK(std::count(taken.ids.begin(), taken.ids.end(), 0U) == 5);
}

TEST_CASE("a lane that runs empty ends the write before the other gets ahead") {
  Outbox outbox;
  Credit credit{kAll};
  for (int chunk = 0; chunk < 50; ++chunk) outbox.push_chunk(entry(1, 1000));
  outbox.push_chunk(entry(0, 1000));
  CHECK(take(outbox, {}, credit).ids == std::vector<std::uint32_t>{1, 0, 1});
  CHECK(take(outbox, {}, credit).ids.size() == 48);  // nothing came: the others go on
}

TEST_CASE("a chunk is written as write() leaves it") {
  Outbox outbox;
  Credit credit{kAll};
  outbox.push_chunk(entry(1, 100));
  Output output;
  const WriteTotals taken = write_all(
      outbox, {}, credit, output,
      [](Outbox::Entry& entry) {
        entry.chunk = chunk_of(5000);
        return kItself;
      },
      kNoUpdates, kNoResends);
  CHECK(taken.chunks == 1);
  CHECK(taken.chunk_bytes == output.size());
  CHECK(output.size() == chunk_of(5000)->frame_bytes());
  CHECK(credit.taken(output.size()).has_value());
  CHECK(outbox.chunk_bytes() == 0);
}

TEST_CASE("a frame in a chunk's place is written instead, and does not count as a chunk") {
  Outbox outbox;
  Credit credit{1};
  outbox.push_chunk(entry(1, 100));
  Output output;
  const WriteTotals taken = write_all(
      outbox, {}, credit, output, [&](Outbox::Entry&) { return std::optional{protocol::Frame(7)}; },
      kNoUpdates, kNoResends);
  CHECK(output.size() == 7);
  CHECK(taken.chunks == 0);
  CHECK(credit.may_send());
  CHECK(outbox.chunk_bytes() == 0);
}

TEST_CASE("updates go after control frames and before chunks, each once a write") {
  Outbox outbox;
  Credit credit{kAll};
  outbox.push_chunk(entry(1, 100));
  const ChunkKey first{{5, 0, 0}, Lod{}};
  const ChunkKey second{{6, 0, 0}, Lod{}};
  outbox.push_update(second);
  outbox.push_update(first);
  outbox.push_control(protocol::Frame(7));
  Output output;
  std::vector<std::size_t> begins;
  const WriteTotals taken = write_all(
      outbox, {}, credit, output,
      [&](Outbox::Entry&) {
        begins.push_back(output.size());
        return kItself;
      },
      [&](ChunkKey key) {
        if (key == second) return Update{{}, {}, true};
        begins.push_back(output.size());
        outbox.push_update(key);
        return Update{protocol::Frame(11)};
      },
      [&](ChunkKey key) {
        begins.push_back(output.size());
        outbox.push_update(key);
        return chunk_of(50);
      });
  // The chunk that is sent again is a chunk: of two that wait it is not the one before which a frame went.
  CHECK(begins == std::vector<std::size_t>{7, 18, 18 + chunk_of(100)->frame_bytes()});
  CHECK(taken.chunks == 2);
  CHECK(credit.taken(taken.chunk_bytes).has_value());
  CHECK_FALSE(credit.taken(taken.chunk_bytes + 1).has_value());  // a frame counts as none
  CHECK(outbox.updates() == 2);
  outbox.drop_updates([&](ChunkKey key) { return key == first; });
  CHECK(outbox.updates() == 1);
}

namespace {

/// What one writes to whom others edit the land: each chunk is edited again as soon as it went.
struct EditedLand {
  std::size_t broadcast_bytes = 0;  // of each of the chunks with even numbers; 0: none is a broadcast
  std::size_t chunk_bytes = 0;      // of the others
  std::size_t broadcasts_sent = 0;
  std::size_t resent = 0;
  std::size_t view_sent = 0;
  Outbox outbox{};
  Credit credit{kAll};

  void edit(std::int32_t chunks) {
    for (std::int32_t x = 0; x < chunks; ++x) outbox.push_update({{x, 0, 0}, Lod{}});
  }
  std::size_t write(std::size_t enough_bytes) {
    Output output;
    (void)write_all(
        outbox, {enough_bytes}, credit, output,
        [&](Outbox::Entry& entry) {
          view_sent += entry.chunk->frame_bytes();
          return kItself;
        },
        [&](ChunkKey key) {
          if (broadcast_bytes == 0 || key.coord.x % 2 != 0) return Update{{}, {}, true};
          broadcasts_sent += broadcast_bytes;
          outbox.push_update(key);
          return Update{protocol::Frame(broadcast_bytes)};
        },
        [&](ChunkKey key) {
          const EncodedChunkPtr chunk = chunk_of(chunk_bytes);
          resent += chunk->frame_bytes();
          outbox.push_update(key);
          return chunk;
        });
    return output.size();
  }
};

}  // namespace

TEST_CASE("half of the bytes are the View's while it has chunks, however much of the land is edited") {
  const std::size_t broadcast_bytes = GENERATE(std::size_t{0}, std::size_t{40}, std::size_t{4000});
  const std::size_t chunk_bytes = GENERATE(std::size_t{0}, std::size_t{25'000});
  const std::int32_t edited = chunk_bytes == 0 ? 1 : 60;  // one: broadcasts alone
  if (broadcast_bytes == 0 && chunk_bytes == 0) return;
  const std::size_t enough = GENERATE(std::size_t{1}, std::size_t{16} << 10, std::size_t{64} << 10);
  EditedLand land{broadcast_bytes, chunk_bytes};
  land.edit(edited);
  std::size_t all = 0;
  while (all < std::size_t{4} << 20) {
    while (land.outbox.chunks(Outbox::Lane::view) < 64) land.outbox.push_chunk(entry(0, 3000));
    all += land.write(enough);
  }
  constexpr std::size_t kOneOfEach = (std::size_t{16} << 10) + 2 * 25'100;
  CHECK(land.view_sent + kOneOfEach >= all / 2);
  if (chunk_bytes > 0 && edited > 1) CHECK(land.resent + kOneOfEach >= all / (broadcast_bytes > 0 ? 8 : 2));
}

TEST_CASE("small broadcasts go before chunks of the View and before chunks that are sent again") {
  EditedLand land{40, 25'000};
  for (int chunk = 0; chunk < 100; ++chunk) land.outbox.push_chunk(entry(0, 3000));
  for (std::int32_t x = 1; x < 40; x += 2) land.outbox.push_update({{x, 0, 0}, Lod{}});
  while (land.resent < 50'000) (void)land.write(16 << 10);
  for (std::int32_t x = 0; x < 40; x += 2) land.outbox.push_update({{x, 0, 0}, Lod{}});
  // What was resent last is paid for first, by chunks of the View.
  std::size_t before = 0;
  while (land.broadcasts_sent == 0) {
    before = land.view_sent;
    REQUIRE(land.write(1) > 0);
  }
  const std::size_t resent = land.resent;
  while (land.broadcasts_sent < 20 * 40) REQUIRE(land.write(1) > 0);
  CHECK(land.view_sent <= before + chunk_of(3000)->frame_bytes());
  CHECK(land.resent == resent);
}

TEST_CASE("without chunks that wait edited land takes all, and owes nothing for it") {
  EditedLand land{0, 25'000};
  land.edit(60);
  while (land.resent < 1'000'000) (void)land.write(64 << 10);
  for (int chunk = 0; chunk < 200; ++chunk) land.outbox.push_chunk(entry(0, 3000));
  const std::size_t resent = land.resent;
  while (land.view_sent < 200'000) (void)land.write(16 << 10);
  CHECK(land.resent - resent >= 150'000);
}

TEST_CASE("an update needs credit to begin") {
  Outbox outbox;
  outbox.push_update({{5, 0, 0}, Lod{}});
  Credit none{0};
  Credit some{1};
  CHECK_FALSE(outbox.sendable(none));
  CHECK(outbox.sendable(some));
}

TEST_CASE("a write has the same bytes whether large chunks are copied into it or not") {
  CHECK(rc::check([] {
    const std::size_t shared_from = *rc::gen::inRange<std::size_t>(0, 700);
    Output copied;
    Output shared{shared_from};
    std::size_t large = 0;
    for (const std::size_t size :
         *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 600))) {
      const ChunkKey key{{static_cast<std::int32_t>(size), 2, -3}, Lod{}};
      if (size % 4 == 0) {
        const std::vector<std::byte> control(size + 1, std::byte{7});
        for (Output* output : {&copied, &shared}) output->append(control);
        continue;
      }
      const auto chunk =
          std::make_shared<const EncodedChunk>(ContentHash{size, 1}, std::vector<std::byte>(size));
      large += chunk->frame_bytes() >= shared_from ? 1 : 0;
      for (Output* output : {&copied, &shared}) output->append(chunk, static_cast<std::uint32_t>(size), key);
    }
    RC_ASSERT(flat(shared) == flat(copied));
    RC_ASSERT(shared.size() == copied.size());
    RC_ASSERT(shared.size() == flat(shared).size());
    RC_ASSERT(copied.pieces().size() == (copied.size() > 0 ? 1U : 0U));
    RC_ASSERT(shared.pieces().size() >= 2 * large);
  }));
}

TEST_CASE("an output that takes over the memory of another begins empty") {
  const std::vector<std::byte> frame(1000, std::byte{7});
  for (const std::size_t frames : {1U, 5U, 100U, 2U, 1U}) {
    Output output;
    CHECK(output.size() == 0);
    CHECK(output.pieces().empty());
    for (std::size_t i = 0; i < frames; ++i) output.append(frame);
    CHECK(output.size() == frames * frame.size());
    REQUIRE(output.pieces().size() == 1);
    CHECK(output.pieces().front().size() == output.size());
  }
}
