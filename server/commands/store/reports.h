// Output of commands: lines for people, or JSON for programs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "commands/store/opened_store.h"
#include "commands/store/store_figures.h"

namespace talus::server {

/// Names of a store's materials.
class MaterialNames {
 public:
  explicit MaterialNames(const std::map<std::string, MaterialId>& materials);
  /// Returns "material 7" if the store has no name for it.
  [[nodiscard]] std::string of(MaterialId material) const;

 private:
  std::map<MaterialId, std::string> names_;
};

/// "1 voxel", "2 voxels".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view what);

/// Formats as "1.2 MB".
[[nodiscard]] std::string readable_bytes(std::uint64_t bytes);

[[nodiscard]] std::string stat_lines(const OpenedStore& opened, const StoreFigures& figures);
[[nodiscard]] std::string stat_json(const OpenedStore& opened, const StoreFigures& figures);

}  // namespace talus::server
