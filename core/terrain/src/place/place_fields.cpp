#include "place/place_fields.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <talus/vectors/tables.h>

#include "surface/ground_tiles.h"

namespace talus::terrain {

PlaceFields::PlaceFields(std::shared_ptr<const Places> places, std::int32_t sea_fx, float subvoxels_a_unit,
                         InstructionSet set)
    : places_{std::move(places)},
      kernels_{place_kernels(set)},
      sea_fx_{sea_fx},
      units_a_subvoxel_{1 / subvoxels_a_unit},
      ranges_(places_->quantities) {
  for (const auto& cases : places_->looks) {
    for (const Places::Case& one : cases) {
      for (const Places::Condition& condition : one.conditions) asked_.push_back(condition.quantity);
    }
  }
  for (const Places::Share& share : places_->shares) {
    for (const Places::Ramp& ramp : share.early) asked_.push_back(ramp.quantity);
    late_ = late_ || !share.late.empty();
  }
  std::sort(asked_.begin(), asked_.end());
  asked_.erase(std::unique(asked_.begin(), asked_.end()), asked_.end());
}

void PlaceFields::start(int width, int depth) {
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
  for (auto& rows : any_) rows.assign(static_cast<std::size_t>(depth), 0);
  gathered_.resize(places_->quantities);
  rows_.resize(places_->quantities);
  share_.resize(padded(columns));
  thinned_.resize(padded(columns));
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
  std::uint64_t present = 0;  // bit k: some column of the row has look k
  if (!looks_.empty()) present = kernels_.present(looks_.front().row(z).data(), width);
  for (std::size_t i = 0; i < shares_.size(); ++i) set_share(i, z, width, present);
}

void PlaceFields::set_looks(int z, std::size_t width) {
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    const std::span<const Places::Case> cases = narrowed_.of(places_->looks[i], ranges_);
    const auto looks = looks_[i].row(z);
    if (cases.empty() || cases.front().conditions.empty()) {
      std::fill(looks.begin(), looks.end(), cases.empty() ? 0 : cases.front().look);
    } else {
      kernels_.look(cases, rows_, width, looks.data());
    }
  }
}

// Most rows have few looks, and most rules ask for others.
void PlaceFields::set_share(std::size_t i, int z, std::size_t width, std::uint64_t present) {
  const Places::Share& rule = places_->shares[i];
  std::uint8_t& any = any_[i][static_cast<std::size_t>(z)];
  any = present == 0 || (rule.looks & present) != 0 ? 1 : 0;
  // A ramp and its rounding are monotone, so that the ends of a row's range bound what it leaves there.
  for (const Places::Ramp& ramp : rule.early) {
    if (ramp.at(ranges_[ramp.quantity].low) <= 0 && ramp.at(ranges_[ramp.quantity].high) <= 0) any = 0;
  }
  if (any == 0) return;
  const auto out = share_to_set(i).row(z);
  std::fill_n(share_.begin(), width, kWholeShare);
  for (const Places::Ramp& ramp : rule.early) {
    if (ramp.at(ranges_[ramp.quantity].low) >= 1 && ramp.at(ranges_[ramp.quantity].high) >= 1) continue;
    kernels_.thin(ramp, rows_[ramp.quantity], share_.data(), width, thinned_.data());
    std::swap(share_, thinned_);
  }
  if ((present & ~rule.looks) == 0) {
    std::copy_n(share_.begin(), width, out.begin());
  } else {
    kernels_.keep(rule.looks, looks_.front().row(z).data(), share_.data(), width, out.data());
  }
}

/// Its values are unspecified in rows that have none.
Field& PlaceFields::share_to_set(std::size_t i) {
  Field& share = shares_[i];
  if (!share.values.empty()) return share;
  std::swap(share, spare_[i]);
  share.reshape(width_, depth_);
  return share;
}

namespace {

// Those of a tile, from the columns that `row` tells the beginning of each row of.
template <class Value, class Row>
GroundTile::Values<Value> tile_values(const Row& row) {
  constexpr auto kSide = static_cast<std::size_t>(kGroundTileSide);
  const auto first = row(0)[0];
  GroundTile::Values<Value> values{static_cast<Value>(first), nullptr};
  auto differs = static_cast<decltype(first + 0)>(0);
  for (int z = 0; z < kGroundTileSide; ++z) {
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

// Part of row z of a tile.
template <class Value, class To>
void take_tile_row(const GroundTile::Values<Value>& values, int z, int first, int count, To* to) {
  if (!values.each) {
    std::fill_n(to, count, static_cast<To>(values.all));
    return;
  }
  const Value* const from = &(*values.each)[static_cast<std::size_t>(kGroundTileSide * z + first)];
  std::copy_n(from, count, to);
}

}  // namespace

void PlaceFields::fill(int x, int z, GroundTile& tile) const {
  const auto column = static_cast<std::size_t>(x);
  tile.looks.resize(looks_.size());
  tile.shares.resize(shares_.size());
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    tile.looks[i] =
        tile_values<std::uint8_t>([&](int row) { return looks_[i].row(z + row).data() + column; });
  }
  static constexpr std::array<std::int32_t, kGroundTileSide> kNone{};
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (shares_[i].values.empty()) continue;
    tile.shares[i] = tile_values<std::uint16_t>([&](int row) {
      const bool any = any_[i][static_cast<std::size_t>(z + row)] != 0;
      return any ? shares_[i].row(z + row).data() + column : kNone.data();
    });
  }
}

void PlaceFields::take(int x, int z, const GroundTile& tile) {
  const int first = std::max(-x, 0);  // of the tile's columns
  const int count = std::min(width_ - x, kGroundTileSide) - first;
  const int first_row = std::max(-z, 0);
  const int last_row = std::min(depth_ - z, kGroundTileSide);
  if (count <= 0 || first_row >= last_row) return;
  const auto to = static_cast<std::size_t>(x + first);
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    for (int row = first_row; row < last_row; ++row) {
      take_tile_row(tile.looks[i], row, first, count, looks_[i].row(z + row).data() + to);
    }
  }
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    const GroundTile::Values<std::uint16_t>& values = tile.shares[i];
    if (!values.each && values.all == 0) continue;
    Field& share = share_to_set(i);
    for (int row = first_row; row < last_row; ++row) {
      std::uint8_t& any = any_[i][static_cast<std::size_t>(z + row)];
      const auto columns = share.row(z + row);
      if (any == 0) std::fill(columns.begin(), columns.end(), 0);
      any = 1;
      take_tile_row(values, row, first, count, columns.data() + to);
    }
  }
}

// Most rows are nowhere as steep as a ramp begins, or near no cliff; what a ramp leaves whole is not touched.
void PlaceFields::thin_late(const Field& slope, const Field* cliff) {
  for (int z = 0; z < depth_; ++z) {
    const auto row = static_cast<std::size_t>(z);
    const auto width = static_cast<std::size_t>(width_);
    ValueRange slopes;
    ValueRange cliffs;
    if (late_) slopes = kernels_.range_of_int32(slope.row(z).data(), width);
    if (late_ && cliff != nullptr) cliffs = kernels_.range_of_int32(cliff->row(z).data(), width);
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      if (shares_[i].values.empty()) continue;
      const auto share = shares_[i].row(z);
      bool any = any_[i][row] != 0;
      for (const Places::Ramp& ramp : places_->shares[i].late) {
        const bool by_slope = ramp.quantity == number_of(Quantity::slope);
        if (!any || (!by_slope && cliff == nullptr)) continue;
        const ValueRange& range = by_slope ? slopes : cliffs;
        // A ramp is monotone, and so is its rounding: its ends bound what it leaves.
        const float at_low = ramp.at(range.low);
        const float at_high = ramp.at(range.high);
        if (at_low >= 1 && at_high >= 1) continue;
        any = at_low > 0 || at_high > 0;
        if (!any) continue;
        std::copy_n(share.begin(), width, share_.begin());
        kernels_.thin_by_int32(ramp, (by_slope ? slope : *cliff).row(z).data(), share_.data(), width,
                               share.data());
      }
      if (!any) std::fill(share.begin(), share.end(), 0);
    }
  }
}

}  // namespace talus::terrain
