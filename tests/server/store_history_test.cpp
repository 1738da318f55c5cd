// What `talusd store history` says where there is little to say, and where there is much; and what stat
// counts of the log's records.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <talus/store/data_directory.h>

#include "commands/store/history_report.h"
#include "commands/store/store_figures.h"
#include "commands/store/transfer.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;
using HistoryJson = nlohmann::json;

/// A store in which somebody changed the voxels 0,0,0 to `edits` - 1,0,0, each by an edit of its own.
void build_row(EditStore& store, std::int64_t edits) {
  TestEditor editor;
  editor.attach(store);
  for (std::int64_t x = 0; x < edits; ++x) {
    edits::Edit edit;
    edit.writes.push_back({{x, 0, 0}, MaterialId{9}});
    REQUIRE(editor.edit(store, edit)->result.changed == 1);
  }
}

std::string printed(const fs::path& path, const SubjectQuery& query, bool json) {
  const auto store = store::ReadOnlyStore::open(path);
  REQUIRE(store.has_value());
  std::string text;
  REQUIRE(print_history(**store, query, json, [&](std::string_view page) { text += page; }));
  return text;
}

std::string printed(const fs::path& path, VoxelPos voxel, bool json) {
  const auto store = store::ReadOnlyStore::open(path);
  REQUIRE(store.has_value());
  std::string text;
  REQUIRE(print_history(**store, voxel, json, [&](std::string_view page) { text += page; }));
  return text;
}

}  // namespace

TEST_CASE("a store that was just imported has no records, and history says so") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const fs::path from = scratch / "from";
  {
    EditStore store{from};
    REQUIRE(store.open_without_log() == "");
    REQUIRE(store.database().bind({{"brick", MaterialId{9}}}));
    store.open_log();
    build_row(store, 3);
  }
  const auto exported = export_edits(**store::ReadOnlyStore::open(from), scratch / "file");
  INFO((exported ? "" : exported.error()));
  REQUIRE(exported.has_value());
  const fs::path to = scratch / "to";
  {
    const auto directory = store::DataDirectory::open_any(to);
    REQUIRE(directory.has_value());
    REQUIRE(import_edits(scratch / "file", *directory, Winner::file, 1'800'000'000'000).has_value());
  }
  for (const std::string& text :
       {printed(to, VoxelPos{0, 0, 0}, false), printed(to, SubjectQuery{"somebody"}, false)}) {
    CHECK_THAT(text, Catch::StartsWith("no records "));
    CHECK_THAT(text, !Catch::Contains("go back to"));
  }
  const auto voxel = HistoryJson::parse(printed(to, VoxelPos{0, 0, 0}, true));
  CHECK(voxel.at("first_position").is_null());
  CHECK(voxel.at("first_time").is_null());
  CHECK(voxel.at("changes") == HistoryJson::array());
}

TEST_CASE("if a subject has no entries, history says so and names subjects that have") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const fs::path path = scratch / "data";
  {
    EditStore store{path};
    REQUIRE(store.open() == "");
    build_row(store, 3);
    constexpr std::uint64_t kMany = 30;  // more than are named
    for (std::uint64_t i = 1; i <= kMany; ++i) {
      const edits::EditorId id{i, 5};
      REQUIRE(store.apply(edits::AttachEntry{id, 1, "player " + std::to_string(i)})->kind ==
              edits::EntryResult::Kind::attached);
      edits::Edit edit;
      edit.writes.push_back({{0, static_cast<std::int64_t>(i), 0}, MaterialId{9}});
      REQUIRE(store.apply(edits::EditEntry{id, 1, 1, edit, edits::testing::base_of(edit)})->result.changed ==
              1);
    }
  }
  const std::string text = printed(path, SubjectQuery{"smebody"}, false);
  CHECK_THAT(text,
             Catch::Contains("no entries of subject smebody; subjects with entries: somebody (3 edits), "));
  CHECK_THAT(text, Catch::EndsWith(", and 11 more\n"));
  const auto json = HistoryJson::parse(printed(path, SubjectQuery{"smebody"}, true));
  CHECK(json.at("edits") == HistoryJson::array());
  CHECK(json.at("subjects").size() == 20);
  CHECK(json.at("subjects").at(0) == HistoryJson({{"subject", "somebody"}, {"edits", 3}}));
  // Who has some, but not in what was asked for.
  const std::string later = printed(path, SubjectQuery{"somebody", 0, 1'000}, false);
  CHECK_THAT(later, Catch::Contains("somebody has changed no voxel since "));
  CHECK_THAT(later, !Catch::Contains("no entries"));
  CHECK_FALSE(HistoryJson::parse(printed(path, SubjectQuery{"somebody"}, true)).contains("subjects"));
}

TEST_CASE("a long history is printed in pages, and as JSON it is one document") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const fs::path path = scratch / "data";
  constexpr std::int64_t kEdits = 2'000;
  {
    EditStore store{path};
    REQUIRE(store.open() == "");
    build_row(store, kEdits);
  }
  const auto store = store::ReadOnlyStore::open(path);
  REQUIRE(store.has_value());
  const bool json = GENERATE(false, true);
  std::vector<std::string> pages;
  REQUIRE(print_history(**store, SubjectQuery{"somebody", 0, 0, 100'000}, json,
                        [&](std::string_view page) { pages.emplace_back(page); }));
  CHECK(pages.size() > 2);
  std::string all;
  for (const std::string& page : pages) {
    CHECK(page.size() < kPageBytes + 1'000);
    all += page;
  }
  if (json) {
    const auto document = HistoryJson::parse(all);
    REQUIRE(document.at("edits").size() == kEdits);
    CHECK(document.at("edits").at(kEdits - 1).at("first") == HistoryJson::array({kEdits - 1, 0, 0}));
    CHECK(document.at("more") == false);
  } else {
    CHECK(std::ranges::count(all, '\n') == kEdits + 1);
  }
}

TEST_CASE("unflushed entries count among a store's editors and history") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  EditStore store{scratch / "data"};
  store.log_settings.flush_interval = std::chrono::hours{1};
  REQUIRE(store.open() == "");
  const fs::path copy = scratch / "copy";
  build_row(store, 10);
  fs::create_directory(copy);
  REQUIRE(store.database().checkpoint(copy / "db").has_value());
  const auto read = store::ReadOnlyStore::open(copy);
  REQUIRE(read.has_value());
  REQUIRE((*read)->meta().flushed == 0);
  ProgressBar progress{"", ""};
  const auto figures = read_figures(**read, progress);
  REQUIRE(figures.has_value());
  CHECK(figures->editors == 1);
  CHECK((*read)->record_bytes() > 10 * 50);
}

}  // namespace talus::server
