#include "features/object_models.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <tuple>

#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {
namespace {

constexpr std::uint8_t kTrunk = 0;
constexpr std::uint8_t kCrown = 1;

/// A sequence of random numbers. Draw each in a statement of its own, as C++ does not order operands.
class ModelDraws {
 public:
  explicit ModelDraws(std::uint64_t seed) : state_{seed} {}
  int whole(int low, int high) {
    state_ += 0x9E3779B97F4A7C15U;
    return low + static_cast<int>(mix64(state_) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

// Compass directions, clockwise from east.
constexpr std::array<std::array<int, 2>, 8> kDirections{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

class Sculptor {
 public:
  explicit Sculptor(std::uint64_t seed) : draws{seed}, seed_{seed} {}

  void put(int x, int y, int z, std::uint8_t part) {
    if (std::abs(x) > kFormulaReach || std::abs(z) > kFormulaReach || y >= kFormulaTop || y < -kObjectRoot)
      return;
    put_row(y, z, Row{1} << (x + kFormulaReach), part);
  }
  void pillar(int x, int z, int from, int to, std::uint8_t part) {
    for (int y = from; y < to; ++y) put(x, y, z, part);
  }
  /// Returns true for a quarter of the ragged rim's voxels, which are left out.
  [[nodiscard]] bool frayed(int x, int y, int z) const {
    const auto place = static_cast<std::uint64_t>((x + 64) | (y + 64) << 8 | (z + 64) << 16);
    return mix64(seed_ ^ place * 0xD1B54A32D192ED03U) % 4 == 0;
  }
  struct Ellipsoid {
    int x, y, z;        // centre, in quarter voxels
    int width, height;  // half of either, in quarter voxels
  };
  /// Puts the union of several ellipsoids, with outermost voxels frayed if `ragged`.
  void ellipsoids(std::span<const Ellipsoid> all, int lowest, bool ragged, std::uint8_t part) {
    std::array<Disc, kMaxEllipsoids> discs;
    for (std::size_t k = 0; k < all.size(); ++k) discs[k] = disc_of(all[k]);
    for (int y = lowest; y < kFormulaTop; ++y) {
      Distances nearest;
      nearest.fill(kOutside);
      bool any = false;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const int dy = 4 * y + 2 - all[k].y;
        const int down = 256 * dy * dy / (all[k].height * all[k].height);
        if (down >= kOutside) continue;
        any = true;
        for (std::size_t i = discs[k].first; i < discs[k].last; ++i) {
          nearest[i] = std::min(nearest[i], static_cast<std::int16_t>(discs[k].across[i] + down));
        }
      }
      if (any) put_layer(y, nearest, ragged, part);
    }
  }
  /// The voxels, each with the lowest part put there.
  [[nodiscard]] ObjectModel model() const {
    ObjectModel voxels;
    voxels.reserve(kUsualVoxels);
    for (std::uint8_t part = 0; part < rows_.size(); ++part) {
      for (std::size_t row = 0; row < end_; ++row) {
        const Row hidden = part == 0 ? 0 : rows_[0][row];
        for (Row bits = rows_[part][row] & ~hidden; bits != 0; bits &= bits - 1) {
          voxels.push_back({static_cast<std::int8_t>(std::countr_zero(bits) - kFormulaReach),
                            static_cast<std::int8_t>(static_cast<int>(row) / kSide - kObjectRoot),
                            static_cast<std::int8_t>(static_cast<int>(row) % kSide - kFormulaReach), part});
        }
      }
    }
    voxels.shrink_to_fit();
    return voxels;
  }

  ModelDraws draws;
  static constexpr int kRim = 170;  // an ellipsoid's rim begins here, in 256ths
  static constexpr std::size_t kMaxEllipsoids = 4;

 private:
  using Row = std::uint32_t;  // a bit for each x
  static constexpr std::size_t kUsualVoxels = 512;
  static constexpr int kSide = 2 * kFormulaReach + 1;
  static constexpr int kStride = 24;  // of rows of distances: whole vectors
  static constexpr int kOutside = 256;
  using Distances = std::array<std::int16_t, kStride * kSide>;  // from centres, in 256ths; z slowest, then x

  /// An ellipsoid's distances along x and z; columns outside of [first, last) are outside of it.
  struct Disc {
    Distances across;
    std::size_t first = 0;
    std::size_t last = 0;
  };

  static Disc disc_of(const Ellipsoid& each) {
    Disc disc;
    disc.across.fill(kOutside);
    const int reach = each.width / 4 + 1;
    const auto low = [&](int middle) { return std::max(-kFormulaReach, floor_quarter(middle) - reach); };
    const auto high = [&](int middle) { return std::min(kFormulaReach, floor_quarter(middle) + 1 + reach); };
    const auto start_of = [](int z) { return static_cast<std::size_t>((z + kFormulaReach) * kStride); };
    for (int z = low(each.z); z <= high(each.z); ++z) {
      for (int x = low(each.x); x <= high(each.x); ++x) {
        const int dx = 4 * x - each.x;
        const int dz = 4 * z - each.z;
        const int across = 256 * (dx * dx + dz * dz) / (each.width * each.width);
        disc.across[start_of(z) + static_cast<std::size_t>(x + kFormulaReach)] =
            static_cast<std::int16_t>(std::min(across, kOutside));
      }
    }
    disc.first = start_of(low(each.z));
    disc.last = std::max(disc.first, start_of(high(each.z) + 1));
    return disc;
  }
  static int floor_quarter(int length) { return length >> 2; }

  void put_layer(int y, const Distances& nearest, bool ragged, std::uint8_t part) {
    for (int z = -kFormulaReach; z <= kFormulaReach; ++z) {
      const std::int16_t* const row = nearest.data() + (z + kFormulaReach) * kStride;
      Row inside = 0;
      Row rim = 0;
      for (int i = 0; i < kSide; ++i) {
        inside |= Row{row[i] < kOutside} << i;
        rim |= Row{row[i] > kRim} << i;
      }
      for (Row bits = ragged ? inside & rim : 0; bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        if (frayed(i - kFormulaReach, y, z)) inside &= ~(Row{1} << i);
      }
      put_row(y, z, inside, part);
    }
  }
  void put_row(int y, int z, Row bits, std::uint8_t part) {
    const auto row = static_cast<std::size_t>((y + kObjectRoot) * kSide + z + kFormulaReach);
    rows_[part][row] |= bits;
    if (bits != 0) end_ = std::max(end_, row + 1);
  }

  std::uint64_t seed_;
  std::size_t end_ = 0;  // rows from here on are empty
  std::array<std::array<Row, static_cast<std::size_t>((kFormulaTop + kObjectRoot) * kSide)>, 2> rows_{};
};

void conifer(Sculptor& tree) {
  const int height = tree.draws.whole(10, 22);
  const int tier = tree.draws.whole(3, 4);
  const int base = 2 + height / 8;
  tree.pillar(0, 0, -kObjectRoot, base, kTrunk);  // needles hide the trunk above
  for (int y = base; y < height + 2; ++y) {
    const int down = height + 2 - y;
    const int cone = 4 * down * (height / 5 + 2) / (height + 2 - base) + 2;
    const int radius = cone * (5 + 3 * (down % tier) / (tier - 1)) / 8 + 1;
    for (int z = -kFormulaReach; z <= kFormulaReach; ++z) {
      for (int x = -kFormulaReach; x <= kFormulaReach; ++x) {
        const int square = 16 * (x * x + z * z);
        if (square > radius * radius) continue;
        const bool rim = 256 * square > Sculptor::kRim * radius * radius && square > 16;
        if (!(rim && tree.frayed(x, y, z))) tree.put(x, y, z, kCrown);
      }
    }
  }
}

struct Crown {
  int radius;  // voxels
  int flat;    // height relative to the width, in quarters
};

// An ellipsoid in the middle and three around it.
void crown(Sculptor& tree, int trunk, Crown form) {
  const int wide = 4 * form.radius;
  const auto high = [&](int width) { return std::max(4, width * form.flat / 4); };
  const int middle_y = 4 * trunk + high(wide) / 2;
  std::array<Sculptor::Ellipsoid, 4> all{{{0, middle_y, 0, wide, high(wide)}}};
  const int turn = tree.draws.whole(0, 7);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const int away = wide * tree.draws.whole(5, 8) / 14;
    const int lift = tree.draws.whole(-2, 3);
    const auto& direction = kDirections[(static_cast<std::size_t>(turn) + 3 * (k - 1)) % 8];
    const bool diagonal = direction[0] != 0 && direction[1] != 0;
    const int step = diagonal ? away * 181 / 256 : away;
    all[k] = {direction[0] * step, middle_y + lift, direction[1] * step, wide * 3 / 4, high(wide * 3 / 4)};
  }
  tree.ellipsoids(all, std::max(1, trunk - form.radius), true, kCrown);
}

void broadleaf(Sculptor& tree) {
  const int trunk = tree.draws.whole(4, 8);
  const int radius = tree.draws.whole(3, 5);
  tree.pillar(0, 0, -kObjectRoot, trunk, kTrunk);
  crown(tree, trunk, {radius, 3});
}

void acacia(Sculptor& tree) {
  const int trunk = tree.draws.whole(5, 7);
  const int radius = tree.draws.whole(4, 6);
  tree.pillar(0, 0, -kObjectRoot, trunk, kTrunk);
  // Two boughs hold the canopy.
  const int turn = tree.draws.whole(0, 7);
  for (int k = 0; k < 2; ++k) {
    const auto& direction = kDirections[static_cast<std::size_t>((turn + 4 * k) % 8)];
    for (int i = 1; i <= 3; ++i) tree.put(direction[0] * i, trunk - 3 + i, direction[1] * i, kTrunk);
  }
  crown(tree, trunk, {radius, 1});
}

void jungle_tree(Sculptor& tree) {
  const int trunk = tree.draws.whole(12, 18);
  const int radius = tree.draws.whole(5, 7);
  for (int x = 0; x < 2; ++x) {
    for (int z = 0; z < 2; ++z) tree.pillar(x, z, -kObjectRoot, trunk, kTrunk);
  }
  // Buttresses, lower toward the outside.
  const int turn = tree.draws.whole(0, 3);
  for (int k = 0; k < 3; ++k) {
    const auto& direction = kDirections[static_cast<std::size_t>(2 * ((turn + k) % 4))];
    const int high = tree.draws.whole(2, 4);
    const int from_x = direction[0] > 0 ? 2 : direction[0] < 0 ? -1 : 0;
    const int from_z = direction[1] > 0 ? 2 : direction[1] < 0 ? -1 : 0;
    tree.pillar(from_x, from_z, -kObjectRoot, high, kTrunk);
    tree.pillar(from_x + direction[0], from_z + direction[1], -kObjectRoot, high / 2, kTrunk);
  }
  crown(tree, trunk, {radius, 2});
}

void dead_tree(Sculptor& tree) {
  const int height = tree.draws.whole(6, 12);
  tree.pillar(0, 0, -kObjectRoot, height, kTrunk);
  const int turn = tree.draws.whole(0, 7);
  for (int branch = 0; branch < 4; ++branch) {
    const auto& direction = kDirections[static_cast<std::size_t>((turn + 3 * branch) % 8)];
    const int from = height / 3 + branch * height / 6;
    const int length = tree.draws.whole(2, 5);
    const int rise = tree.draws.whole(1, 2);
    for (int i = 1; i <= length; ++i) {
      tree.put(direction[0] * i, from + i * rise / 2, direction[1] * i, kTrunk);
    }
  }
}

void cactus(Sculptor& plant) {
  const int height = plant.draws.whole(4, 9);
  plant.pillar(0, 0, -kObjectRoot, height, kTrunk);
  const int turn = plant.draws.whole(0, 3);
  for (int arm = 0; arm < 2; ++arm) {
    const auto& direction = kDirections[static_cast<std::size_t>(2 * ((turn + 2 * arm) % 4))];
    const int from = height / 3 + arm;
    const int up = plant.draws.whole(2, 5);
    for (int i = 1; i <= 2; ++i) plant.put(direction[0] * i, from, direction[1] * i, kTrunk);
    plant.pillar(2 * direction[0], 2 * direction[1], from, std::min(from + up, height + 1), kTrunk);
  }
}

void boulder(Sculptor& stone) {
  const int radius = stone.draws.whole(1, 3);
  std::array<Sculptor::Ellipsoid, 3> all;
  for (int k = 0; k < 3; ++k) {
    const int width = 4 * radius - k * radius + stone.draws.whole(0, 3);
    const int x = k == 0 ? 0 : stone.draws.whole(-3 * radius, 3 * radius);
    const int z = k == 0 ? 0 : stone.draws.whole(-3 * radius, 3 * radius);
    const int y = stone.draws.whole(-2, radius);
    all[static_cast<std::size_t>(k)] = {x, y, z, std::max(5, width), std::max(5, width * 3 / 4)};
  }
  stone.ellipsoids(all, -2, false, kTrunk);
}

void bush(Sculptor& plant) {
  const int wide = plant.draws.whole(5, 12);
  const int high = plant.draws.whole(5, 11);
  plant.ellipsoids(std::array<Sculptor::Ellipsoid, 1>{{{0, 0, 0, wide, high}}}, -1, true, kTrunk);
}

/// Sorts, and drops duplicates.
void tidy(ObjectModel& model) {
  const auto place = [](const ModelVoxel& v) { return std::tuple{v.y, v.z, v.x}; };
  std::sort(model.begin(), model.end(), [&](const ModelVoxel& a, const ModelVoxel& b) {
    return std::tuple{place(a), a.part} < std::tuple{place(b), b.part};
  });
  const auto same = [&](const ModelVoxel& a, const ModelVoxel& b) { return place(a) == place(b); };
  model.erase(std::unique(model.begin(), model.end(), same), model.end());
  std::stable_sort(model.begin(), model.end(),
                   [](const ModelVoxel& a, const ModelVoxel& b) { return a.part < b.part; });
}

}  // namespace

ObjectModel model_of(const VoxelModel& model, const std::array<std::uint8_t, 256>& parts) {
  ObjectModel made;
  int lowest = kMaxModelHeight;
  for (const VoxelModel::Voxel& voxel : model.voxels) lowest = std::min<int>(lowest, voxel.y);
  for (const VoxelModel::Voxel& voxel : model.voxels) {
    const int top = voxel.y - lowest;
    const auto x = static_cast<std::int8_t>(voxel.x - model.width / 2);
    const auto z = static_cast<std::int8_t>(voxel.z - model.depth / 2);
    for (int y = top == 0 ? -kObjectRoot : top; y <= top; ++y) {
      made.push_back({x, static_cast<std::int8_t>(y), z, parts[voxel.colour]});
    }
  }
  tidy(made);
  return made;
}

namespace {

/// The cells around a model that it fills, to the coarsest level's step on each side.
class OccupiedCells {
 public:
  explicit OccupiedCells(const ObjectModel& model) {
    int reach = 0;
    int top = 0;
    for (const ModelVoxel& v : model) {
      reach = std::max({reach, std::abs(int{v.x}), std::abs(int{v.z})});
      top = std::max(top, v.y + 1);
    }
    width_ = 2 * (reach + kMargin) + 1;
    full_.resize(static_cast<std::size_t>((kObjectRoot + top + 2 * kMargin) * width_ * width_));
    first_ = ((kMargin + kObjectRoot) * width_ + kMargin + reach) * width_ + kMargin + reach;
    for (const ModelVoxel& v : model) full_[index(v)] = 1;
  }
  [[nodiscard]] bool has_neighbour(const ModelVoxel& voxel, int step) const {
    const auto along = [&](int stride) {
      const auto away = static_cast<std::size_t>(step * stride);
      return full_[index(voxel) - away] | full_[index(voxel) + away];
    };
    return (along(1) | along(width_) | along(width_ * width_)) != 0;
  }

 private:
  static constexpr int kMargin = 1 << ModelLevels::kCoarsest;
  [[nodiscard]] std::size_t index(const ModelVoxel& v) const {
    return static_cast<std::size_t>(first_ + (v.y * width_ + v.z) * width_ + v.x);
  }
  int width_ = 0;
  int first_ = 0;
  std::vector<std::uint8_t> full_;
};

}  // namespace

int levels_shown(std::span<const ObjectModel> models) {
  std::size_t all = 0;
  std::array<std::size_t, ModelLevels::kCoarsest> together{};
  for (const ObjectModel& model : models) {
    const OccupiedCells full{model};
    for (const ModelVoxel& voxel : model) {
      if (voxel.y < 0) continue;
      ++all;
      for (int level = 1; level <= ModelLevels::kCoarsest; ++level) {
        const int step = 1 << level;
        if (voxel.y < step || full.has_neighbour(voxel, step))
          ++together[static_cast<std::size_t>(level - 1)];
      }
    }
  }
  for (std::size_t i = 0; i < together.size(); ++i) {
    if (3 * together[i] < 2 * all) return static_cast<int>(i) + 1;
  }
  return Lod::kMax + 1;
}

namespace {

/// Sorts voxels by keys from 0 to starts.size() - 2, and sets where each key starts; equal ones keep their
/// order.
template <class Key>
void sort_by(const Key& key, std::vector<ModelVoxel>& voxels, std::span<std::uint32_t> starts) {
  for (const ModelVoxel& voxel : voxels) ++starts[key(voxel)];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<ModelVoxel> sorted(voxels.size());
  for (auto voxel = voxels.rbegin(); voxel != voxels.rend(); ++voxel) sorted[--starts[key(*voxel)]] = *voxel;
  voxels = std::move(sorted);
}

}  // namespace

ModelColumns::ModelColumns(const ObjectModel& model) : voxels_{model} {
  for (const ModelVoxel& v : voxels_) reach_ = std::max({reach_, std::abs(int{v.x}), std::abs(int{v.z})});
  const auto column = [&](const ModelVoxel& v) { return column_of(v.x, v.z); };
  starts_.resize(column_of(reach_, reach_) + 2);
  sort_by(column, voxels_, starts_);
}

ModelRows::ModelRows(const ObjectModel& model) : voxels_{model} {
  const auto row_of = [](const ModelVoxel& v) {
    return (v.part == 0 ? 0 : kRows) + static_cast<std::size_t>(v.y + kObjectRoot);
  };
  sort_by(row_of, voxels_, starts_);
}

std::span<const ModelVoxel> ModelRows::at(bool front, std::int64_t from, std::int64_t to) const {
  const auto start_of = [&](std::int64_t row) {
    const auto place = std::clamp<std::int64_t>(row + kObjectRoot, 0, kRows);
    return std::size_t{starts_[(front ? 0 : kRows) + static_cast<std::size_t>(place)]};
  };
  return std::span{voxels_}.subspan(start_of(from), start_of(std::max(from, to)) - start_of(from));
}

namespace {

// The group by x, y and z modulo 4. Groups that agree modulo 2 are adjacent.
std::size_t group_of(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto bits = [&](int shift) {
    return static_cast<std::size_t>((x >> shift & 1) | (y >> shift & 1) << 1 | (z >> shift & 1) << 2);
  };
  return bits(0) << 3 | bits(1);
}

}  // namespace

ModelLevels::ModelLevels(const ObjectModel& model) : voxels_{model} {
  const auto place_of = [](const ModelVoxel& v) {
    return (v.part == 0 ? 0 : kGroups) + group_of(v.x, v.y, v.z);
  };
  sort_by(place_of, voxels_, starts_);
}

std::span<const ModelVoxel> ModelLevels::at(bool front, int level, std::int64_t x, std::int64_t y,
                                            std::int64_t z) const {
  const std::size_t groups = kGroups >> 3 * level;
  const std::size_t group = group_of(x, y, z) & ~(groups - 1);
  const std::size_t first = (front ? 0 : kGroups) + group;
  return std::span{voxels_}.subspan(starts_[first], starts_[first + groups] - starts_[first]);
}

ObjectModel make_model(ModelKind kind, std::uint64_t seed) {
  using Make = void (*)(Sculptor&);
  static constexpr std::array<Make, kModelKinds> kMakers{conifer,   broadleaf, acacia,  jungle_tree,
                                                         dead_tree, cactus,    boulder, bush};
  Sculptor sculptor{seed};
  kMakers[static_cast<std::size_t>(kind)](sculptor);
  return sculptor.model();
}

}  // namespace talus::terrain
