#include "commands/store/store_commands.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <ranges>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <talus/progress/progress_bar.h>
#include <talus/saves/save_file.h>
#include <talus/store/id_check.h>
#include <talus/store/store_swap.h>
#include <talus/store/whole_store.h>

#include "commands/store/backup.h"
#include "commands/store/history_report.h"
#include "commands/store/local_writer.h"
#include "commands/store/moments.h"
#include "commands/store/opened_store.h"
#include "commands/store/rename.h"
#include "commands/store/reports.h"
#include "commands/store/rollback.h"
#include "commands/store/save_export.h"
#include "commands/store/store_figures.h"
#include "commands/store/subjects.h"
#include "commands/store/transfer.h"
#include "config/boxes.h"
#include "runtime/log/escape.h"

namespace talus::server::store_commands {

namespace {

namespace fs = std::filesystem;

/// Parses comma-separated numbers to fill `into`.
bool parse_numbers(std::string_view text, std::span<std::int64_t> into) {
  for (std::size_t i = 0; i < into.size(); ++i) {
    const std::string_view part = text.substr(0, text.find(','));
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), into[i]);
    if (error != std::errc{} || stop != part.data() + part.size()) return false;
    text.remove_prefix(part.size());
    if (i + 1 == into.size()) return text.empty();
    if (text.empty()) return false;
    text.remove_prefix(1);
  }
  return false;
}

std::int64_t now_ms() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Answer show_stat(const Flags& flags, const Outside&) {
  const auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  ProgressBar progress{"stat", "chunks"};
  const auto figures = read_figures(opened->store(), progress);
  if (!figures) return tl::unexpected{figures.error()};
  return flags.json ? stat_json(*opened, *figures) : stat_lines(*opened, *figures);
}

Answer verify_all(const Flags& flags, const Outside&) {
  const auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  ProgressBar progress{"verify", "chunks"};
  const auto figures = read_figures(opened->store(), progress);
  if (!figures) return tl::unexpected{figures.error()};
  if (const auto sound = verify(opened->store(), *figures); !sound) return tl::unexpected{sound.error()};
  if (const auto opens = store::check_opens(flags.data, opened->store().meta()); !opens) {
    return tl::unexpected{opens.error()};
  }
  const store::StoreMeta& meta = opened->store().meta();
  const std::uint64_t first = opened->store().first_record();
  const std::string entries = first > meta.head.position
                                  ? "no entries of the log"
                                  : fmt::format("entries {} to {} of the log", first, meta.head.position);
  return fmt::format("sound: {} in {}, {}, hash {}\n", counted(figures->levels[0].voxels, "voxel"),
                     counted(figures->levels[0].chunks, "chunk"), entries, edits::to_string(meta.head.hash));
}

Answer backup(const Flags& flags, const Outside&) {
  const auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  const auto written = write_backup(opened->path(), flags.path);
  if (!written) return tl::unexpected{written.error()};
  return fmt::format("{}: position {}, revision {}, {}\n", flags.path, written->head.position,
                     written->head.revision, readable_bytes(written->bytes()));
}

Answer restore(const Flags& flags, const Outside&) {
  if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
  // Before the directory is created.
  if (const auto manifest = read_manifest(flags.path); !manifest) return tl::unexpected{manifest.error()};
  const auto directory = store::DataDirectory::open_any(flags.data);
  if (!directory) return tl::unexpected{directory.error()};
  if (const auto alone = check_is_alone(flags.data, "restore"); !alone) return tl::unexpected{alone.error()};
  const auto restored = restore_backup(flags.path, *directory, flags.replace);
  if (!restored) return tl::unexpected{restored.error()};
  std::string text =
      fmt::format("{}: store {} at position {}, revision {}\n", flags.data, to_string(restored->store_id),
                  restored->manifest.head.position, restored->manifest.head.revision);
  if (!restored->replaced.empty()) {
    text += fmt::format("{}: the store before; delete it if it is not needed\n", restored->replaced.string());
  }
  return text;
}

Answer compact_store(const Flags& flags, const Outside&) {
  if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
  const auto directory = store::DataDirectory::open_store(flags.data);
  if (!directory) return tl::unexpected{directory.error()};
  if (const auto done = store::compact(flags.data); !done) return tl::unexpected{done.error()};
  return std::string{"compacted\n"};
}

namespace {

/// Ignores errors; say() reports them.
void to_standard_output(std::string_view text) {
  (void)std::fwrite(text.data(), 1, text.size(), stdout);
}

Answer show_subjects_history(const Flags& flags) {
  SubjectQuery query;
  auto subject = parse_subject(flags.subject);
  if (!subject) return tl::unexpected{fmt::format("--subject: {}", subject.error())};
  query.subject = *std::move(subject);
  if (!flags.since.empty()) {
    const auto since = parse_moment(flags.since, now_ms());
    if (!since) return tl::unexpected{fmt::format("--since: {}", since.error())};
    query.since_ms = *since;
  }
  query.after = static_cast<std::uint64_t>(flags.after);
  query.max_edits = flags.count;
  const auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  if (const auto printed = print_history(opened->store(), query, flags.json, to_standard_output); !printed) {
    return tl::unexpected{printed.error()};
  }
  return std::string{};
}

}  // namespace

tl::expected<VoxelPos, std::string> parse_voxel(const std::string& text) {
  std::array<std::int64_t, 3> at{};
  if (parse_numbers(text, at)) return VoxelPos{at[0], at[1], at[2]};
  return tl::unexpected{fmt::format("\"{}\" is wrong; give X,Y,Z in voxels", escaped(text))};
}

Answer show_history(const Flags& flags, const Outside&) {
  if (!flags.at) return show_subjects_history(flags);
  const auto at = parse_voxel(*flags.at);
  if (!at) return tl::unexpected{fmt::format("--at: {}", at.error())};
  const auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  const auto printed = print_history(opened->store(), *at, flags.json, to_standard_output);
  if (!printed) return tl::unexpected{printed.error()};
  return std::string{};
}

tl::expected<Box, std::string> parse_box(const std::string& text) {
  if (text.find(':') != std::string::npos) {
    const auto boxes = Boxes::parse(text);
    if (!boxes) return tl::unexpected{boxes.error()};
    if (boxes->size() != 1) {
      return tl::unexpected{fmt::format("\"{}\" is {} boxes; give one", escaped(text), boxes->size())};
    }
    return *boxes->begin();
  }
  std::array<std::int64_t, 6> box{};
  if (!parse_numbers(text, box)) {
    return tl::unexpected{
        fmt::format("\"{}\" is wrong; give two corners in voxels, X0,Y0,Z0,X1,Y1,Z1 or X0,Y0,Z0:X1,Y1,Z1",
                    escaped(text))};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box[axis] > box[axis + 3]) std::swap(box[axis], box[axis + 3]);
  }
  return Box{{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
}

namespace {

tl::expected<RollbackRequest, std::string> rollback_request(const Flags& flags) {
  const auto box = parse_box(flags.box);
  if (!box) return tl::unexpected{fmt::format("--box: {}", box.error())};
  const auto since = parse_moment(flags.since, now_ms());
  if (!since) return tl::unexpected{fmt::format("--since: {}", since.error())};
  auto subject = parse_subject(flags.subject);
  if (!subject) return tl::unexpected{fmt::format("--subject: {}", subject.error())};
  return RollbackRequest{*std::move(subject), *since, box->first, box->last};
}

/// For a plan that found no change by the subject, whose name may be misspelt: a line with the subjects
/// found.
std::string unmet_subject_line(const RollbackRequest& request, const RollbackPlan& plan) {
  constexpr std::size_t kNamed = 5;
  std::string there;
  for (const Changer& other : plan.others | std::views::take(kNamed)) {
    there += fmt::format("{}{} ({})", there.empty() ? "" : ", ", subject_text(other.subject),
                         counted(other.voxels, "voxel"));
  }
  if (plan.others.size() > kNamed) there += fmt::format(", and {} more", plan.others.size() - kNamed);
  return fmt::format("{} changed nothing in that box since {}; {}\n", subject_text(request.subject),
                     moment(request.since_ms),
                     there.empty() ? "nor did any other subject" : "subjects that did: " + there);
}

}  // namespace

Answer rollback(const Flags& flags, const Outside&) {
  const auto request = rollback_request(flags);
  if (!request) return tl::unexpected{request.error()};
  auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  const store::StoreIdentity identity = opened->identity();
  const auto plan = [&] {
    ProgressBar progress{"looking for changes", "entries"};
    return plan_rollback(opened->store(), *request, progress);
  }();
  if (!plan) return tl::unexpected{plan.error()};
  opened->close_files();
  std::string text;
  if (plan->first_position > 1 && plan->first_time_ms > request->since_ms) {
    text = fmt::format("records go back to {} only; what was changed before stays\n",
                       moment(plan->first_time_ms));
  }
  if (plan->date_fell_to_ms) {
    text += fmt::format(
        "warning: an entry dated {} follows changes by {} dated later, which stay: the clock was wrong; "
        "to include them, give --since {}\n",
        moment(*plan->date_fell_to_ms), subject_text(request->subject), moment(*plan->date_fell_to_ms));
  }
  std::string others;
  if (plan->already_back > 0) {
    others += fmt::format("; {} {} put back before", counted(plan->already_back, "voxel"),
                          plan->already_back == 1 ? "was" : "were");
  }
  if (plan->taken_over > 0) {
    others += fmt::format("; {} changed by others since {}", counted(plan->taken_over, "voxel"),
                          plan->taken_over == 1 ? "stays" : "stay");
  }
  if (plan->slices.empty()) {
    text +=
        fmt::format("{}{}\n", flags.dry_run ? "nothing would be put back" : "nothing to put back", others);
    return plan->met_subject || plan->date_fell_to_ms ? text : text + unmet_subject_line(*request, *plan);
  }
  const std::string edits = counted(plan->slices.size(), "edit");
  if (flags.dry_run) {
    return text +
           fmt::format("{} would be put back, in {}{}\n", counted(plan->voxels, "voxel"), edits, others);
  }
  std::unique_ptr<LocalWriter> writer;
  Restore restore;
  if (opened->server() != nullptr) {
    restore = [&](const auto& slice) { return opened->server()->restore(slice); };
  } else {
    if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
    if (const auto may = opened->lock_to_write(); !may) return tl::unexpected{may.error()};
    auto local = LocalWriter::open(flags.data, identity);
    if (!local) return tl::unexpected{local.error()};
    writer = *std::move(local);
    restore = [&](const auto& slice) { return writer->restore(slice); };
  }
  ProgressBar progress{"rollback", "voxels"};
  const auto changed = roll_back(*plan, restore, progress);
  if (!changed) return tl::unexpected{changed.error()};
  return text + fmt::format("{} {} put back, in {}{}\n", counted(*changed, "voxel"),
                            *changed == 1 ? "was" : "were", edits, others);
}

namespace {

/// Summary of an import or rebase.
std::string rebuilt_lines(const std::string& data, const Rebuilt& rebuilt) {
  std::string text = fmt::format("{}: store {} with {} in {}\n", data, to_string(rebuilt.store_id),
                                 counted(rebuilt.voxels, "voxel"), counted(rebuilt.chunks, "chunk"));
  if (!rebuilt.replaced.empty()) {
    text += fmt::format("{}: the store before, with its history; delete it if it is not needed\n",
                        rebuilt.replaced.string());
  }
  return text;
}

}  // namespace

namespace {

/// Returns the missing directories of `path`, deepest first.
std::vector<fs::path> missing_directories(const fs::path& path) {
  std::error_code code;
  fs::path at = fs::absolute(path, code).lexically_normal();
  if (!at.has_filename()) at = at.parent_path();  // "/data/" is "/data"
  std::vector<fs::path> missing;
  for (; at.has_relative_path() && fs::symlink_status(at, code).type() == fs::file_type::not_found;
       at = at.parent_path()) {
    missing.push_back(at);
  }
  return missing;
}

/// Removes what a rejected command created: the directories `made`, and the lock file in the first of them.
/// Files of other origin stay.
void remove_made(const store::DataDirectory& directory, std::span<const fs::path> made) {
  if (directory.has_store() || store::swap_is_begun(directory.path()) || !store::tidy_up(directory.path()))
    return;
  std::error_code code;
  fs::remove(directory.path() / "lock", code);
  for (const fs::path& each : made) {
    if (code || !fs::remove(each, code)) return;
  }
}

/// The world that talusd needs, after a save into a directory without a store.
std::string world_of_save(const Flags& flags, bool is_other) {
  if (is_other) {
    return fmt::format(
        "talusd needs the save's world: sqlite3 {} 'select spec from world' > world.toml, --world "
        "world.toml\n",
        flags.path);
  }
  if (flags.world.empty()) return "talusd needs no --world: the save is of the built-in world\n";
  return fmt::format("talusd needs --world {}\n", flags.world);
}

}  // namespace

Answer export_file(const Flags& flags, const Outside&) {
  const auto opened = OpenedStore::open(flags.data);
  if (!opened) return tl::unexpected{opened.error()};
  const auto exported = flags.save ? export_save(opened->store(), flags.world, flags.settles, flags.path)
                                   : export_edits(opened->store(), flags.path);
  if (!exported) return tl::unexpected{exported.error()};
  return fmt::format("{}: {} in {}\n", flags.path, counted(exported->voxels, "voxel"),
                     counted(exported->chunks, "chunk"));
}

Answer import_file(const Flags& flags, const Outside& outside) {
  if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
  const auto world = outside.load_world(flags.world, flags.secret);
  if (!world) return tl::unexpected{world.error()};
  const std::vector<fs::path> missing = missing_directories(flags.data);
  const auto directory = store::DataDirectory::open_any(flags.data);
  if (!directory) return tl::unexpected{directory.error()};
  if (const auto alone = check_is_alone(flags.data, "import into"); !alone) {
    return tl::unexpected{alone.error()};
  }
  const auto imported =
      import_edits(flags.path, *directory, flags.keep ? Winner::store : Winner::file, now_ms(), world->get());
  if (!imported) {
    if (!missing.empty()) remove_made(*directory, missing);
    return tl::unexpected{imported.error()};
  }
  std::string text = rebuilt_lines(flags.data, *imported);
  if (imported->both > 0) {
    text += fmt::format("in both: {}, as the {} has {}\n", counted(imported->both, "voxel"),
                        flags.keep ? "store" : "file", imported->both == 1 ? "it" : "them");
  }
  if (!imported->compared) {
    text += fmt::format(
        "the world ({}) differs from the file's; talusd at its start, or a rebase, checks that it generates "
        "the file's materials\n",
        flags.world.empty() ? "default" : flags.world);
  }
  if (imported->replaced.empty() && saves::is_database(flags.path)) {
    text += world_of_save(flags, *world == nullptr || (*world)->fingerprint() != imported->fingerprint);
  }
  return text;
}

Answer rebase(const Flags& flags, const Outside& outside) {
  if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
  const auto world = outside.load_world(flags.world, flags.secret);
  if (!world) return tl::unexpected{world.error()};
  const auto directory = store::DataDirectory::open_store(flags.data);
  if (!directory) return tl::unexpected{directory.error()};
  if (const auto alone = check_is_alone(flags.data, "rebase"); !alone) return tl::unexpected{alone.error()};
  const auto rebased = rebase_edits(*directory, **world, flags.drop_unknown);
  if (!rebased) return tl::unexpected{rebased.error()};
  return rebuilt_lines(flags.data, *rebased) + fmt::format(
                                                   "{} voxels are as the new world generates and no longer "
                                                   "edits; {} were of unknown materials and are dropped\n",
                                                   rebased->as_base, rebased->unknown);
}

Answer rename(const Flags& flags, const Outside&) {
  if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
  const auto directory = store::DataDirectory::open_store(flags.data);
  if (!directory) return tl::unexpected{directory.error()};
  if (const auto alone = check_is_alone(flags.data, "rename a material of"); !alone) {
    return tl::unexpected{alone.error()};
  }
  const auto renamed = rename_material(*directory, flags.from, flags.to);
  if (!renamed) return tl::unexpected{renamed.error()};
  return fmt::format(
      "{} of \"{}\" {} called \"{}\" now; give that [[placeable]] the same name in the world's file\n",
      counted(*renamed, "voxel"), escaped(flags.from), *renamed == 1 ? "is" : "are", escaped(flags.to));
}

namespace {

/// Locks a store that is not in use.
tl::expected<store::DataDirectory, std::string> lock_store(const Flags& flags) {
  if (const auto may = check_may_write(flags.data); !may) return tl::unexpected{may.error()};
  return store::DataDirectory::open_store(flags.data);
}

}  // namespace

Answer join_stopped_store(const Flags& flags, const Outside& outside) {
  const auto directory = lock_store(flags);
  if (!directory) return tl::unexpected{directory.error()};
  const auto world = outside.load_world(flags.world, flags.secret);
  if (!world) return tl::unexpected{world.error()};
  return join_cluster(*directory, flags.cluster, **world, outside.cluster);
}

Answer leave_with_stopped_store(const Flags& flags, const Outside& outside) {
  const auto directory = lock_store(flags);
  if (!directory) return tl::unexpected{directory.error()};
  return leave_cluster(*directory, flags.cluster, outside.cluster, flags.keep_id, flags.yes);
}

Answer fork_stopped_store(const Flags& flags, const Outside& outside) {
  const auto directory = lock_store(flags);
  if (!directory) return tl::unexpected{directory.error()};
  const auto world = outside.load_world(flags.world, flags.secret);
  if (!world) return tl::unexpected{world.error()};
  return fork_cluster(*directory, flags.cluster, **world, outside.cluster, flags.yes);
}

}  // namespace talus::server::store_commands
