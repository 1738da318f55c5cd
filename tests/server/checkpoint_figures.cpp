// What a checkpoint costs: run by hand, each case by its name, with TALUS_STORE set to a directory on the
// disk that is to be measured. docs/SPEED.md has what they said.
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <mutex>

#include <catch2/catch.hpp>

#include <talus/store/data_directory.h>
#include <talus/store/store_builder.h>

#include "cluster/checkpoint/checkpoint_download.h"
#include "cluster/checkpoint/take_checkpoint.h"
#include "edits_of_tests.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

std::string setting(const char* name, const std::string& otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

fs::path wanted_directory() {
  const std::string path = setting("TALUS_STORE", "");
  REQUIRE(path != "");
  fs::create_directories(path);
  return path;
}

std::uint64_t wanted_number(const char* name, std::uint64_t otherwise) {
  return std::stoull(setting(name, std::to_string(otherwise)));
}

/// Of the world with which talusd is to use it.
ContentHash wanted_fingerprint() {
  return *store::parse_hash(setting("TALUS_FINGERPRINT", "dd1b53cc3a1f39800d4ccfab0c61c065"));
}

}  // namespace

TEST_CASE("make a store of edits of one voxel", "[.figures]") {
  const fs::path path = wanted_directory();
  const std::uint64_t edits = wanted_number("TALUS_EDITS", 1'000'000);
  const auto directory = store::DataDirectory::open(path, wanted_fingerprint());
  REQUIRE(directory.has_value());
  EditStore store{path};
  store.database_settings.fingerprint = wanted_fingerprint();
  store.database_settings.store_id = directory->store_id();
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  std::mutex mutex;
  std::condition_variable answered;
  std::uint64_t waiting = 0;
  // Places of a square of chunks, each once.
  for (std::uint64_t i = 0; i < edits; ++i) {
    edits::Edit edit;
    const auto at = static_cast<std::int64_t>(i);
    edit.writes.push_back({{at % 1'000 * 3, 200 + at % 7, at / 1'000 * 3}, MaterialId{300}});
    ++editor.sequence;
    std::unique_lock lock{mutex};
    answered.wait(lock, [&] { return waiting < 64; });
    ++waiting;
    lock.unlock();
    REQUIRE(store.log()
                .append(editor.entry(edit),
                        [&](const auto&) {
                          const std::lock_guard held{mutex};
                          --waiting;
                          answered.notify_one();
                        })
                .has_value());
  }
  std::unique_lock lock{mutex};
  answered.wait(lock, [&] { return waiting == 0; });
  lock.unlock();
  std::cout << "revision " << store.log().status().head.revision << '\n';
}

TEST_CASE("make a store of chunks full of noise", "[.figures]") {
  const fs::path path = wanted_directory();
  const std::uint64_t mebibytes = wanted_number("TALUS_MEBIBYTES", 10'240);
  const store::StoreIdentity identity{store::random_store_id(), wanted_fingerprint()};
  auto builder = store::StoreBuilder::create(path, identity, 1, 1);
  REQUIRE(builder.has_value());
  std::mt19937_64 random{1};
  std::vector<Override> voxels(kChunkVolume);
  for (std::uint32_t index = 0; index < voxels.size(); ++index)
    voxels[index].index = static_cast<std::uint16_t>(index);
  constexpr std::uint64_t kBytes = 80'000;  // a chunk of it, roughly
  for (std::uint64_t i = 0; i < (mebibytes << 20U) / kBytes; ++i) {
    for (Override& voxel : voxels) voxel.material = MaterialId{static_cast<std::uint16_t>(random() % 4'096)};
    const auto at = static_cast<std::int32_t>(i);
    REQUIRE((*builder)->add({at % 300, 6, at / 300}, 1, voxels).has_value());
  }
  REQUIRE((*builder)->finish(1, 1'000).has_value());
}

TEST_CASE("take a store from TALUS_PEER with TALUS_TOKEN", "[.figures]") {
  const fs::path path = wanted_directory();
  const auto begun = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  auto download =
      CheckpointDownload::open(setting("TALUS_PEER", ""), {setting("TALUS_TOKEN", ""), {}, {}, {}});
  INFO((download ? "" : download.error().reason));
  REQUIRE(download.has_value());
  std::cout << "first byte after " << seconds() << " s\n";
  double last = 0;
  const auto meta = take_checkpoint(**download, path, {wanted_fingerprint(), std::nullopt},
                                    [&](std::uint64_t) { last = seconds(); });
  INFO((meta ? "" : meta.error()));
  REQUIRE(meta.has_value());
  const double mebibytes = static_cast<double>((*download)->size()) / (1 << 20);
  std::cout << mebibytes << " MiB, the last after " << last << " s (" << mebibytes / last
            << " MiB/s), verified after " << seconds() << " s, revision " << meta->head.revision << '\n';
}

}  // namespace talus::server
