// A generator that makes nothing, counts its calls, and waits where a test wants it to.
#pragma once

#include <atomic>
#include <condition_variable>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "generation/chunk_service.h"
#include "generation/generator.h"

namespace talus::server {

/// What the fake does; shared by the test and the service.
struct FakeWork {
  std::atomic<int> patches{0};
  std::atomic<int> chunks{0};
  std::atomic<int> lent{0};  // patches that were given memory of others
  std::atomic<bool> out_of_memory{false};
  std::atomic<bool> finding_throws{false};
  std::atomic<std::size_t> payload_bytes{0};
  std::atomic<int> patch_columns{0};  // 4 bytes each
  std::atomic<std::int32_t> last_mixed_anywhere{std::numeric_limits<std::int32_t>::max()};
  std::atomic<std::int32_t> first_mixed{std::numeric_limits<std::int32_t>::min()};
  std::atomic<std::int32_t> last_mixed{std::numeric_limits<std::int32_t>::max()};

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

class FakeGenerator final : public Generator {
 public:
  explicit FakeGenerator(std::shared_ptr<FakeWork> work) : work_{std::move(work)} {}

  [[nodiscard]] EncodedChunkPtr instant(ChunkKey) const override {
    if (work_->finding_throws) throw std::bad_alloc{};
    return nullptr;
  }
  [[nodiscard]] EncodedChunkPtr uniform(MaterialId) const override {
    return std::make_shared<const EncodedChunk>(ContentHash{}, std::vector<std::byte>{});
  }
  /// As if all were mixed, unless the test says from where on there is air.
  [[nodiscard]] terrain::MixedRange rows_anywhere(Lod) const override {
    return {std::numeric_limits<std::int32_t>::min(), work_->last_mixed_anywhere, MaterialId{2}};
  }
  [[nodiscard]] terrain::MixedRange rows(const terrain::Stacks&, ChunkKey) const override {
    return {work_->first_mixed, work_->last_mixed, MaterialId{2}};
  }
  void make_patch(const PatchKey&, terrain::Stacks& stacks) const override {
    work_->pass_gate();
    ++work_->patches;
    if (work_->out_of_memory) throw std::bad_alloc{};
    if (!stacks.tops.empty()) ++work_->lent;
    stacks.tops.clear();
    if (work_->patch_columns > 0) stacks.tops.emplace_back(work_->patch_columns, 1);
  }
  [[nodiscard]] EncodedChunkPtr make_chunk(const terrain::Stacks&, ChunkKey key) const override {
    ++work_->chunks;
    return std::make_shared<const EncodedChunk>(ContentHash{std::hash<ChunkKey>{}(key), 0},
                                                std::vector<std::byte>(work_->payload_bytes));
  }
  [[nodiscard]] std::vector<std::int32_t> heights(
      std::span<const terrain::BaseColumn> columns) const override {
    if (work_->out_of_memory) throw std::bad_alloc{};
    return std::vector<std::int32_t>(columns.size());
  }

 private:
  std::shared_ptr<FakeWork> work_;
};

/// Keeps what it is given until a test waits for it.
class WaitingClient final : public ChunkClient {
 public:
  void chunks_ready(std::vector<ReadyChunk> chunks) override {
    const std::lock_guard lock{mutex_};
    for (ReadyChunk& chunk : chunks) answers_.emplace_back(chunk.key, std::move(chunk.answer));
    changed_.notify_all();
  }
  void heights_ready(std::uint64_t ticket, HeightsAnswer answer) override {
    const std::lock_guard lock{mutex_};
    heights_.emplace_back(ticket, std::move(answer));
    changed_.notify_all();
  }
  /// Waits until there are `count` answers of both kinds.
  void await(std::size_t count) {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return answers_.size() + heights_.size() >= count; });
  }
  [[nodiscard]] std::vector<std::pair<ChunkKey, ChunkAnswer>> answers() const {
    const std::lock_guard lock{mutex_};
    return answers_;
  }
  [[nodiscard]] std::vector<std::pair<std::uint64_t, HeightsAnswer>> heights() const {
    const std::lock_guard lock{mutex_};
    return heights_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::pair<ChunkKey, ChunkAnswer>> answers_;
  std::vector<std::pair<std::uint64_t, HeightsAnswer>> heights_;
};

/// A service on a fake generator.
struct FakeService {
  std::shared_ptr<FakeWork> work = std::make_shared<FakeWork>();
  Metrics metrics;
  MemoryBudget memory{0};
  ChunkService service;

  explicit FakeService(std::size_t threads = 1, std::size_t queue_chunks = 1000)
      : service{std::make_unique<FakeGenerator>(work),
                {threads, 4, queue_chunks, 1 << 20, 1 << 20},
                std::make_shared<spdlog::logger>("silent"),
                metrics,
                memory} {
    service.start();
  }
  /// Threads behind a closed gate would never end.
  ~FakeService() { work->open_gate(); }
};

}  // namespace talus::server
