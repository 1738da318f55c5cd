#include "chunks/pregen.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>

#include "chunks/client_ids.h"

namespace talus::server {
namespace {

using namespace std::chrono_literals;

// Interval of checks for cancellation and for other waiting clients.
constexpr std::chrono::milliseconds kPollInterval{50};
// Interval of progress notes, each of which writes a file of the cache.
constexpr std::chrono::seconds kNote{10};
// Rows of a column that the cache keeps.
constexpr std::int64_t kMaxRows = 64;
constexpr std::size_t kMaxProgressBytes = 4096;

ClientId next_owner() {
  static std::atomic<std::uint64_t> next{0};
  return client_id(ClientKind::pregen, ++next);
}

/// Returns the offset of a square by its number, in growing rings: 0; then the eight around it; and so on.
/// Each ring runs clockwise from its north-west.
std::pair<std::int64_t, std::int64_t> on_rings(std::uint64_t number) {
  if (number == 0) return {0, 0};
  auto ring = static_cast<std::int64_t>(1);
  while (static_cast<std::uint64_t>((2 * ring + 1) * (2 * ring + 1)) <= number) ++ring;
  const auto inner = static_cast<std::uint64_t>((2 * ring - 1) * (2 * ring - 1));
  const auto along = static_cast<std::int64_t>(number - inner);
  const std::int64_t side = 2 * ring;
  const std::int64_t step = along % side;
  switch (along / side) {
    case 0:
      return {-ring + step, -ring};
    case 1:
      return {ring, -ring + step};
    case 2:
      return {ring - step, ring};
    default:
      return {-ring, ring - step};
  }
}

std::string text_of(const PregenPlan& plan, int tiles, std::uint64_t done) {
  return fmt::format("center {},{} radius {} levels {} tiles {} done {}\n", plan.x, plan.z, plan.radius,
                     plan.levels, tiles, done);
}

/// Waits for the generators' answers on the caller's own thread.
class AnswerWaiter {
 public:
  explicit AnswerWaiter(ChunkSource& chunks)
      : chunks_{chunks}, mailbox_{std::make_shared<Mailbox>(next_owner(), [state = state_] {
          const std::lock_guard lock{state->mutex};
          state->woken = true;
          state->changed.notify_all();
        })} {}
  ~AnswerWaiter() {
    const std::vector<ChunkKey> left{open_.begin(), open_.end()};
    chunks_.cancel(mailbox_->owner(), left);
  }
  AnswerWaiter(const AnswerWaiter&) = delete;
  AnswerWaiter& operator=(const AnswerWaiter&) = delete;

  /// Generates the chunks; returns false once `goes_on` does.
  [[nodiscard]] bool make(std::vector<ChunkKey> keys, const std::function<bool()>& goes_on) {
    while (!keys.empty() || !open_.empty()) {
      const std::size_t accepted = chunks_.submit(mailbox_, keys, Urgency::later, Version::generated);
      open_.insert(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(accepted));
      keys.erase(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(accepted));
      {
        std::unique_lock lock{state_->mutex};
        state_->changed.wait_for(lock, kPollInterval, [&] { return state_->woken; });
        state_->woken = false;
      }
      for (const Mail& mail : mailbox_->take()) {
        if (const auto* const chunk = std::get_if<ChunkReady>(&mail)) open_.erase(chunk->key);
      }
      if (mailbox_->has_lost()) open_.clear();  // out of memory: the lost ones are merely not stored
      if (!goes_on()) return false;
    }
    return true;
  }

 private:
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    bool woken = false;
  };
  ChunkSource& chunks_;
  const std::shared_ptr<State> state_ = std::make_shared<State>();
  const MailboxPtr mailbox_;
  std::set<ChunkKey> open_;
};

/// Waits for `time` in short intervals; returns false once `goes_on` does.
bool wait(std::chrono::nanoseconds time, const std::function<bool()>& goes_on) {
  std::mutex mutex;
  std::condition_variable never;
  for (; time > 0ns; time -= kPollInterval) {
    std::unique_lock lock{mutex};
    never.wait_for(lock, std::min<std::chrono::nanoseconds>(time, kPollInterval));
    if (!goes_on()) return false;
  }
  return true;
}

}  // namespace

tl::expected<void, std::string> PregenPlan::check() const {
  if (radius < 1 || radius > kMaxRadius) {
    return tl::unexpected{
        fmt::format("--radius: {} is out of range; give 1 to {} voxels", radius, kMaxRadius)};
  }
  if (levels < 1 || levels > Lod::kMax + 1) {
    return tl::unexpected{fmt::format("--levels: {} is out of range; give 1 to {}", levels, Lod::kMax + 1)};
  }
  if (!(share >= kMinShare && share <= 1)) {
    return tl::unexpected{fmt::format("--share: {} is out of range; give {} to 1", share, kMinShare)};
  }
  return {};
}

PregenSquares::PregenSquares(const PregenPlan& plan, int tiles) : count_{plan.levels}, tiles_{tiles} {
  for (int level = 0; level < count_; ++level) {
    const std::int64_t square = (std::int64_t{kChunkSize} * tiles) << level;  // voxels of level 0
    const auto floor = [square](std::int64_t at) {
      return (at - ((at % square) + square) % square) / square;
    };
    // An odd number, so that there is a middle.
    const std::int64_t ring = (plan.radius + square - 1) / square;
    const std::int64_t last = (std::int64_t{1} << (31 - level)) / (std::int64_t{kChunkSize} * tiles);
    const auto within = [&](std::int64_t middle) {  // do not search beyond the world's ends
      return static_cast<std::int32_t>(std::clamp<std::int64_t>(middle - ring, -last, last - 2 * ring - 1));
    };
    levels_[level] = {2 * ring + 1, within(floor(plan.x)), within(floor(plan.z))};
  }
}

std::uint64_t PregenSquares::size() const {
  std::uint64_t all = 0;
  for (int level = 0; level < count_; ++level) {
    all += static_cast<std::uint64_t>(levels_[level].side * levels_[level].side);
  }
  return all;
}

ChunkKey PregenSquares::at(std::uint64_t index) const {
  int level = 0;
  for (; level + 1 < count_; ++level) {
    const auto squares = static_cast<std::uint64_t>(levels_[level].side * levels_[level].side);
    if (index < squares) break;
    index -= squares;
  }
  const auto [right, down] = on_rings(index);
  const std::int64_t middle = levels_[level].side / 2;
  const auto corner = [&](std::int32_t low, std::int64_t step) {
    return static_cast<std::int32_t>((low + middle + step) * tiles_);
  };
  return {{corner(levels_[level].x, right), 0, corner(levels_[level].z, down)}, Lod::of(level)};
}

std::uint64_t read_pregen_file(const std::filesystem::path& file, const PregenPlan& plan, int tiles) {
  const auto text = files::read_regular_file(file, kMaxProgressBytes);
  if (!text) return 0;
  const std::string begins = text_of(plan, tiles, 0);
  const std::string_view same{begins.data(), begins.size() - 2};  // without the count and the end of line
  if (!text->starts_with(same)) return 0;
  std::uint64_t done = 0;
  for (const char digit : text->substr(same.size())) {
    if (digit < '0' || digit > '9') break;
    done = done * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  return std::min(done, PregenSquares{plan, tiles}.size());
}

tl::expected<void, std::string> write_pregen_file(const std::filesystem::path& file, const PregenPlan& plan,
                                                  int tiles, std::uint64_t done) {
  return files::write_file(file, text_of(plan, tiles, done)).map_error([](const files::FileError& failed) {
    return failed.message();
  });
}

tl::expected<PregenProgress, std::string> Pregen::run(
    const PregenPlan& plan, const std::function<bool(const PregenProgress&)>& report) {
  const int tiles = parts_.chunks.columns_together();
  const PregenSquares squares{plan, tiles};
  PregenProgress progress{read_pregen_file(parts_.progress_at, plan, tiles), squares.size()};
  AnswerWaiter waiting{parts_.chunks};
  const auto goes_on = [&] { return report(progress); };
  const auto note = [&] {
    parts_.keep();
    return write_pregen_file(parts_.progress_at, plan, tiles, progress.squares);
  };
  auto noted = parts_.clock.now();
  while (progress.squares < progress.of) {
    while (parts_.others_wait()) {
      if (!wait(kPollInterval, goes_on)) return note().map([&] { return progress; });
    }
    const auto began = parts_.clock.now();
    const std::uint64_t end = std::min<std::uint64_t>(progress.of, progress.squares + parts_.at_once);
    // Generating one chunk of each square also makes its terrain, which shows the other mixed chunks.
    std::vector<ChunkKey> first;
    std::vector<ChunkKey> columns;
    for (std::uint64_t index = progress.squares; index < end; ++index) {
      const ChunkKey corner = squares.at(index);
      for (int z = 0; z < tiles; ++z) {
        for (int x = 0; x < tiles; ++x) {
          columns.push_back({{corner.coord.x + x, 0, corner.coord.z + z}, corner.lod});
        }
      }
      const MixedRows rows = parts_.chunks.column(corner, Version::generated);
      const std::int64_t middle = (std::int64_t{rows.first} + rows.last) / 2;
      first.push_back({{corner.coord.x, static_cast<std::int32_t>(middle), corner.coord.z}, corner.lod});
    }
    if (!waiting.make(std::move(first), goes_on)) return note().map([&] { return progress; });
    std::vector<ChunkKey> others;
    for (const ChunkKey column : columns) {
      const MixedRows rows = parts_.chunks.column(column, Version::generated);
      const std::int64_t last = std::min<std::int64_t>(rows.last, std::int64_t{rows.first} + kMaxRows - 1);
      for (std::int64_t y = rows.first; y <= last; ++y) {
        const ChunkKey key{{column.coord.x, static_cast<std::int32_t>(y), column.coord.z}, column.lod};
        if (parts_.chunks.find(key, Version::generated) == nullptr) others.push_back(key);
      }
    }
    if (!waiting.make(std::move(others), goes_on)) return note().map([&] { return progress; });
    progress.squares = end;
    progress.columns += columns.size();
    const auto now = parts_.clock.now();
    if (now - noted > kNote) {
      noted = now;
      if (const auto written = note(); !written) return tl::unexpected{written.error()};
    }
    const std::chrono::duration<double, std::nano> busy = now - began;
    const std::chrono::duration<double, std::nano> rest = busy * ((1 - plan.share) / plan.share);
    if (!wait(std::chrono::duration_cast<std::chrono::nanoseconds>(rest), goes_on)) break;
  }
  (void)report(progress);
  return note().map([&] { return progress; });
}

}  // namespace talus::server
