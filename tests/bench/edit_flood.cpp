// How long a player who digs alone waits for his answers, while others flood: the intake and the log of one
// machine, on the disk of DIRECTORY. bench_edit_flood [DIRECTORY].
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <talus/store/edit_database.h>
#include <talus/voxel/codec.h>

#include "chunks/chunk_source.h"
#include "edits/edit_intake.h"
#include "edits/edit_state.h"
#include "edits/local_log.h"
#include "runtime/clock.h"

namespace {

using namespace talus;
using namespace talus::server;
namespace fs = std::filesystem;
using Now = std::chrono::steady_clock;

constexpr MaterialId kStone{2};
constexpr int kUnanswered = 64;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "bench_edit_flood: %s\n", what.c_str());
  std::exit(1);
}

/// Stone everywhere, in memory.
class Stone final : public ChunkSource {
 public:
  [[nodiscard]] EncodedChunkPtr find(ChunkKey, Version) override { return stone_; }
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey, std::uint64_t) override { return nullptr; }
  [[nodiscard]] MixedRows column(ChunkKey, Version) override { return {}; }
  [[nodiscard]] int columns_together() const override { return 1; }
  [[nodiscard]] std::size_t submit(const MailboxPtr&, std::span<const ChunkKey>, Urgency, Version) override {
    return 0;
  }
  void hasten(ClientId, std::span<const ChunkKey>) override {}
  void cancel(ClientId, std::span<const ChunkKey>) override {}
  void set_wanted(const MailboxPtr&, std::span<const LevelBox>) override {}
  void submit_heights(const MailboxPtr&, std::uint64_t, HeightsQuery) override {}
  void cancel_heights(ClientId, std::uint64_t) override {}
  [[nodiscard]] PicturePtr find_map(const map::Tile&) override { return nullptr; }

 private:
  EncodedChunkPtr stone_ = encode_shared(Chunk::uniform(kStone));
};

/// A session that sends its next edit as soon as one is answered, on the log's thread.
class Flooder {
 public:
  Flooder(EditIntake& intake, std::uint64_t id, FlowId flow, std::int64_t edge,
          std::atomic<std::uint64_t>& done)
      : intake_{intake},
        id_{id},
        edge_{edge},
        done_{done},
        mailbox_{std::make_shared<Mailbox>(
            ClientId{id}, [this] { answered(); }, std::make_shared<FlowUse>(flow, FlowName{}))} {}
  void start() { intake_.attach(mailbox_, {{}, "", 0}); }
  void stop() { stopped_ = true; }

 private:
  void answered() {
    for (Mail& mail : mailbox_->take()) {
      if (auto* const attached = std::get_if<AttachAnswer>(&mail)) {
        if (!attached->answer) fail(attached->answer.error().message);
        editor_ = *attached->answer;
        for (int i = 0; i < kUnanswered; ++i) send();
      } else {
        ++done_;
        send();
      }
    }
  }
  void send() {
    if (stopped_) return;
    ++sequence_;
    EditRequest request{static_cast<std::uint32_t>(sequence_), editor_.editor, editor_.epoch, sequence_, {}};
    const auto material = MaterialId{static_cast<std::uint16_t>(3 + sequence_ % 5)};
    const VoxelPos first{static_cast<std::int64_t>(id_) * 64, 0, 0};
    request.edit.fills.push_back(
        {first, {first.x + edge_ - 1, std::min<std::int64_t>(edge_, 16) - 1, edge_ - 1}, material, {}});
    request.extent = extent_of(request.edit, false);
    intake_.edit(mailbox_, std::move(request));
  }

  EditIntake& intake_;
  std::uint64_t id_;
  std::int64_t edge_;
  std::atomic<std::uint64_t>& done_;
  EditorSession editor_;
  std::uint64_t sequence_ = 0;
  std::atomic<bool> stopped_{false};
  MailboxPtr mailbox_;
};

/// A player's session, in this thread.
struct Digger {
  std::mutex mutex;
  std::condition_variable comes;
  bool woken = false;
  MailboxPtr mailbox = std::make_shared<Mailbox>(ClientId{1}, [this] {
    const std::lock_guard lock{mutex};
    woken = true;
    comes.notify_one();
  });
  Mail wait() {
    for (;;) {
      std::unique_lock lock{mutex};
      comes.wait(lock, [this] { return woken; });
      woken = false;
      lock.unlock();
      auto mail = mailbox->take();
      if (!mail.empty()) return std::move(mail.front());
    }
  }
};

void measure(const fs::path& path, const char* name, int sessions, bool one_flow, std::int64_t edge) {
  fs::remove_all(path);
  auto database = store::EditDatabase::open({.path = path, .fingerprint = {1, 2}, .store_id = {3, 4}});
  if (!database) fail(database.error());
  auto state = EditState::open(**database, {});
  if (!state) fail(state.error());
  const SystemClock clock;
  Metrics metrics;
  Stone stone;
  LocalLog log{**database, **state, clock, {}, {}};
  EditIntake intake{
      {stone, log, [&](edits::EditorId id) { return (*state)->editor(id); }, clock, metrics},
      {{0, 100}, {kAir, kStone, MaterialId{3}, MaterialId{4}, MaterialId{5}, MaterialId{6}, MaterialId{7}}},
      make_logger("off", "text")};
  intake.start();
  std::atomic<std::uint64_t> done{0};
  std::vector<std::unique_ptr<Flooder>> flood;
  for (int i = 0; i < sessions; ++i) {
    const auto id = static_cast<std::uint64_t>(100 + i);
    flood.push_back(std::make_unique<Flooder>(intake, id, FlowId{one_flow ? 7 : id}, edge, done));
    flood.back()->start();
  }
  Digger digger;
  intake.attach(digger.mailbox, {{}, "", 0});
  const EditorSession as = *std::get<AttachAnswer>(digger.wait()).answer;
  std::vector<double> ms;
  const auto start = Now::now();
  const std::uint64_t done_before = done;
  for (std::uint32_t id = 1; Now::now() - start < std::chrono::seconds{4}; ++id) {
    EditRequest request{id, as.editor, as.epoch, id, {}};
    request.edit.writes.push_back({{-5, 3, 3}, MaterialId{static_cast<std::uint16_t>(3 + id % 5)}});
    const auto sent = Now::now();
    request.extent = extent_of(request.edit, false);
    intake.edit(digger.mailbox, std::move(request));
    if (!std::get<EditAnswer>(digger.wait()).answer) fail("the digger is refused");
    ms.push_back(std::chrono::duration<double, std::milli>(Now::now() - sent).count());
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  const double others =
      static_cast<double>(done - done_before) / std::chrono::duration<double>(Now::now() - start).count();
  for (const auto& each : flood) each->stop();
  intake.stop();
  log.stop();
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double part) {
    return ms[static_cast<std::size_t>(part * static_cast<double>(ms.size() - 1))];
  };
  std::printf("%-52s others %7.0f edits/s  alone p50 %6.2f  p99 %6.2f  most %6.2f ms of %zu\n", name, others,
              at(0.5), at(0.99), ms.back(), ms.size());
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path path = (argc > 1 ? fs::path{argv[1]} : fs::temp_directory_path()) / "talus-bench-edit-flood";
  measure(path, "nobody else", 0, true, 1);
  measure(path, "100 sessions of one address, one voxel each", 100, true, 1);
  measure(path, "100 sessions of 100 addresses, one voxel each", 100, false, 1);
  measure(path, "100 sessions of one address, 65,536 voxels each", 100, true, 64);
  measure(path, "100 sessions of 100 addresses, 65,536 voxels each", 100, false, 64);
  fs::remove_all(path);
}
