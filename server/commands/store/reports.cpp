#include "commands/store/reports.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <talus/store/regular_files.h>

#include "commands/store/moments.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

using ReportJson = nlohmann::ordered_json;

}  // namespace

MaterialNames::MaterialNames(const std::map<std::string, MaterialId>& materials) {
  for (const auto& [name, id] : materials) names_.emplace(id, on_one_line(name));
}

std::string MaterialNames::of(MaterialId material) const {
  const auto name = names_.find(material);
  return name == names_.end() ? fmt::format("material {}", to_integer(material)) : name->second;
}

std::string counted(std::uint64_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string readable_bytes(std::uint64_t bytes) {
  const auto number = static_cast<double>(bytes);
  if (number < 1e3) return fmt::format("{} bytes", bytes);
  if (number < 1e6) return fmt::format("{:.1f} kB", number / 1e3);
  if (number < 1e9) return fmt::format("{:.1f} MB", number / 1e6);
  return fmt::format("{:.1f} GB", number / 1e9);
}

std::string stat_lines(const OpenedStore& opened, const StoreFigures& figures) {
  const store::ReadOnlyStore& store = opened.store();
  const store::StoreMeta& meta = store.meta();
  std::string text;
  const auto line = [&](std::string_view name, std::string_view value) {
    text += fmt::format("{:<12} {}\n", name, value);
  };
  line("store", to_string(meta.store_id));
  line("world", to_string(meta.fingerprint));
  line("format", fmt::format("{}, level rule {}", store::kStoreFormat, meta.level_rule));
  line("server", opened.server() == nullptr   ? "not running"
                 : opened.read_only().empty() ? "runs"
                                              : "runs and takes no edits: " + opened.read_only());
  line("position", meta.head.position == 0 ? "0: no edits yet"
                                           : fmt::format("{}, revision {}, at {}", meta.head.position,
                                                         meta.head.revision, moment(meta.head.time_ms)));
  line("hash", edits::to_string(meta.head.hash));
  if (meta.stream.sequence != 0) {
    line("cluster", fmt::format("has read its stream up to message {}", meta.stream.sequence));
  }
  for (std::size_t level = 0; level < figures.levels.size(); ++level) {
    const auto& each = figures.levels[level];
    line(fmt::format("level {}", level),
         fmt::format("{} in {}", counted(each.voxels, "voxel"), counted(each.chunks, "chunk")));
  }
  line("undone",
       fmt::format("{}, of any level, as generated again", counted(figures.emptied_chunks, "chunk")));
  line("editors", fmt::format("{}", figures.editors));
  line("history", store.first_record() > meta.head.position
                      ? "none"
                      : fmt::format("entries {} to {}, {}", store.first_record(), meta.head.position,
                                    readable_bytes(store.record_bytes())));
  line("disk", readable_bytes(store::bytes_of_files(opened.path() / "db")));
  const MaterialNames names{store.materials()};
  for (const auto& [material, voxels] : figures.materials) {
    line(counted(voxels, "voxel"), names.of(material));
  }
  return text;
}

std::string stat_json(const OpenedStore& opened, const StoreFigures& figures) {
  const store::ReadOnlyStore& store = opened.store();
  const store::StoreMeta& meta = store.meta();
  ReportJson json;
  json["store_id"] = to_string(meta.store_id);
  json["fingerprint"] = to_string(meta.fingerprint);
  json["format"] = store::kStoreFormat;
  json["level_rule"] = meta.level_rule;
  json["server_runs"] = opened.server() != nullptr;
  if (meta.stream.sequence != 0) json["cluster_message"] = meta.stream.sequence;
  json["read_only"] = opened.read_only().empty() ? ReportJson{} : ReportJson(opened.read_only());
  json["position"] = meta.head.position;
  json["revision"] = meta.head.revision;
  json["time"] = moment(meta.head.time_ms);
  json["hash"] = edits::to_string(meta.head.hash);
  json["levels"] = ReportJson::array();
  for (const auto& level : figures.levels) {
    json["levels"].push_back({{"chunks", level.chunks}, {"voxels", level.voxels}});
  }
  json["undone_chunks"] = figures.emptied_chunks;
  json["editors"] = figures.editors;
  json["history"] = {{"first_position", store.first_record()},
                     {"last_position", meta.head.position},
                     {"bytes", store.record_bytes()}};
  json["disk_bytes"] = store::bytes_of_files(opened.path() / "db");
  const MaterialNames names{store.materials()};
  json["materials"] = ReportJson::object();
  for (const auto& [material, voxels] : figures.materials) json["materials"][names.of(material)] = voxels;
  return json.dump(2) + "\n";
}

}  // namespace talus::server
