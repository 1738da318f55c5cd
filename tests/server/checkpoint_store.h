// A store with edits, and its checkpoint as a tar in memory.
#pragma once

#include <filesystem>
#include <string>

#include <talus/store/data_directory.h>

#include "cluster/checkpoint/checkpoint_tar.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server::testing {

/// A data directory whose store is open.
struct CheckpointStore {
  explicit CheckpointStore(std::uint64_t seed = 7, int edits = 200) {
    store.database_settings.store_id = directory->store_id();
    store.database_settings.memory.write_buffer_bytes = 64 << 10;
    store.log_settings.flush_interval = std::chrono::milliseconds{1};
    REQUIRE(store.open() == "");
    editor.attach(store);
    std::mt19937_64 random{seed};
    for (int i = 0; i < edits; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
  }

  /// The store is one of a cluster, and stands there.
  void enter(const store::StreamPlace& place) {
    store.close();
    REQUIRE(store.open_without_log() == "");
    REQUIRE(store.database().enter(place).has_value());
    store.open_log();
  }

  /// To over a megabyte.
  void grow() {
    for (std::int64_t i = 0; i < 400; ++i) {
      edits::Edit edit;
      for (std::int64_t j = 0; j < 500; ++j)
        edit.writes.push_back({{j, 1'000 + i, j * j % 64}, MaterialId{300}});
      REQUIRE(editor.edit(store, edit).has_value());
    }
  }

  [[nodiscard]] edits::Head head() { return store.log().status().head; }
  [[nodiscard]] ContentHash id() const { return directory->store_id(); }

  [[nodiscard]] std::unique_ptr<CheckpointTar> checkpoint() {
    const std::filesystem::path at = path / "talus-checkpoint-test";
    std::filesystem::create_directory(at);
    REQUIRE(store.database().checkpoint(at / "db").has_value());
    auto tar = CheckpointTar::open(at);
    INFO((tar ? "" : tar.error()));
    REQUIRE(tar.has_value());
    return *std::move(tar);
  }
  [[nodiscard]] std::string tar() {
    const auto made = checkpoint();
    std::string all;
    for (;;) {
      const auto piece = made->next();
      REQUIRE(piece.has_value());
      if (piece->empty()) break;
      all += *piece;
    }
    REQUIRE(all.size() == made->size());
    return all;
  }

  ScratchDirectory scratch{ScratchDirectory::memory()};
  std::filesystem::path path = scratch / "data";
  tl::expected<store::DataDirectory, std::string> directory = store::DataDirectory::open(path, {1, 2});
  EditStore store{path};
  TestEditor editor;
};

}  // namespace talus::server::testing
