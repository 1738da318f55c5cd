#include <talus/terrain/erosion.h>

#include <algorithm>

namespace talus::terrain {
namespace {

void add(const Field& thickness, Field& surface) {
  for (std::size_t i = 0; i < surface.values.size(); ++i) surface.values[i] += thickness.values[i];
}

}  // namespace

Field LooseGround::surface() const {
  Field surface = base;
  for (const Field& material : thickness) add(material, surface);
  return surface;
}

void set_loose(const Field& surface, std::span<const LooseRules> rules, std::span<const Field> most,
               LooseGround& ground) {
  ground.base = surface;
  ground.thickness.resize(rules.size());
  for (std::size_t m = rules.size(); m-- > 0;) {
    Field& loose = ground.thickness[m];
    loose.reshape(surface.width, surface.depth);
    for (std::size_t i = 0; i < loose.values.size(); ++i) {
      const bool alike = most.empty() || most[m].values.empty();
      const std::int32_t t_fx = alike ? rules[m].t_fx : most[m].values[i];
      loose.values[i] = std::min(t_fx, ground.base.values[i]);
      ground.base.values[i] -= loose.values[i];
    }
  }
}

Eroder::Eroder(Neighbours neighbours) {
  // North-west first, row by row: this order selects the first of equally low neighbours.
  for (int z = -1; z <= 1; ++z) {
    for (int x = -1; x <= 1; ++x) {
      const bool itself = x == 0 && z == 0;
      const bool straight = x == 0 || z == 0;
      const bool wanted =
          neighbours == Neighbours::all || (neighbours == Neighbours::von_neumann) == straight;
      if (!itself && wanted) reaches_.push_back({x, z});
    }
  }
}

bool Eroder::step(std::span<const LooseRules> rules, LooseGround& ground) {
  // All surfaces are computed before any material moves.
  for (std::size_t m = 0; m < rules.size(); ++m) see_surface(m, ground);
  bool moved = false;
  for (std::size_t m = 0; m < rules.size(); ++m) moved |= step_material(m, rules[m], ground);
  return moved;
}

void Eroder::see_surface(std::size_t material, const LooseGround& ground) {
  surfaces_.resize(ground.thickness.size());
  surfaces_[material] = material == 0 ? ground.base : surfaces_[material - 1];
  add(ground.thickness[material], surfaces_[material]);
}

bool Eroder::step_material(std::size_t material, const LooseRules& rules, LooseGround& ground) {
  return move(surfaces_[material], rules.c_fx, erosion_step_fx(rules.c_fx), ground.thickness[material]);
}

std::int64_t Eroder::rest(std::span<const LooseRules> rules, LooseGround& ground) {
  std::int64_t steps = 0;
  Field under = ground.base;
  for (std::size_t m = 0; m < rules.size(); ++m) {
    for (bool moved = true; moved; ++steps) {
      surfaces_.resize(1);
      surfaces_.front() = under;
      add(ground.thickness[m], surfaces_.front());
      moved = move(surfaces_.front(), rules[m].c_fx, erosion_step_fx(rules[m].c_fx), ground.thickness[m]);
    }
    add(ground.thickness[m], under);
  }
  return steps;
}

bool Eroder::move(const Field& surface, std::int32_t c_fx, std::int32_t step_fx, Field& thickness) {
  change_.reshape(surface.width, surface.depth);
  std::fill(change_.values.begin(), change_.values.end(), 0);
  bool moved = false;
  for (int z = 0; z < surface.depth; ++z) {
    find_lowest_around(surface, z);
    for (int x = 0; x < surface.width; ++x) {
      if (surface.at(x, z) - lowest_[static_cast<std::size_t>(x)] <= c_fx) continue;
      const std::int32_t max_given = std::min(step_fx, thickness.at(x, z));
      if (max_given > 0) moved |= give(surface, c_fx, max_given, x, z);
    }
  }
  if (moved) add(change_, thickness);
  return moved;
}

void Eroder::find_lowest_around(const Field& surface, int z) {
  const auto own = surface.row(z);
  const auto north = surface.row(std::max(z - 1, 0));
  const auto south = surface.row(std::min(z + 1, surface.depth - 1));
  const std::size_t width = own.size();
  lowest_in_column_.resize(width + 2);
  lowest_.resize(width);
  for (std::size_t x = 0; x < width; ++x) {
    lowest_in_column_[x + 1] = std::min(own[x], std::min(north[x], south[x]));
  }
  lowest_in_column_.front() = lowest_in_column_[1];
  lowest_in_column_.back() = lowest_in_column_[width];
  for (std::size_t x = 0; x < width; ++x) {
    lowest_[x] = std::min(lowest_in_column_[x], std::min(lowest_in_column_[x + 1], lowest_in_column_[x + 2]));
  }
}

bool Eroder::give(const Field& surface, std::int32_t c_fx, std::int32_t max_given, int x, int z) {
  const std::int32_t here = surface.at(x, z);
  std::array<std::int32_t, 8> drops{};  // to neighbours that receive material, else 0
  std::int64_t sum = 0;
  std::size_t steepest = 0;
  for (std::size_t i = 0; i < reaches_.size(); ++i) {
    const int to_x = x + reaches_[i].x;
    const int to_z = z + reaches_[i].z;
    if (to_x < 0 || to_z < 0 || to_x >= surface.width || to_z >= surface.depth) continue;
    const std::int32_t drop = here - surface.at(to_x, to_z);
    if (drop <= c_fx) continue;
    drops[i] = drop;
    sum += drop;
    if (drop > drops[steepest]) steepest = i;
  }
  if (sum == 0) return false;
  // Eq. 2: in proportion to the drops. The rounding remainder goes to the first of the steepest.
  std::int32_t left = max_given;
  for (std::size_t i = 0; i < reaches_.size(); ++i) {
    if (drops[i] == 0) continue;
    const auto share = static_cast<std::int32_t>(std::int64_t{max_given} * drops[i] / sum);
    change_.at(x + reaches_[i].x, z + reaches_[i].z) += share;
    left -= share;
  }
  change_.at(x + reaches_[steepest].x, z + reaches_[steepest].z) += left;
  change_.at(x, z) -= max_given;
  return true;
}

}  // namespace talus::terrain
