#include "store_command/rename.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "log/escape.h"
#include "store/edit_database.h"
#include "store_command/opened_store.h"
#include "store_command/reports.h"
#include "store_command/store_figures.h"

namespace talus::server {

tl::expected<std::uint64_t, std::string> rename_material(const DataDirectory& directory,
                                                         const std::string& from, const std::string& to) {
  EditDatabaseSettings settings;
  std::map<MaterialId, std::uint64_t> voxels;
  std::map<std::string, MaterialId> materials;
  {
    const auto store = open_whole(directory);
    if (!store) return tl::unexpected{store.error()};
    const auto uses = voxels_by_material(**store);
    if (!uses) return tl::unexpected{uses.error()};
    voxels = *uses;
    materials = (*store)->materials();
    settings.fingerprint = (*store)->meta().fingerprint;
    settings.store_id = (*store)->meta().store_id;
  }
  const auto refuse = [&](const std::string& why) {
    return tl::unexpected{fmt::format("data {}: {}", directory.path().string(), why)};
  };
  const auto held = materials.find(from);
  if (held == materials.end()) {
    return refuse(fmt::format("the store has no material \"{}\"; stat lists those that it has voxels of",
                              escaped(from)));
  }
  if (const auto taken = materials.find(to); taken != materials.end()) {
    return refuse(fmt::format("\"{}\" is another material of the store, with {}; choose a name that none has",
                              escaped(to), counted(voxels[taken->second], "voxel")));
  }
  if (std::ranges::any_of(to, [](unsigned char byte) { return byte < 0x20 || byte == 0x7F; })) {
    return refuse(fmt::format("\"{}\" has control characters, and no world can name it", escaped(to)));
  }
  settings.path = directory.path();
  // How much of it is kept is talusd's to say.
  settings.history = {std::numeric_limits<std::uint64_t>::max(), std::chrono::milliseconds::max()};
  const auto database = EditDatabase::open(settings);
  if (!database) return tl::unexpected{database.error()};
  if (const auto renamed = (*database)->rename(from, to); !renamed) return tl::unexpected{renamed.error()};
  return voxels[held->second];
}

}  // namespace talus::server
