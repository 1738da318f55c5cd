#include "commands/store/rename.h"

#include <chrono>
#include <limits>

#include <fmt/format.h>

#include <talus/store/edit_database.h>
#include <talus/store/rename_check.h>

#include "commands/store/opened_store.h"
#include "commands/store/store_figures.h"

namespace talus::server {

tl::expected<std::uint64_t, std::string> rename_material(const store::DataDirectory& directory,
                                                         const std::string& from, const std::string& to) {
  store::EditDatabaseSettings settings;
  std::uint64_t voxels = 0;
  {
    const auto store = open_whole(directory);
    if (!store) return tl::unexpected{store.error()};
    // Checked before the slow count.
    const auto id = store::check_rename((*store)->materials(), from, to);
    if (!id) return tl::unexpected{fmt::format("data {}: {}", directory.path().string(), id.error())};
    const auto uses = voxels_by_material(**store);
    if (!uses) return tl::unexpected{uses.error()};
    if (const auto of_it = uses->find(*id); of_it != uses->end()) voxels = of_it->second;
    settings.fingerprint = (*store)->meta().fingerprint;
    settings.store_id = (*store)->meta().store_id;
  }
  settings.path = directory.path();
  // Keeps all history; only talusd trims it.
  settings.history = {std::numeric_limits<std::uint64_t>::max(), std::chrono::milliseconds::max()};
  const auto database = store::EditDatabase::open(settings);
  if (!database) return tl::unexpected{database.error()};
  if (const auto renamed = (*database)->rename(from, to); !renamed) return tl::unexpected{renamed.error()};
  return voxels;
}

}  // namespace talus::server
