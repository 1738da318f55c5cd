// Random conversations against what a client can check: each request is answered once, each chunk of a View
// comes once unless it changes, the newest version is what is written, and nothing is held when nothing is
// asked.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <rapidcheck.h>

#include "session_bench.h"
#include "views.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

constexpr std::uint16_t kRows = 1;  // vertical radius of every View

class Client {
 public:
  Client() {
    bench_.limits.window_bytes = 3000;  // a few chunks
    bench_.limits.queued_bytes = 20'000;
    bench_.limits.requests_in_flight = 5;
    bench_.source.together = *rc::gen::element(1, 2, 4);
    bench_.hello();
    (void)bench_.output();
  }

  void step(int what, int value) {
    switch (what) {
      case 0:
        return say_view(value);
      case 1:
        return apply_view();
      case 2:
        return get_chunk(value);
      case 3:
        return get_heights();
      case 4:
        return cancel(value);
      case 5:
        return answer_some(value);
      case 6:
        return change_chunk(value);
      case 7:
        bench_.credit(taken_);
        return;
      case 8:
        bench_.source.queue_places = static_cast<std::size_t>(value % 8);
        bench_.mailbox->put(QueueHasRoom{});
        return;
      case 9:
        bench_.source.rows = value % 2 == 0 ? MixedRows{} : MixedRows{0, 0, MaterialId{2}};
        return;
      default:
        (void)read(static_cast<std::size_t>(value) * 40);
    }
  }

  void check_bounds() {
    RC_ASSERT(bench_.session.state() == Session::State::joined);
    RC_ASSERT(bench_.source.waiting.size() <= Delivery::kMaxWaits);
    // One chunk more than queued_bytes, and what Views and requests take.
    RC_ASSERT(bench_.memory.used(MemoryUse::sessions) < Session::kIdleBytes + 2 * 20'000 + 16'384);
  }

  /// Everything that can come has come.
  void finish() {
    bench_.source.queue_places = SIZE_MAX;
    bench_.mailbox->put(QueueHasRoom{});
    apply_view();
    while (settle()) {
    }
    RC_ASSERT(open_.empty());
    RC_ASSERT(delivered_ == in_view_);
    RC_ASSERT(number_ == 0);  // of a View that is applied and not said to be complete
    say_view(-1);             // outside the world
    apply_view();
    while (settle()) {
    }
    bench_.take_mail();
    RC_ASSERT(bench_.source.waiting.empty());
    RC_ASSERT(bench_.memory.used(MemoryUse::sessions) <= Session::kIdleBytes + 8192);
  }

 private:
  bool settle() {
    while (!bench_.source.waiting_heights.empty()) {
      bench_.source.answer_heights(bench_.source.waiting_heights.begin()->first);
    }
    bench_.answer_all();
    bench_.credit(taken_);
    const bool said = read(1 << 20);
    return said || !bench_.source.waiting.empty();
  }

  void say_view(int value) {
    if (said_.size() == ViewSubscription::kMaxUnseenViews) return;  // from there on all is sent again
    const std::int64_t x = value < 0 ? std::int64_t{1} << 40 : value % 7;
    const auto radius = static_cast<std::uint16_t>(value < 0 ? 0 : value % 3);
    const auto keys = chunks_in_view({{x, 0, 0}, {}, radius, kRows, {}});
    said_.push_back({keys.begin(), keys.end()});
    std::vector<ChunkKey> known;
    std::vector<EncodedChunkPtr> held;
    for (const ChunkKey key : keys) {
      if ((value + key.coord.x + key.coord.z) % 4 != 0) continue;
      known.push_back(key);
      held.push_back(scripted_chunk(key, static_cast<std::uint64_t>(value % 3)));
    }
    bench_.view_number = static_cast<std::uint32_t>(value % 5) == 0 ? 0 : ++last_number_;
    bench_.say_view(x, radius, kRows, held, known);
  }
  void apply_view() {
    // What is queued for the View before, and the Unchanged that a chunk became while it was taken.
    while (read(1 << 20)) {
    }
    if (!bench_.session.view_waits()) return;
    number_ = bench_.view_number;
    bench_.apply_view();
    in_view_ = said_.back();
    // A chunk that left in any of them is sent again when it is back.
    for (const auto& view : std::exchange(said_, {})) {
      std::erase_if(delivered_, [&](ChunkKey key) { return !view.contains(key); });
    }
  }

  void get_chunk(int value) {
    const std::uint32_t id = ++last_id_;
    open_.insert(id);
    const ChunkKey key = chunk_at(value % 8, value % 3 - 1);
    bench_.get_chunk(id, key, value % 5 == 0 ? scripted_chunk(key, 1) : nullptr);
  }
  void get_heights() {
    const std::uint32_t id = ++last_id_;
    open_.insert(id);
    bench_.get_heights(id);
  }
  void cancel(int value) {
    if (last_id_ != 0) bench_.cancel(last_id_ - static_cast<std::uint32_t>(value) % last_id_);
  }
  void answer_some(int value) {
    auto& heights = bench_.source.waiting_heights;
    if (value % 3 == 0 && !heights.empty()) bench_.source.answer_heights(heights.begin()->first);
    for (int chunk = 0; chunk < value % 5 && !bench_.source.waiting.empty(); ++chunk) {
      auto next = bench_.source.waiting.begin();
      std::advance(next, static_cast<std::size_t>(value) % bench_.source.waiting.size());
      bench_.source.answer(next->first);
    }
    if (value % 2 == 0) bench_.take_mail();
  }
  void change_chunk(int value) {
    const ChunkKey key = chunk_at(value % 8, value % 3 - 1, value % 2);
    auto& chunk = bench_.source.in_memory[key];
    chunk = scripted_chunk(key, chunk == nullptr ? 1 : chunk->revision() + 1,
                           static_cast<std::size_t>(value) * 10);
  }

  /// Whether anything was said.
  bool read(std::size_t enough_bytes) {
    const auto all = bench_.output(enough_bytes);
    for (const SessionFrame& each : all) check(each);
    return !all.empty();
  }
  void check(const SessionFrame& said) {
    if (said.kind == Body::Chunk) taken_ += said.frame_bytes;
    if (said.kind == Body::Chunk || said.kind == Body::Unchanged) {
      const auto newest = bench_.source.in_memory.find(said.key);
      const bool older =
          newest != bench_.source.in_memory.end() && newest->second->revision() > said.revision;
      RC_ASSERT(!older || said.kind == Body::Unchanged);
    }
    if (said.kind == Body::ViewComplete) {
      RC_ASSERT(delivered_ == in_view_);
      RC_ASSERT(said.view_number == std::exchange(number_, 0));
    } else if (said.id != 0) {
      RC_ASSERT(open_.erase(said.id) == 1);
    } else if (said.kind == Body::UniformColumn) {
      for (const auto& [first, last, material] : said.runs) {
        for (std::int32_t y = first; y <= last; ++y)
          deliver({{said.key.coord.x, y, said.key.coord.z}, {}}, 0);
      }
    } else {
      deliver(said.key, said.revision);
    }
  }
  /// Once, and again only where it was changed since.
  void deliver(ChunkKey key, std::uint64_t revision) {
    RC_ASSERT(in_view_.contains(key));
    const bool changed = !delivered_.contains(key) || revision > revisions_.at(key);
    RC_ASSERT(changed);
    delivered_.insert(key);
    revisions_[key] = revision;
  }

  SessionBench bench_{{.greet = false}};
  std::uint32_t last_id_ = 0;
  std::set<std::uint32_t> open_;  // asked and not answered
  std::uint64_t taken_ = 0;
  std::vector<std::set<ChunkKey>> said_;  // Views since the last was applied
  std::uint32_t last_number_ = 0;
  std::uint32_t number_ = 0;                     // of the View in force, until it was said to be complete
  std::set<ChunkKey> in_view_;                   // of the View in force
  std::set<ChunkKey> delivered_;                 // in this stay in the View
  std::map<ChunkKey, std::uint64_t> revisions_;  // in which they came last
};

}  // namespace

TEST_CASE("any conversation keeps the protocol's promises") {
  CHECK(rc::check([] {
    Client client;
    using Step = std::pair<int, int>;
    const auto steps = *rc::gen::scale(4.0, rc::gen::container<std::vector<Step>>(rc::gen::pair(
                                                rc::gen::inRange(0, 13), rc::gen::inRange(0, 200))));
    for (const auto& [what, value] : steps) {
      client.step(what, value);
      client.check_bounds();
    }
    client.finish();
  }));
}
