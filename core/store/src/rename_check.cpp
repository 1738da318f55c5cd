#include <talus/store/rename_check.h>

#include <fmt/format.h>
#include <talus/voxel/material_name.h>

namespace talus::store {

tl::expected<MaterialId, std::string> check_rename(const edits::MaterialIds& materials,
                                                   const std::string& from, const std::string& to) {
  const auto held = materials.find(from);
  if (held == materials.end()) {
    return tl::unexpected{fmt::format(
        "the store has no material \"{}\"; talusd store stat lists the materials that it has voxels of",
        from)};
  }
  if (to_integer(held->second) < edits::kFirstBound) {
    return tl::unexpected{
        fmt::format("material \"{}\" is one that the world generates: its file names it", from)};
  }
  if (const auto fault = material_name_fault(to)) {
    return tl::unexpected{fmt::format("\"{}\": {}", to, *fault)};
  }
  if (materials.contains(to)) {
    return tl::unexpected{fmt::format("\"{}\" is another material of the store; choose an unused name", to)};
  }
  return held->second;
}

}  // namespace talus::store
