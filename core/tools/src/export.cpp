#include "export.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <talus/files/atomic_file.h>
#include <talus/files/npy_file.h>
#include <talus/files/path_text.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>

#include "export_json.h"
#include "export_patch.h"
#include "export_plan.h"

namespace talus::tools {
namespace {

Expected<std::vector<files::NpyFile>> create_files(const ExportPlan& plan,
                                                   const std::filesystem::path& directory) {
  std::vector<files::NpyFile> created;
  for (const PlannedArray& array : plan.arrays) {
    auto file = files::NpyFile::create(directory / array.file, array.type);
    if (!file) return tl::make_unexpected(file.error());
    created.push_back(std::move(*file));
  }
  return created;
}

Expected<void> check_bytes(const ExportPlan& plan, std::uint64_t max_bytes) {
  const terrain::Region& region = plan.region;
  const std::size_t column_bytes = plan.column_bytes();
  if (region.columns() <= max_bytes / column_bytes) return {};
  std::array<char, 160> text{};
  std::snprintf(
      text.data(), text.size(),
      "--size: %d x %d columns could take %.1f GiB, the limit is %.1f GiB; at most %llu columns fit",
      region.width, region.depth,
      static_cast<double>(column_bytes) * static_cast<double>(region.columns()) / (1 << 30),
      static_cast<double>(max_bytes) / (1 << 30), static_cast<unsigned long long>(max_bytes / column_bytes));
  return wrong_use(text.data());
}

// Removes arrays of an earlier export, which would seem to belong to this one.
Expected<void> remove_left_out(const ExportPlan& plan, const std::filesystem::path& directory) {
  for (const std::string& file : plan.left_out) {
    std::error_code failure;
    std::filesystem::remove(directory / file, failure);
    if (failure)
      return failed(files::to_text(directory / file) +
                    ": cannot remove an earlier export's array: " + failure.message());
  }
  return {};
}

tl::expected<void, files::FileError> finish(const ExportPlan& plan, std::span<files::NpyFile> arrays,
                                            std::size_t rows) {
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    if (auto done = arrays[i].finish(shape_of(plan, plan.arrays[i], rows)); !done) return done;
  }
  for (files::NpyFile& array : arrays) {
    if (auto done = array.commit(); !done) return done;
  }
  return {};
}

}  // namespace

Expected<void> export_region(const terrain::World& world, const terrain::Region& region,
                             const std::filesystem::path& directory, const ExportOptions& options,
                             ProgressBar& progress) {
  const ExportPlan plan = plan_export(world, region, options.edits);
  if (auto fits = check_bytes(plan, options.max_bytes); !fits) return fits;
  std::error_code made;
  std::filesystem::create_directories(directory, made);
  if (made) return failed(files::to_text(directory) + ": cannot make the directory: " + made.message());
  auto arrays = create_files(plan, directory);
  if (!arrays) return tl::make_unexpected(arrays.error());
  auto json = files::AtomicFile::create(directory / "export.json");
  if (!json) return tl::make_unexpected(json.error());

  const PatchGrid grid{region, options.patch_edge};
  const PatchWriter writer{plan, *arrays};
  progress.expect(region.columns());
  std::int32_t rows = 0;
  std::vector<terrain::PlacedObject> objects;
  Expected<void> outcome;
  const auto produce = [&](std::size_t index) { return writer.write(grid.patch(index)); };
  work_in_order(grid.count(), thread_count(options.threads), produce,
                [&](std::size_t index, const Expected<PatchSummary>& patch) {
                  if (!patch) {
                    outcome = tl::make_unexpected(patch.error());
                    return false;
                  }
                  rows = std::max(rows, patch->rows);
                  objects.insert(objects.end(), patch->objects.begin(), patch->objects.end());
                  progress.advance(grid.patch(index).columns());
                  return true;
                });
  if (!outcome) return outcome;
  const auto all_rows = static_cast<std::size_t>(rows);
  if (auto done = finish(plan, *arrays, all_rows); !done) return outcome_of(done);
  if (auto done = remove_left_out(plan, directory); !done) return done;
  std::filesystem::remove(directory / "objects.json", made);  // from an earlier export
  if (world.has_objects()) {
    auto list = files::AtomicFile::create(directory / "objects.json");
    if (!list) return tl::make_unexpected(list.error());
    const std::string told = objects_json(plan, std::move(objects));
    if (auto done = list->write_at(0, std::as_bytes(std::span{told})); !done) return outcome_of(done);
    if (auto done = list->commit(); !done) return outcome_of(done);
  }
  const std::string text = export_json(plan, all_rows);
  if (auto done = json->write_at(0, std::as_bytes(std::span{text})); !done) return outcome_of(done);
  return outcome_of(json->commit());
}

}  // namespace talus::tools
