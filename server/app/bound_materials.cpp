#include "app/bound_materials.h"

#include <algorithm>
#include <future>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cluster/entry_codec.h"

namespace talus::server {
namespace {

constexpr std::size_t kMaxPlaceables = 65'000;
constexpr std::chrono::milliseconds kRetryToBind{200};
constexpr std::chrono::seconds kSayThatItWaits{10};

/// Counts overrides by material.
tl::expected<std::map<MaterialId, std::uint64_t>, std::string> count_uses(const store::EditDatabase& database,
                                                                          const EditState& state) {
  std::set<ChunkKey> chunks;
  const auto scanned = database.for_each_chunk([&](ChunkKey key, std::uint64_t) { chunks.insert(key); });
  if (!scanned) return tl::unexpected{scanned.error()};
  for (const ChunkKey key : state.dirty_chunks()) chunks.insert(key);
  std::map<MaterialId, std::uint64_t> uses;
  for (const ChunkKey key : chunks) {
    if (key.lod != Lod{}) continue;
    const auto chunk = state.load(key);
    if (!chunk) return tl::unexpected{chunk.error()};
    if (chunk->overrides == nullptr) continue;
    for (const Override& voxel : chunk->overrides->voxels()) ++uses[voxel.material];
  }
  return uses;
}

tl::expected<edits::EntryResult, EditError> apply_now(EditLog& edits, LogEntry entry,
                                                      const std::function<bool()>& waits) {
  using Outcome = tl::expected<edits::EntryResult, EditError>;
  const auto answer = std::make_shared<std::promise<Outcome>>();
  auto answered = answer->get_future();
  const auto taken = edits.append(std::move(entry), [answer](const auto& outcome) {
    answer->set_value(outcome ? Outcome{**outcome} : tl::unexpected{outcome.error()});
  });
  if (!taken) return tl::unexpected{taken.error()};
  while (answered.wait_for(kRetryToBind) != std::future_status::ready) {
    if (!waits()) return edit_error(EditErrorCode::cut_off, "the log does not answer");
  }
  return answered.get();
}

}  // namespace

tl::expected<std::vector<std::string>, std::string> names_without_ids(const terrain::World& world,
                                                                      store::EditDatabase& database,
                                                                      const EditState& state) {
  edits::MaterialIds generated;
  for (const terrain::Material& material : world.materials()) generated.emplace(material.name, material.id);
  if (const auto named = database.name_generated(generated); !named) return tl::unexpected{named.error()};
  const edits::MaterialIds& known = database.materials();
  if (known.size() + world.placeables().size() > kMaxPlaceables) {
    return tl::unexpected{fmt::format("data {}: the store has ids for {} more materials; the world names {}",
                                      database.path().string(), kMaxPlaceables - known.size(),
                                      world.placeables().size())};
  }
  edits::MaterialIds missing = known;
  for (const auto& [name, id] : generated) missing.erase(name);
  std::vector<std::string> names;
  for (const terrain::Placeable& placeable : world.placeables()) {
    if (!known.contains(placeable.name)) names.push_back(placeable.name);
    missing.erase(placeable.name);
  }
  if (missing.empty()) return names;
  const auto uses = count_uses(database, state);
  if (!uses) return tl::unexpected{uses.error()};
  for (const auto& [name, id] : missing) {
    if (const auto count = uses->find(id); count != uses->end()) {
      return tl::unexpected{
          fmt::format("data {}: the world has no [[placeable]] \"{}\" any more, but the store has {} voxels "
                      "of it; put it back into the world's file, give these voxels another name by talusd "
                      "store rename, or drop them by talusd store rebase --drop-unknown",
                      database.path().string(), name, count->second)};
    }
  }
  return names;
}

tl::expected<edits::NamedIds, std::string> bind_by_log(std::vector<std::string> names, EditLog& edits,
                                                       const Logger& log,
                                                       const std::function<bool()>& waits) {
  edits::NamedIds all;
  auto says = std::chrono::steady_clock::now();
  for (auto next = names.begin(); next != names.end();) {
    const auto last =
        next + std::min<std::ptrdiff_t>(names.end() - next, static_cast<std::ptrdiff_t>(cluster::kMaxNames));
    const auto applied = apply_now(edits, edits::BindEntry{{next, last}}, waits);
    if (!applied) {
      if (!waits()) {
        log->error(
            "the log has given no ids to the world's new materials: {}; they cannot be placed until this "
            "server is started again with the log reachable",
            applied.error().message);
        break;
      }
      if (const auto now = std::chrono::steady_clock::now(); now >= says) {
        log->warn("the world's {} new materials wait for ids from the log: {}", names.size(),
                  applied.error().message);
        says = now + kSayThatItWaits;
      }
      std::this_thread::sleep_for(kRetryToBind);
      continue;
    }
    if (applied->kind != edits::EntryResult::Kind::bound) {
      return tl::unexpected{
          fmt::format("the log has no ids for the world's {} new materials; the world must "
                      "name fewer",
                      names.size())};
    }
    all.insert(all.end(), applied->materials.begin(), applied->materials.end());
    next = last;
  }
  return all;
}

}  // namespace talus::server
