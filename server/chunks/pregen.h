// Makes land before anybody comes for it, so that the cache on disk has it: squares of columns around a
// centre, nearest first, every mixed chunk of theirs.
//
// It takes its share of the generators' time, and none while others wait for them. Where it ended it goes on:
// a file beside the cache says how far it came, and never more than is on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>

#include "chunks/chunk_source.h"
#include "runtime/clock.h"

namespace talus::server {

struct PregenPlan {
  static constexpr std::int32_t kMaxRadius = 1 << 20;
  static constexpr double kLeastShare = 0.001;

  std::int32_t x = 0;  // of the centre, in voxels
  std::int32_t z = 0;
  std::int32_t radius = 0;  // voxels, 1 to kMaxRadius
  int levels = 1;           // of detail, from 0 on; 1 to Lod::kMax + 1
  double share = 1;         // of the time of generators that nobody waits for: kLeastShare to 1
  bool operator==(const PregenPlan&) const = default;

  /// An error is one line that begins with the flag's name.
  [[nodiscard]] tl::expected<void, std::string> check() const;
};

/// The squares of a plan: those whose columns of chunks, `tiles` a side, touch the square of the radius.
class PregenSquares {
 public:
  PregenSquares(const PregenPlan& plan, int tiles);
  [[nodiscard]] std::uint64_t size() const;
  /// The corner of a square: its columns are x to x + tiles - 1 and likewise z. Level 0 first, and of each
  /// level rings around its middle.
  [[nodiscard]] ChunkKey at(std::uint64_t index) const;

 private:
  /// Of one level: side * side squares.
  struct Level {
    std::int64_t side = 0;
    std::int32_t x = 0;  // of the lowest corner, in squares
    std::int32_t z = 0;
  };
  Level levels_[Lod::kMax + 1];
  int count_;
  int tiles_;
};

struct PregenProgress {
  std::uint64_t squares = 0;  // done
  std::uint64_t of = 0;
  std::uint64_t columns = 0;  // of chunks, in this run
};

/// As Pregen::run().
using RunPregen = std::function<tl::expected<PregenProgress, std::string>(
    const PregenPlan& plan, const std::function<bool(const PregenProgress&)>& report)>;

/// Why there is none, where nothing is kept on disk.
inline constexpr std::string_view kNoColumnCache =
    "what is generated is not kept on disk here; set cache.disk_bytes and give --data DIR";

class Pregen {
 public:
  /// All outlive it. `others_wait`: whether somebody else waits for the generators.
  struct Parts {
    ChunkSource& chunks;
    std::function<bool()> others_wait;
    const Clock& clock;
    std::size_t at_once = 1;            // squares: as many as there are generator threads
    std::filesystem::path progress_at;  // a file
    std::function<void()> keep;         // what was made is on the disk when it returns
  };
  explicit Pregen(Parts parts) : parts_{std::move(parts)} {}

  /// Returns when all is made, or `report` was false, which is asked a few times a second. An error is one
  /// line.
  [[nodiscard]] tl::expected<PregenProgress, std::string> run(
      const PregenPlan& plan, const std::function<bool(const PregenProgress&)>& report);

 private:
  const Parts parts_;
};

/// How many squares of this very plan were done, as its file says; 0 where it is of another plan or damaged.
[[nodiscard]] std::uint64_t read_pregen_file(const std::filesystem::path& file, const PregenPlan& plan,
                                             int tiles);
[[nodiscard]] tl::expected<void, std::string> write_pregen_file(const std::filesystem::path& file,
                                                                const PregenPlan& plan, int tiles,
                                                                std::uint64_t done);

}  // namespace talus::server
