// A box of voxels that one editor changes, one edit after the other, and what each of them must do: an edit
// that is lost, happens twice or happens in part shows at the next ones, and in what the servers have at the
// end. Pure.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <talus/client/edit.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::chaos {

class Plot {
 public:
  static constexpr std::int64_t kEdge = 12;

  struct Step {
    client::Edit edit;
    bool conflicts = false;     // one of its guards does not hold: nothing may happen
    std::uint32_t changed = 0;  // voxels, where it happens
    std::vector<std::pair<std::size_t, MaterialId>> voxels;  // that it writes, in the order of this object
  };

  /// All of it is air. `palette`: of what is built, at least two materials.
  Plot(VoxelPos corner, std::vector<MaterialId> palette, std::uint64_t seed);

  /// A random edit.
  [[nodiscard]] Step next();
  /// It happened.
  void take(const Step& step);

  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  [[nodiscard]] VoxelPos voxel(std::size_t index) const;
  [[nodiscard]] MaterialId at(std::size_t index) const { return voxels_[index]; }

 private:
  [[nodiscard]] std::size_t below(std::size_t bound);
  [[nodiscard]] MaterialId any_material();
  void add_writes(Step& step);
  void add_fill(Step& step);
  void add_guards(Step& step);

  const VoxelPos corner_;
  const std::vector<MaterialId> palette_;
  std::vector<MaterialId> voxels_;
  std::mt19937_64 random_;
};

}  // namespace talus::chaos
