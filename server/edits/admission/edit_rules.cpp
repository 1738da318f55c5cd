#include "edits/admission/edit_rules.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>

namespace talus::server {
namespace {

constexpr std::size_t kMaxBoxesNamed = 4;  // in the message about a token's boxes

/// The smallest box around all voxels that a paste writes; nullopt if it writes nothing.
std::optional<Box> box_of(const edits::Paste& paste) {
  constexpr std::int64_t kLast = kChunkSize - 1;
  if (paste.with_air) {
    return Box{paste.origin, {paste.origin.x + kLast, paste.origin.y + kLast, paste.origin.z + kLast}};
  }
  const auto voxels = std::make_unique<DenseVoxels>();
  paste.voxels.copy_to(*voxels);
  std::optional<Box> box;
  for (std::size_t index = 0; index < voxels->size(); ++index) {
    if ((*voxels)[index] == kAir) continue;
    const VoxelPos at = voxel_at(paste.origin, local_of(index));
    if (!box) box = Box{at, at};
    box->first = {std::min(box->first.x, at.x), std::min(box->first.y, at.y), std::min(box->first.z, at.z)};
    box->last = {std::max(box->last.x, at.x), std::max(box->last.y, at.y), std::max(box->last.z, at.z)};
  }
  return box;
}

/// Calls visit(box) for each operation that writes, until it returns why the operation is forbidden.
template <typename Visit>
std::optional<std::string> first_forbidden(const edits::Edit& edit, Visit&& visit) {
  for (std::size_t i = 0; i < edit.writes.size(); ++i) {
    const VoxelPos at = edit.writes[i].voxel;
    if (auto why = visit(Box{at, at})) return fmt::format("write {}: {}", i, *why);
  }
  for (std::size_t i = 0; i < edit.fills.size(); ++i) {
    if (auto why = visit(Box{edit.fills[i].first, edit.fills[i].last}))
      return fmt::format("fill {}: {}", i, *why);
  }
  if (edit.paste) {
    if (const auto box = box_of(*edit.paste)) {
      if (auto why = visit(*box)) return fmt::format("paste: {}", *why);
    }
  }
  return std::nullopt;
}

const Box* first_met(const Boxes& boxes, const Box& box) {
  const auto met = std::ranges::find_if(boxes, [&](const Box& each) { return each.meets(box); });
  return met == boxes.end() ? nullptr : &*met;
}

std::string named(const Boxes& boxes) {
  if (boxes.empty()) return "nowhere";
  std::string text = "in ";
  std::size_t count = 0;
  for (const Box& box : boxes) {
    if (count == kMaxBoxesNamed) return text + fmt::format(" and {} more", boxes.size() - count);
    text += (count++ == 0 ? "" : "; ") + to_string(box);
  }
  return text;
}

std::string shown(const Box& box) {
  const auto& [x, y, z] = box.first;
  return box.first == box.last ? fmt::format("voxel {},{},{}", x, y, z) : "the box " + to_string(box);
}

/// True if arithmetic on the corners cannot overflow. An edit farther out is refused later.
bool near_world(const edits::Edit& edit) {
  constexpr std::int64_t kFar = std::int64_t{1} << 40;
  const auto near = [](const VoxelPos& at) {
    return std::max({std::abs(at.x / 2), std::abs(at.y / 2), std::abs(at.z / 2)}) < kFar;
  };
  return std::ranges::all_of(edit.writes, near, &edits::VoxelWrite::voxel) &&
         std::ranges::all_of(edit.fills, near, &edits::Fill::first) &&
         std::ranges::all_of(edit.fills, near, &edits::Fill::last) &&
         (!edit.paste || near(edit.paste->origin));
}

const Boxes& protected_from(const Grant& grant, const EditRules& rules) {
  static const Boxes kNone;
  return grant.rights.has(Right::admin) ? kNone : rules.protected_boxes;
}

bool is_bounded(const Grant& grant, const EditRules& rules) {
  return !protected_from(grant, rules).empty() || !grant.edit_not_in.empty() || grant.edit_in;
}

std::optional<std::string> box_forbidden(const Box& box, const Grant& grant, const EditRules& rules) {
  if (const Box* const met = first_met(protected_from(grant, rules), box)) {
    return fmt::format("{} intersects {}, which this server protects", shown(box), to_string(*met));
  }
  if (const Box* const met = first_met(grant.edit_not_in, box)) {
    return fmt::format("{} intersects {}, where this session's token forbids edits", shown(box),
                       to_string(*met));
  }
  if (grant.edit_in &&
      std::ranges::none_of(*grant.edit_in, [&](const Box& each) { return each.holds(box); })) {
    return fmt::format("{} is outside the boxes of this session's token, which allows edits {}", shown(box),
                       named(*grant.edit_in));
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> edits_forbidden(const Grant& grant, const EditRules& rules) {
  if (!grant.rights.has(Right::edit))
    return "this session has no right to edit: neither a token nor access.without_token gives it";
  if (rules.gateway_required && !grant.rights.has(Right::gateway)) {
    return "edits.gateway is \"required\" on this server, and this session has no right \"gateway\"";
  }
  return std::nullopt;
}

std::optional<std::string> edit_forbidden(const edits::Edit& edit, const Grant& grant,
                                          const EditRules& rules) {
  if (!is_bounded(grant, rules) || !near_world(edit)) return std::nullopt;
  return first_forbidden(edit, [&](const Box& box) { return box_forbidden(box, grant, rules); });
}

bool may_settle(const edits::VoxelBox& loose, const Grant& grant, const EditRules& rules) {
  return !is_bounded(grant, rules) || !box_forbidden({loose.first, loose.last}, grant, rules);
}

}  // namespace talus::server
