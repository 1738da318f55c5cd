#include <talus/local_source/local_source.h>

#include <fstream>
#include <future>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>

namespace talus {
namespace {

using client::ChunkMaker;
using client::LocalWorld;
using client::MadeChunk;
using client::WorldFiles;
using Opened = tl::expected<std::shared_ptr<LocalWorld>, ChunkMaker::OpenFailure>;
using Made = tl::expected<std::vector<MadeChunk>, std::string>;

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span{text});
  return {bytes.begin(), bytes.end()};
}

Opened open(LocalSource& source, const std::map<std::string, std::vector<std::byte>>& given,
            bool cancelled = false) {
  WorldFiles files;
  for (const auto& [name, bytes] : given) files[name] = std::make_shared<const std::vector<std::byte>>(bytes);
  const auto opened = std::make_shared<std::promise<Opened>>();  // the thread may still use it
  source.open(std::make_shared<const WorldFiles>(std::move(files)),
              std::make_shared<const std::atomic<bool>>(cancelled),
              [opened](Opened world) { opened->set_value(std::move(world)); });
  return opened->get_future().get();
}

Made make(LocalWorld& world, std::vector<ChunkKey> keys, bool cancelled = false) {
  const auto made = std::make_shared<std::promise<Made>>();
  world.make(std::move(keys), std::make_shared<const std::atomic<bool>>(cancelled),
             [made](Made chunks) { made->set_value(std::move(chunks)); });
  return made->get_future().get();
}

const std::vector<ChunkKey> kKeys{{{3, 2, 0}, {}}, {{3, 3, 1}, {}}, {{3, 4000, 0}, {}}, {{3, 4001, 0}, {}}};

}  // namespace

TEST_CASE("a LocalSource makes the generator's chunks with their hashes, of several worlds") {
  LocalSource source{{2}};
  for (const std::string_view toml : {terrain::classic_world_toml(), terrain::default_world_toml()}) {
    const auto right = terrain::World::parse(toml, "world.toml");
    const auto world = open(source, {{"", bytes_of(toml)}});
    REQUIRE(world.has_value());
    CHECK((*world)->fingerprint() == right->fingerprint());
    const auto made = make(**world, kKeys);
    REQUIRE(made.has_value());
    REQUIRE(made->size() == kKeys.size());
    for (const MadeChunk& chunk : *made) {
      CHECK(*chunk.chunk == terrain::generate_chunk(*right, chunk.key));
      CHECK(chunk.hash == content_hash(*chunk.chunk));
    }
  }
}

TEST_CASE("a LocalSource says which file it lacks, or what is wrong with a world") {
  LocalSource source{{1}};
  std::ifstream file{TALUS_SOURCE_DIR "/tests/golden/worlds/height_map.toml"};
  const std::string toml{std::istreambuf_iterator<char>{file}, {}};
  const auto lacking = open(source, {{"", bytes_of(toml)}});
  REQUIRE_FALSE(lacking.has_value());
  INFO(lacking.error().message);
  CHECK(lacking.error().missing_files == std::set<std::string>{"made by the test"});
  const auto wrong = open(source, {{"", bytes_of("colour_of_the_sky = 7\n")}});
  REQUIRE_FALSE(wrong.has_value());
  CHECK(wrong.error().missing_files.empty());
  CHECK_THAT(wrong.error().message, Catch::Contains("colour_of_the_sky"));
  CHECK_FALSE(open(source, {}).has_value());
}

TEST_CASE("a LocalSource names all files that it lacks at once") {
  LocalSource source{{1}};
  std::string toml{terrain::classic_world_toml()};
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    toml += "\n[[object]]\nname = \"object " + number + "\"\nmodel = \"" + number +
            ".vox\"\nspacing = 40\nchance = 0.5\nlooks = [\"grass\"]\n[object.palette]\n1 = { name = "
            "\"stone\" }\n";
  }
  const auto lacking = open(source, {{"", bytes_of(toml)}});
  REQUIRE_FALSE(lacking.has_value());
  INFO(lacking.error().message);
  CHECK(lacking.error().missing_files == std::set<std::string>{"0.vox", "1.vox", "2.vox"});
}

TEST_CASE("what is cancelled is not made, and a source may end with work waiting") {
  auto source = std::make_unique<LocalSource>(LocalSourceOptions{1});
  const auto world = open(*source, {{"", bytes_of(terrain::classic_world_toml())}});
  REQUIRE(world.has_value());
  CHECK(make(**world, kKeys, true)->empty());
  CHECK(open(*source, {}, true).error().message == "cancelled");
  std::atomic<int> done = 0;
  const auto keep = std::make_shared<const std::atomic<bool>>(false);
  for (int i = 0; i < 100; ++i) {
    (*world)->make({{{4 * i, 2, 0}, {}}}, keep, [&](Made) { ++done; });
  }
  source.reset();
  const int at_end = done;
  (*world)->make(kKeys, keep, [&](Made) { ++done; });
  CHECK(done == at_end);
}

}  // namespace talus
