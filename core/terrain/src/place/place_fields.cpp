#include "place/place_fields.h"

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>
#include <utility>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {

PlaceFields::PlaceFields(std::shared_ptr<const Places> places, std::int32_t sea_fx, float subvoxels_a_unit,
                         InstructionSet set, std::vector<bool> at_points)
    : places_{std::move(places)},
      kernels_{place_kernels(set)},
      sea_fx_{sea_fx},
      units_a_subvoxel_{1 / subvoxels_a_unit},
      ranges_(places_->quantities),
      at_points_{std::move(at_points)} {
  for (const auto& cases : places_->looks) {
    narrowed_.emplace_back(cases);
    for (const Places::Case& one : cases) {
      for (const Places::Condition& condition : one.conditions) asked_.push_back(condition.quantity);
    }
  }
  for (const Places::Share& share : places_->shares) {
    for (const Places::Ramp& ramp : share.early) asked_.push_back(ramp.quantity);
  }
  std::sort(asked_.begin(), asked_.end());
  asked_.erase(std::unique(asked_.begin(), asked_.end()), asked_.end());
}

void PlaceFields::start(int width, int depth, bool from_tiles) {
  const auto columns = static_cast<std::size_t>(width);
  width_ = width;
  depth_ = depth;
  looks_.resize(places_->looks.size());
  for (LookField& looks : looks_) looks.reshape(width, depth);
  shares_.resize(places_->shares.size());
  spare_.resize(shares_.size());
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (!shares_[i].values.empty()) std::swap(shares_[i], spare_[i]);
  }
  any_.resize(shares_.size());
  for (auto& rows : any_) rows.assign(static_cast<std::size_t>(depth), Any::none);
  whole_.resize(shares_.size());
  for (auto& rows : whole_) rows.assign(static_cast<std::size_t>(depth), 0);
  only_.resize(looks_.size());
  for (auto& rows : only_) rows.assign(static_cast<std::size_t>(depth), kSeveral);
  from_tiles_ = from_tiles;
  tiles_a_row_ = 0;
  tiles_.clear();
  late_ = false;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    late_ = late_ || (!is_at_points(i) && !places_->shares[i].late.empty());
  }
  some_.assign(shares_.size(), 0);
  gathered_.resize(places_->quantities);
  rows_.resize(places_->quantities);
  whole_share_.resize(padded(columns), kWholeShare);
  for (auto& thinned : thinned_) thinned.resize(padded(columns));
}

void PlaceFields::set_row(int z, std::span<const float* const> quantities, std::size_t first,
                          std::size_t step, std::span<const std::int32_t> heights_fx) {
  const std::size_t width = heights_fx.size();
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const bool height = q == number_of(Quantity::height) && quantities[q] == nullptr;
    if (quantities[q] == nullptr && !height) continue;
    if (quantities[q] != nullptr && step == 1) {
      rows_[q] = quantities[q] + first;
      continue;
    }
    AlignedVector<float>& row = gathered_[q];
    row.resize(padded(width));
    for (std::size_t i = 0; i < width; ++i) {
      row[i] = height ? static_cast<float>(heights_fx[i] - sea_fx_) * units_a_subvoxel_
                      : quantities[q][first + i * step];
    }
    rows_[q] = row.data();
  }
  for (const QuantityNumber quantity : asked_) ranges_[quantity] = kernels_.range(rows_[quantity], width);
  set_looks(z, width);
  std::uint64_t present = 0;  // bit k: a column of the row has look k
  if (!looks_.empty()) present = kernels_.present(looks_.front().row(z).data(), width);
  for (std::size_t i = 0; i < shares_.size(); ++i) set_share(i, z, width, present);
}

void PlaceFields::set_looks(int z, std::size_t width) {
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    const std::span<const Places::Case> cases = narrowed_[i].in(ranges_);
    const auto looks = looks_[i].row(z);
    std::int16_t& only = only_[i][static_cast<std::size_t>(z)];
    if (cases.empty() || cases.front().conditions.empty()) {
      const std::uint8_t look = cases.empty() ? std::uint8_t{0} : cases.front().look;
      std::fill(looks.begin(), looks.end(), look);
      only = look;
    } else {
      kernels_.look(cases, rows_, width, looks.data());
      only = kSeveral;
    }
  }
}

// Most rows have few looks, and most rules want other looks.
void PlaceFields::set_share(std::size_t i, int z, std::size_t width, std::uint64_t present) {
  const Places::Share& rule = places_->shares[i];
  Any& any = any_[i][static_cast<std::size_t>(z)];
  any = Any::none;
  if (present != 0 && (rule.looks & present) == 0) return;
  // A ramp and its rounding are monotone, so the ends of a row's range bound its result.
  thinning_.clear();
  for (const Places::Ramp& ramp : rule.early) {
    const float at_low = ramp.at(ranges_[ramp.quantity].low);
    const float at_high = ramp.at(ranges_[ramp.quantity].high);
    if (at_low <= 0 && at_high <= 0) return;
    if (at_low < 1 || at_high < 1) thinning_.push_back(&ramp);
  }
  const bool all_looks = (present & ~rule.looks) == 0;
  any = !thinning_.empty() || !all_looks ? Any::some : Any::whole;
  const auto out = share_to_set(i).row(z);
  if (any == Any::whole) {
    std::fill(out.begin(), out.end(), kWholeShare);
    return;
  }
  // Each ramp reads the result of the one before; the last writes into the field.
  const std::int32_t* left = whole_share_.data();
  for (std::size_t k = 0; k < thinning_.size(); ++k) {
    const bool last = all_looks && k + 1 == thinning_.size();
    std::int32_t* const thinned = last ? out.data() : thinned_[k % 2].data();
    kernels_.thin(*thinning_[k], rows_[thinning_[k]->quantity], left, width, thinned);
    left = thinned;
  }
  if (!all_looks) kernels_.keep(rule.looks, looks_.front().row(z).data(), left, width, out.data());
}

/// Values are unspecified in rows without a share.
Field& PlaceFields::share_to_set(std::size_t i) {
  Field& share = shares_[i];
  if (!share.values.empty()) return share;
  std::swap(share, spare_[i]);
  share.reshape(width_, depth_);
  return share;
}

namespace {

// The values of a tile; `row(z)` points to the first column of its row z.
template <class Value, class Row>
GroundTile::Values<Value> tile_values(const Row& row) {
  constexpr auto kSide = static_cast<std::size_t>(kGroundTileSide);
  const auto first = row(0)[0];
  GroundTile::Values<Value> values{static_cast<Value>(first), nullptr};
  auto differs = static_cast<decltype(first + 0)>(0);
  for (int z = 0; z < kGroundTileSide && differs == 0; ++z) {
    const auto* const from = row(z);
    for (std::size_t k = 0; k < kSide; ++k) differs |= from[k] ^ first;
  }
  if (differs == 0) return values;
  values.each = std::make_unique_for_overwrite<GroundTile::Columns<Value>>();
  for (int z = 0; z < kGroundTileSide; ++z) {
    const auto* const from = row(z);
    Value* const to = &(*values.each)[kSide * static_cast<std::size_t>(z)];
    for (std::size_t k = 0; k < kSide; ++k) to[k] = static_cast<Value>(from[k]);
  }
  return values;
}

/// Some rows of a tile, and some columns of each.
struct PartOfTile {
  int first = 0;
  int count = 0;
  int first_row = 0;
  int rows = 0;
};

// Rows are mostly whole, so their length is a constant then. The loop's variables are captured by value to
// stay in registers: stores of bytes might alias them otherwise.
template <class Value, class To>
void take_part(const GroundTile::Values<Value>& values, const PartOfTile& part, To* to, std::size_t stride) {
  const auto skipped = static_cast<std::size_t>(kGroundTileSide * part.first_row + part.first);
  const Value* from = values.each ? values.each->data() + skipped : nullptr;
  const auto all = static_cast<To>(values.all);
  auto take = [from, all, to, stride, rows = part.rows](auto columns) mutable {
    if (from == nullptr) {
      for (int row = 0; row < rows; ++row, to += stride) std::fill_n(to, columns, all);
    } else {
      for (int row = 0; row < rows; ++row, to += stride, from += kGroundTileSide) {
        std::copy_n(from, columns, to);
      }
    }
  };
  if (part.count == kGroundTileSide) {
    take(std::integral_constant<int, kGroundTileSide>{});
  } else {
    take(part.count);
  }
}

// Returns true if all rows of a tile equal `so`.
template <class Row>
bool all_rows(const std::vector<Row>& rows, int z, Row so) {
  const auto first = rows.begin() + z;
  return std::all_of(first, first + kGroundTileSide, [&](Row row) { return row == so; });
}

}  // namespace

void PlaceFields::fill(int x, int z, GroundTile& tile) const {
  const auto column = static_cast<std::size_t>(x);
  tile.looks.resize(looks_.size());
  tile.shares.resize(shares_.size());
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    const std::int16_t only = only_[i][static_cast<std::size_t>(z)];
    if (only != kSeveral && all_rows(only_[i], z, only)) {
      tile.looks[i].all = static_cast<std::uint8_t>(only);
      continue;
    }
    tile.looks[i] =
        tile_values<std::uint8_t>([&](int row) { return looks_[i].row(z + row).data() + column; });
  }
  static constexpr std::array<std::int32_t, kGroundTileSide> kNone{};
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (shares_[i].values.empty() || all_rows(any_[i], z, Any::none)) continue;
    if (all_rows(any_[i], z, Any::whole)) {
      tile.shares[i].all = kWholeShare;
      continue;
    }
    tile.shares[i] = tile_values<std::uint16_t>([&](int row) {
      const bool any = any_[i][static_cast<std::size_t>(z + row)] != Any::none;
      return any ? shares_[i].row(z + row).data() + column : kNone.data();
    });
  }
}

void PlaceFields::take(int x, int z, const GroundTilePtr& tile) {
  const int first = std::max(-x, 0);  // first of the tile's columns
  const int count = std::min(width_ - x, kGroundTileSide) - first;
  const int first_row = std::max(-z, 0);
  const int last_row = std::min(depth_ - z, kGroundTileSide);
  if (count <= 0 || first_row >= last_row) return;
  take_at_points(x, z, tile);
  const PartOfTile part{first, count, first_row, last_row - first_row};
  const auto stride = static_cast<std::size_t>(width_);
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    take_part(tile->looks[i], part, &looks_[i].at(x + first, z + first_row), stride);
  }
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    const GroundTile::Values<std::uint16_t>& values = tile->shares[i];
    if (is_at_points(i) || (!values.each && values.all == 0)) continue;
    Field& share = share_to_set(i);
    for (int row = first_row; row < last_row; ++row) {
      Any& any = any_[i][static_cast<std::size_t>(z + row)];
      if (any == Any::none && count < width_) {
        const auto columns = share.row(z + row);
        std::fill(columns.begin(), columns.end(), 0);
      }
      int& whole = whole_[i][static_cast<std::size_t>(z + row)];
      if (!values.each && values.all == kWholeShare) whole += count;
      any = whole == width_ ? Any::whole : Any::some;
    }
    take_part(values, part, &share.at(x + first, z + first_row), stride);
  }
}

// Objects stand on few columns, so the tile is kept and looked up there.
void PlaceFields::take_at_points(int x, int z, const GroundTilePtr& tile) {
  if (at_points_.empty()) return;
  if (tiles_a_row_ == 0) {
    tile_x_ = static_cast<int>(kGroundTileSide - floor_mod(x, kGroundTileSide));
    tile_z_ = static_cast<int>(kGroundTileSide - floor_mod(z, kGroundTileSide));
    tiles_a_row_ = (width_ + tile_x_ + kGroundTileSide - 1) / kGroundTileSide;
    const int rows = (depth_ + tile_z_ + kGroundTileSide - 1) / kGroundTileSide;
    tiles_.assign(static_cast<std::size_t>(tiles_a_row_ * rows), nullptr);
  }
  const int place = (z + tile_z_) / kGroundTileSide * tiles_a_row_ + (x + tile_x_) / kGroundTileSide;
  tiles_[static_cast<std::size_t>(place)] = tile;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    const GroundTile::Values<std::uint16_t>& values = tile->shares[i];
    if (at_points_[i] && (values.each || values.all != 0)) some_[i] = 1;
  }
}

bool PlaceFields::has_share(std::size_t i) const {
  return is_at_points(i) ? some_[i] != 0 : !shares_[i].values.empty();
}

std::int32_t PlaceFields::early_share_at(std::size_t i, int x, int z) const {
  const int place = (z + tile_z_) / kGroundTileSide * tiles_a_row_ + (x + tile_x_) / kGroundTileSide;
  const GroundTile::Values<std::uint16_t>& share = tiles_[static_cast<std::size_t>(place)]->shares[i];
  if (!share.each) return share.all;
  const int column = (z + tile_z_) % kGroundTileSide * kGroundTileSide + (x + tile_x_) % kGroundTileSide;
  return (*share.each)[static_cast<std::size_t>(column)];
}

std::int32_t PlaceFields::share_at_point(std::size_t i, int x, int z) const {
  std::int32_t share = early_share_at(i, x, z);
  for (const Places::Ramp& ramp : places_->shares[i].late) {
    const bool by_slope = ramp.quantity == number_of(Quantity::slope);
    if (!by_slope && cliff_ == nullptr) continue;
    share = ramp.thinned(share, static_cast<float>((by_slope ? slope_ : cliff_)->at(x, z)));
  }
  return share;
}

// Most rows are nowhere as steep as a ramp begins, or are not near a cliff; a ramp that is 1 is skipped.
void PlaceFields::thin_late(const Field& slope, const Field* cliff) {
  slope_ = &slope;
  cliff_ = cliff;
  for (int z = 0; z < depth_; ++z) {
    const auto row = static_cast<std::size_t>(z);
    const auto width = static_cast<std::size_t>(width_);
    ValueRange slopes;
    ValueRange cliffs;
    if (late_) slopes = kernels_.range_of_int32(slope.row(z).data(), width);
    if (late_ && cliff != nullptr) cliffs = kernels_.range_of_int32(cliff->row(z).data(), width);
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      if (is_at_points(i) || shares_[i].values.empty()) continue;
      const auto share = shares_[i].row(z);
      Any& of_row = any_[i][row];
      bool any = of_row != Any::none;
      for (const Places::Ramp& ramp : places_->shares[i].late) {
        const bool by_slope = ramp.quantity == number_of(Quantity::slope);
        if (!any || (!by_slope && cliff == nullptr)) continue;
        const ValueRange& range = by_slope ? slopes : cliffs;
        // A ramp and its rounding are monotone, so its ends bound its result.
        const float at_low = ramp.at(range.low);
        const float at_high = ramp.at(range.high);
        if (at_low >= 1 && at_high >= 1) continue;
        any = at_low > 0 || at_high > 0;
        of_row = any ? Any::some : Any::none;
        if (!any) continue;
        std::copy_n(share.begin(), width, thinned_[0].begin());
        kernels_.thin_by_int32(ramp, (by_slope ? slope : *cliff).row(z).data(), thinned_[0].data(), width,
                               share.data());
      }
      if (!any) std::fill(share.begin(), share.end(), 0);
    }
  }
}

}  // namespace talus::terrain
