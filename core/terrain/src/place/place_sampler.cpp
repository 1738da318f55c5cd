#include <talus/terrain/places.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <talus/terrain/surface.h>
#include <talus/vectors/instruction_set.h>

#include "place/place_fields.h"
#include "place/places.h"
#include "surface/regions/regions.h"
#include "surface/surface_rows.h"

namespace talus::terrain {
namespace {

bool known_at_columns(std::size_t quantity, bool regions) {
  if (quantity == number_of(Quantity::slope) || quantity == number_of(Quantity::cliff)) return false;
  return regions || quantity == number_of(Quantity::height);
}

// Keeps only the looks of the first rules.
Places looks_alone(const PlacesSpec& spec) {
  Places places = places_of(spec);
  places.looks.resize(std::min<std::size_t>(places.looks.size(), 1));
  places.shares.clear();
  return places;
}

}  // namespace

struct PlaceSampler::Scratch {
  Surface surface;
  std::unique_ptr<SurfaceRows> rows;
  std::optional<PlaceFields> fields;
  std::vector<QuantityNumber> wanted;
  std::vector<const float*> quantities;
  std::vector<std::int32_t> heights;
  std::vector<std::vector<float>> values;
  std::vector<std::uint8_t> no_looks;
  std::int32_t sea_fx = 0;
  float units_a_subvoxel = 1;
};

std::vector<std::string> place_names(const World& world) {
  const bool regions = world.spec().surface.regions.has_value();
  std::vector<std::string> names;
  for (std::size_t q = 0; q < kQuantities; ++q) {
    if (known_at_columns(q, regions)) names.emplace_back(kQuantityNames[q]);
  }
  for (const FieldSpec& field : world.spec().fields) {
    if (std::find(kQuantityNames.begin(), kQuantityNames.end(), field.name) == kQuantityNames.end()) {
      names.push_back(field.name);
    }
  }
  return names;
}

std::optional<PlaceSampler> PlaceSampler::make(const World& world, std::span<const std::string> names) {
  auto scratch = std::make_unique<Scratch>();
  PlacesSpec places = world.spec().places;
  const bool regions = world.spec().surface.regions.has_value();
  for (const std::string& name : names) {
    const auto quantity = static_cast<std::size_t>(
        std::distance(kQuantityNames.begin(), std::find(kQuantityNames.begin(), kQuantityNames.end(), name)));
    if (quantity < kQuantityNames.size()) {
      if (!known_at_columns(quantity, regions)) return std::nullopt;
      scratch->wanted.push_back(quantity);
      continue;
    }
    const auto named = [&](const FieldSpec& field) { return field.name == name; };
    const auto& all = world.spec().fields;
    const auto field = std::find_if(all.begin(), all.end(), named);
    if (field == all.end()) return std::nullopt;
    auto asked = std::find_if(places.fields.begin(), places.fields.end(), named);
    if (asked == places.fields.end()) asked = places.fields.insert(places.fields.end(), *field);
    scratch->wanted.push_back(kQuantities + static_cast<std::size_t>(asked - places.fields.begin()));
  }
  WorldSpec spec = world.spec();
  spec.places = places;
  scratch->surface = surface_of(spec);
  scratch->surface.places = std::make_shared<const Places>(looks_alone(places));
  scratch->rows = make_surface_rows(scratch->surface, instruction_set());
  scratch->sea_fx = world.sea_fx().value_or(0);
  const auto subvoxels_a_unit = static_cast<float>(spec.resolution * kSubvoxels);
  scratch->units_a_subvoxel = 1 / subvoxels_a_unit;  // as in PlaceFields
  scratch->fields.emplace(scratch->surface.places, scratch->sea_fx, subvoxels_a_unit, instruction_set());
  scratch->quantities.resize(scratch->surface.places->quantities);
  scratch->values.resize(names.size());
  return PlaceSampler{std::move(scratch)};
}

PlaceSampler::PlaceSampler(std::unique_ptr<Scratch> scratch) : scratch_{std::move(scratch)} {}
PlaceSampler::~PlaceSampler() = default;
PlaceSampler::PlaceSampler(PlaceSampler&&) noexcept = default;
PlaceSampler& PlaceSampler::operator=(PlaceSampler&&) noexcept = default;

void PlaceSampler::start(std::span<const std::int64_t> xs) {
  Scratch& s = *scratch_;
  s.rows->start(xs);
  s.fields->start(static_cast<int>(xs.size()), 1);
  s.heights.resize(xs.size());
  s.no_looks.assign(xs.size(), 0);
  for (auto& values : s.values) values.resize(xs.size());
}

void PlaceSampler::row(std::int64_t z) {
  Scratch& s = *scratch_;
  s.rows->row(z, s.heights.data());
  s.rows->quantities(z, s.quantities);
  s.fields->set_row(0, s.quantities, 0, 1, s.heights);
  for (std::size_t i = 0; i < s.wanted.size(); ++i) {
    const float* const from = s.quantities[s.wanted[i]];
    for (std::size_t k = 0; k < s.heights.size(); ++k) {
      // A surface without quantities has only height.
      s.values[i][k] =
          from != nullptr ? from[k] : static_cast<float>(s.heights[k] - s.sea_fx) * s.units_a_subvoxel;
    }
  }
}

std::span<const std::int32_t> PlaceSampler::heights_fx() const {
  return scratch_->heights;
}

std::span<const std::uint8_t> PlaceSampler::looks() const {
  const std::vector<LookField>& looks = scratch_->fields->looks();
  return looks.empty() ? std::span<const std::uint8_t>{scratch_->no_looks} : looks.front().row(0);
}

std::span<const float> PlaceSampler::values(std::size_t i) const {
  return scratch_->values[i];
}

namespace {

// Indices of the columns of one tile. Rows span all of them, so that each row is started once.
using TileOfColumns = std::vector<std::size_t>;
std::vector<TileOfColumns> by_tile(std::span<const BaseColumn> columns) {
  std::map<std::pair<std::int64_t, std::int64_t>, TileOfColumns> tiles;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    tiles[{floor_div(columns[i].z, kChunkSize), floor_div(columns[i].x, kChunkSize)}].push_back(i);
  }
  std::vector<TileOfColumns> found;
  for (auto& [tile, places] : tiles) found.push_back(std::move(places));
  return found;
}

}  // namespace

PlaceValues places_at(const World& world, std::span<const BaseColumn> columns,
                      std::span<const std::string> names) {
  PlaceSampler sampler = PlaceSampler::make(world, names).value();
  PlaceValues found;
  found.looks.resize(columns.size());
  found.values.resize(columns.size() * names.size());
  std::vector<std::int64_t> xs;
  for (TileOfColumns& tile : by_tile(columns)) {
    xs.clear();
    for (const std::size_t i : tile) xs.push_back(columns[i].x);
    std::sort(xs.begin(), xs.end());
    xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
    std::sort(tile.begin(), tile.end(),
              [&](std::size_t a, std::size_t b) { return columns[a].z < columns[b].z; });
    sampler.start(xs);
    std::optional<std::int64_t> row;
    for (const std::size_t i : tile) {
      if (row != columns[i].z) sampler.row(columns[i].z);
      row = columns[i].z;
      const auto x =
          static_cast<std::size_t>(std::lower_bound(xs.begin(), xs.end(), columns[i].x) - xs.begin());
      found.looks[i] = sampler.looks()[x];
      for (std::size_t name = 0; name < names.size(); ++name) {
        found.values[i * names.size() + name] = sampler.values(name)[x];
      }
    }
  }
  return found;
}

}  // namespace talus::terrain
