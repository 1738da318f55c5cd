// A generator that makes nothing, counts its calls, and waits where a test wants it to.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <variant>
#include <vector>

#include "chunks/chunks.h"
#include "chunks/generation/generator.h"
#include "runtime/manual_clock.h"

namespace talus::server {

/// What the fake does; shared by the test and the generator.
struct FakeWork {
  std::atomic<int> patches{0};
  std::atomic<int> chunks{0};
  std::atomic<int> reused{0};  // patches made in memory of others
  std::atomic<bool> out_of_memory{false};
  std::atomic<bool> finding_throws{false};
  std::atomic<std::size_t> payload_bytes{0};
  std::atomic<int> patch_columns{0};  // 4 bytes each
  std::atomic<std::int32_t> last_mixed_anywhere{std::numeric_limits<std::int32_t>::max()};
  std::atomic<std::int32_t> first_mixed{std::numeric_limits<std::int32_t>::min()};
  std::atomic<std::int32_t> last_mixed{std::numeric_limits<std::int32_t>::max()};
  std::atomic<int> patch_steps{1};
  std::atomic<int> heights_steps{1};
  std::function<void()> in_patch{};                // called in each step of a patch; set before any is made
  std::function<void(const PatchKey&)> in_step{};  // likewise
  std::function<void()> in_heights{};              // likewise
  std::function<void()> in_chunk{};                // likewise, of each chunk
  std::atomic<bool> patch_given_up{false};         // one that was begun and not taken

  /// While closed, generator threads wait before they make a patch.
  void close_gate() { set_gate(false); }
  void open_gate() { set_gate(true); }
  void pass_gate() {
    std::unique_lock lock{mutex_};
    ++at_gate_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return open_; });
    --at_gate_;
  }
  void await_somebody_at_gate() {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return at_gate_ > 0; });
  }

 private:
  void set_gate(bool open) {
    const std::lock_guard lock{mutex_};
    open_ = open;
    changed_.notify_all();
  }
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = true;
  int at_gate_ = 0;
};

class FakePatch final : public PatchBuild {
 public:
  FakePatch(FakeWork& work, const PatchKey& patch, terrain::Stacks memory)
      : work_{work}, patch_{patch}, memory_{std::move(memory)} {}
  FakePatch(const FakePatch&) = delete;
  FakePatch& operator=(const FakePatch&) = delete;
  [[nodiscard]] bool step() override {
    if (done_ == 0) work_.pass_gate();
    if (done_ == work_.patch_steps) return false;
    ++done_;
    if (work_.in_patch) work_.in_patch();
    if (work_.in_step) work_.in_step(patch_);
    return true;
  }
  ~FakePatch() override {
    if (taken_) return;
    work_.patch_given_up = true;
    work_.patch_given_up.notify_all();
  }
  [[nodiscard]] terrain::Stacks take() override {
    taken_ = true;
    ++work_.patches;
    if (work_.out_of_memory) throw std::bad_alloc{};
    if (!memory_.tops.empty()) ++work_.reused;
    memory_.tops.clear();
    if (work_.patch_columns > 0) memory_.tops.emplace_back(work_.patch_columns, 1);
    return std::move(memory_);
  }

 private:
  FakeWork& work_;
  const PatchKey patch_;
  terrain::Stacks memory_;
  int done_ = 0;
  bool taken_ = false;
};

class FakeHeights final : public HeightsBuild {
 public:
  FakeHeights(FakeWork& work, const HeightsQuery& query)
      : work_{work}, columns_{query.columns.size()}, is_tile_{query.tile.has_value()} {}
  [[nodiscard]] bool step() override {
    if (done_ == work_.heights_steps) return false;
    ++done_;
    if (work_.in_heights) work_.in_heights();
    return true;
  }
  [[nodiscard]] HeightsResult take() override {
    if (work_.out_of_memory) throw std::bad_alloc{};
    if (is_tile_) return {.picture = std::make_shared<const Picture>(Picture{"a map"})};
    return {.heights_fx = std::vector<std::int32_t>(columns_)};
  }

 private:
  FakeWork& work_;
  const std::size_t columns_;
  const bool is_tile_;
  int done_ = 0;
};

class FakeGenerator final : public Generator {
 public:
  explicit FakeGenerator(std::shared_ptr<FakeWork> work) : work_{std::move(work)} {}

  [[nodiscard]] EncodedChunkPtr instant(ChunkKey) const override {
    if (work_->finding_throws) throw std::bad_alloc{};
    return nullptr;
  }
  [[nodiscard]] EncodedChunkPtr uniform(MaterialId) const override {
    return std::make_shared<const EncodedChunk>(ContentHash{}, std::vector<std::byte>{}, kBaseRevision, true);
  }
  /// As if all were mixed, unless the test says from where on there is air.
  [[nodiscard]] MixedRows mixed_rows_anywhere(Lod) const override {
    return {std::numeric_limits<std::int32_t>::min(), work_->last_mixed_anywhere, MaterialId{2}};
  }
  [[nodiscard]] MixedRows mixed_rows(const terrain::Stacks&, ChunkKey) const override {
    return {work_->first_mixed, work_->last_mixed, MaterialId{2}};
  }
  [[nodiscard]] std::unique_ptr<PatchBuild> start_patch(const PatchKey& patch,
                                                        terrain::Stacks memory) const override {
    return std::make_unique<FakePatch>(*work_, patch, std::move(memory));
  }
  [[nodiscard]] EncodedChunkPtr make_chunk(const terrain::Stacks&, ChunkKey key) const override {
    ++work_->chunks;
    if (work_->in_chunk) work_->in_chunk();
    return std::make_shared<const EncodedChunk>(ContentHash{std::hash<ChunkKey>{}(key), 0},
                                                std::vector<std::byte>(work_->payload_bytes));
  }
  [[nodiscard]] std::unique_ptr<HeightsBuild> start_heights(HeightsQuery query) const override {
    return std::make_unique<FakeHeights>(*work_, query);
  }

 private:
  std::shared_ptr<FakeWork> work_;
};

/// A client that keeps its answers until a test waits for them.
class WaitingClient {
 public:
  explicit WaitingClient(ClientId id = next_id())
      : mailbox_{std::make_shared<Mailbox>(id, [this] {
          const std::lock_guard lock{mutex_};
          woken_ = true;
          changed_.notify_all();
        })} {}
  WaitingClient(const WaitingClient&) = delete;
  WaitingClient& operator=(const WaitingClient&) = delete;

  [[nodiscard]] const MailboxPtr& mailbox() const { return mailbox_; }
  [[nodiscard]] ClientId id() const { return mailbox_->owner(); }

  /// Waits until there are `count` answers of both kinds.
  void await(std::size_t count) {
    await_until([&] { return answers_.size() + heights_.size() >= count; });
  }
  void await_room() {
    await_until([&] { return rooms_ > 0; });
  }
  /// Takes what has come so far.
  void take_mail() {
    for (Mail& mail : mailbox_->take()) {
      if (auto* chunk = std::get_if<ChunkReady>(&mail)) {
        answers_.emplace_back(chunk->key, std::move(chunk->answer));
      } else if (auto* heights = std::get_if<HeightsReady>(&mail)) {
        heights_.emplace_back(heights->ticket, std::move(heights->answer));
      } else {
        ++rooms_;
      }
    }
  }

  using Answer = std::pair<ChunkKey, ChunkAnswer>;
  [[nodiscard]] const std::vector<Answer>& answers() const { return answers_; }
  [[nodiscard]] const std::vector<std::pair<std::uint64_t, HeightsAnswer>>& heights() const {
    return heights_;
  }
  /// How often it was told that the queue has room.
  [[nodiscard]] int rooms() const { return rooms_; }

 private:
  static ClientId next_id() {
    static std::atomic<std::uint64_t> last{0};
    return ClientId{++last};
  }
  template <typename Enough>
  void await_until(Enough&& enough) {
    for (take_mail(); !enough(); take_mail()) {
      std::unique_lock lock{mutex_};
      changed_.wait(lock, [&] { return std::exchange(woken_, false); });
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool woken_ = false;
  MailboxPtr mailbox_;
  std::vector<Answer> answers_;
  std::vector<std::pair<std::uint64_t, HeightsAnswer>> heights_;
  int rooms_ = 0;
};

/// Chunks of a fake generator. Its clock stands still, so that only the first answer of a piece of work
/// and its end wake anybody.
struct FakeService {
  std::shared_ptr<FakeWork> work = std::make_shared<FakeWork>();
  Metrics metrics;
  MemoryBudget memory;
  ManualClock clock;
  Chunks service;

  explicit FakeService(std::size_t threads = 1, std::size_t queue_chunks = 1000,
                       std::uint64_t memory_bytes = 0, std::size_t cache_bytes = 1 << 20,
                       std::size_t own_chunks = 0)
      : memory{memory_bytes},
        service{std::make_unique<FakeGenerator>(work),
                {threads, 4, queue_chunks, cache_bytes, cache_bytes, own_chunks},
                make_logger("off", "text"),
                metrics,
                memory,
                clock} {
    service.start();
  }
  /// Threads behind a closed gate would never end.
  ~FakeService() { work->open_gate(); }
};

}  // namespace talus::server
