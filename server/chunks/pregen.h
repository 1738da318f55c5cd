// Generates land before players arrive, so that the cache on disk has it: squares of columns around a centre,
// nearest first, with all their mixed chunks.
//
// It takes its share of the generators' time, and pauses while others wait for them. It can be resumed: a
// file next to the cache records its progress, never more than is on the disk.
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
  static constexpr double kMinShare = 0.001;

  std::int32_t x = 0;  // the centre, in voxels
  std::int32_t z = 0;
  std::int32_t radius = 0;  // voxels, 1 to kMaxRadius
  int levels = 1;           // levels of detail, from 0; 1 to Lod::kMax + 1
  double share = 1;         // share of idle generator time: kMinShare to 1
  bool operator==(const PregenPlan&) const = default;

  /// The error is one line that begins with the flag's name.
  [[nodiscard]] tl::expected<void, std::string> check() const;
};

/// The squares of a plan, `tiles` columns of chunks a side, that touch the square of the radius.
class PregenSquares {
 public:
  PregenSquares(const PregenPlan& plan, int tiles);
  [[nodiscard]] std::uint64_t size() const;
  /// Returns the corner of a square: its columns are x to x + tiles - 1, and z to z + tiles - 1. Level 0
  /// first; each level in rings around its middle.
  [[nodiscard]] ChunkKey at(std::uint64_t index) const;

 private:
  /// One level of side * side squares.
  struct Level {
    std::int64_t side = 0;
    std::int32_t x = 0;  // the lowest corner, in squares
    std::int32_t z = 0;
  };
  Level levels_[Lod::kMax + 1];
  int count_;
  int tiles_;
};

struct PregenProgress {
  std::uint64_t squares = 0;  // done
  std::uint64_t of = 0;
  std::uint64_t columns = 0;  // columns of chunks, in this run
};

/// The signature of Pregen::run().
using RunPregen = std::function<tl::expected<PregenProgress, std::string>(
    const PregenPlan& plan, const std::function<bool(const PregenProgress&)>& report)>;

/// The error if nothing is stored on disk.
inline constexpr std::string_view kNoColumnCache =
    "generated chunks are not kept on disk here; set cache.disk_bytes and give --data DIR";

class Pregen {
 public:
  /// All of them outlive it. `others_wait` returns true if other clients wait for the generators.
  struct Parts {
    ChunkSource& chunks;
    std::function<bool()> others_wait;
    const Clock& clock;
    std::size_t at_once = 1;            // squares: the number of generator threads
    std::filesystem::path progress_at;  // a file
    std::function<void()> keep;         // writes the generated columns to disk
  };
  explicit Pregen(Parts parts) : parts_{std::move(parts)} {}

  /// Returns when everything is generated or `report`, which is called a few times a second, returns false.
  /// The error is one line.
  [[nodiscard]] tl::expected<PregenProgress, std::string> run(
      const PregenPlan& plan, const std::function<bool(const PregenProgress&)>& report);

 private:
  const Parts parts_;
};

/// Returns the number of squares done of exactly this plan, as recorded in the file; 0 if the file is for
/// another plan or damaged.
[[nodiscard]] std::uint64_t read_pregen_file(const std::filesystem::path& file, const PregenPlan& plan,
                                             int tiles);
[[nodiscard]] tl::expected<void, std::string> write_pregen_file(const std::filesystem::path& file,
                                                                const PregenPlan& plan, int tiles,
                                                                std::uint64_t done);

}  // namespace talus::server
