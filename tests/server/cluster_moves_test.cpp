// Stores that leave their cluster, or begin another, whatever happens meanwhile.
#include <filesystem>
#include <map>

#include <catch2/catch.hpp>

#include <talus/store/whole_store.h>

#include "../failing_renames.h"
#include "cluster/join/enter_cluster.h"
#include "cluster/message.h"
#include "commands/store/cluster_moves.h"
#include "commands/store/opened_store.h"
#include "commands/store/rename.h"
#include "commands/store/transfer.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"
#include "shared_stream.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

/// A store that has read its cluster's stream up to message 5.
struct Member {
  Member() {
    const std::string_view scheme = "nats";
    settings.nats = ServerUrls::parse("nats://127.0.0.1:4222", {&scheme, 1}).value();
    auto directory = store::DataDirectory::open(path, world.fingerprint());
    REQUIRE(directory.has_value());
    id = directory->store_id();
    EditStore store{path};
    store.database_settings.fingerprint = world.fingerprint();
    REQUIRE(store.open() == "");
    TestEditor editor;
    editor.attach(store);
    std::mt19937_64 random{7};
    for (int i = 0; i < 50; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
    REQUIRE(store.database().bind({{"planks", kPlanks}}).has_value());
    edits::Edit planks;
    planks.writes.push_back({{3'000, 1, 1}, kPlanks});
    REQUIRE(editor.edit(store, planks).has_value());
    head = store.log().status().head;
    store.close();
    REQUIRE(store::enter_stream(path, kPlace).has_value());
    scratch.write("data/rejoin", "the store that was here was found to be wrong");
  }

  /// The error, or nothing.
  std::string leave(const fs::path& data) {
    const auto directory = store::DataDirectory::open_store(data);
    if (!directory) return directory.error();
    const auto left = leave_cluster(*directory, {}, tools, false, true);
    return left ? "" : left.error();
  }
  std::string fork(const fs::path& data) {
    const auto directory = store::DataDirectory::open_store(data);
    if (!directory) return directory.error();
    const auto forked = fork_cluster(*directory, settings, world, tools, true);
    return forked ? "" : forked.error();
  }
  std::string join(const fs::path& data) {
    const auto directory = store::DataDirectory::open_store(data);
    if (!directory) return directory.error();
    const auto joined = join_cluster(*directory, settings, world, tools);
    return joined ? "" : joined.error();
  }

  static constexpr store::StreamPlace kPlace{5, 1};
  static constexpr MaterialId kPlanks{300};
  ScratchDirectory scratch{ScratchDirectory::memory()};
  fs::path path = scratch / "data";
  terrain::World world = terrain::default_world();
  Cluster settings;
  ContentHash id;
  edits::Head head;
  std::map<ContentHash, std::unique_ptr<SharedStream>> streams;
  ClusterTools tools{[this](const Cluster&, ContentHash store,
                            bool make) -> tl::expected<std::unique_ptr<LogStream>, std::string> {
                       auto& stream = streams[store];
                       if (stream == nullptr && !make)
                         return tl::unexpected{std::string{"there is no such stream"}};
                       if (stream == nullptr) stream = std::make_unique<SharedStream>();
                       return std::make_unique<StreamEnd>(*stream, 1);
                     },
                     [](const terrain::World&) { return edits::SettleRules{}; }};
};

}  // namespace

TEST_CASE("a store that leaves its cluster, or is forked, is the old or the new one whatever rename fails") {
  Member member;
  const bool forks = GENERATE(false, true);
  CAPTURE(forks);
  const fs::path data = member.scratch / "copy";
  for (std::size_t renames = 0;; ++renames) {
    REQUIRE(renames < 100);
    CAPTURE(renames);
    fs::remove_all(data);
    fs::copy(member.path, data, fs::copy_options::recursive);
    std::string error;
    bool failed = false;
    {
      const test::FailingRenames failing{renames};
      error = forks ? member.fork(data) : member.leave(data);
      failed = failing.has_failed();
    }
    CAPTURE(error);
    const auto directory = store::DataDirectory::open_store(data);
    REQUIRE(directory.has_value());
    const auto meta = join::read_place(data);
    INFO((meta ? "" : meta.error()));
    REQUIRE(meta.has_value());
    CHECK(meta->head == member.head);
    const bool is_old = meta->store_id == member.id;
    if (is_old) {
      CHECK(meta->stream == Member::kPlace);
    } else {
      CHECK(meta->stream.sequence == (forks ? 1 : 0));
      CHECK(meta->stream.created_ns == (forks ? 1 : 0));
      CHECK((meta->stream.message_hash != 0) == forks);
    }
    CHECK(fs::exists(data / "rejoin") == is_old);
    CHECK_FALSE(fs::exists(data / "replaced-1"));
    if (failed) continue;  // RocksDB does without some
    CHECK(error == "");
    CHECK_FALSE(is_old);
    break;
  }
}

TEST_CASE("a cluster's store gets a material another name by a new stream, and keeps all else") {
  Member member;
  {
    const auto refused = check_is_alone(member.path, "rename a material of");
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::Contains("leave-cluster") && Catch::Contains("join-cluster"));
  }
  REQUIRE(member.leave(member.path) == "");
  {
    const auto directory = store::DataDirectory::open_store(member.path);
    REQUIRE(directory.has_value());
    const auto renamed = rename_material(*directory, "planks", "boards");
    REQUIRE(renamed.has_value());
    CHECK(*renamed == 1);
  }
  REQUIRE(member.join(member.path) == "");
  const auto store = store::ReadOnlyStore::open(member.path);
  REQUIRE(store.has_value());
  const store::StoreMeta& meta = (*store)->meta();
  CHECK(meta.store_id != member.id);
  CHECK(meta.head == member.head);
  CHECK(meta.stream.sequence == 1);
  CHECK_FALSE((*store)->materials().contains("planks"));
  CHECK((*store)->materials().at("boards") == Member::kPlanks);
  std::size_t editors = 0;
  REQUIRE((*store)->reader().for_each_editor([&](auto, auto&&) { ++editors; }).has_value());
  CHECK(editors == 1);
  // What the servers begin with that take a peer's store.
  StreamEnd end{*member.streams.at(meta.store_id), 2};
  const auto first = end.next(0, std::chrono::steady_clock::now() + std::chrono::minutes{1});
  REQUIRE((first && *first));
  const auto genesis = cluster::decode_genesis((*first)->bytes);
  REQUIRE(genesis.has_value());
  CHECK(genesis->head == member.head);
  CHECK(genesis->materials.at("boards") == Member::kPlanks);
  CHECK_FALSE(genesis->materials.contains("planks"));
}

TEST_CASE("a database and a store.toml of different stores are noticed, and no stream is made or named") {
  Member member;
  REQUIRE(store::enter_stream(member.path, {}).has_value());
  member.scratch.write("data/store.toml", store::store_text({{8, 9}, member.world.fingerprint()}));
  const auto check_noticed = [&](const std::string& error) {
    CHECK_THAT(error, Catch::Contains("the edits belong to store " + to_string(member.id)));
    CHECK_THAT(error, Catch::Contains("write store_id = \"" + to_string(member.id) + "\" into store.toml"));
  };
  check_noticed(member.join(member.path));
  check_noticed(member.leave(member.path));
  check_noticed(member.fork(member.path));
  CHECK(member.streams.empty());
  const auto opened = OpenedStore::open(member.path);
  REQUIRE_FALSE(opened.has_value());
  check_noticed(opened.error());
  const auto compacted = store::compact(member.path);
  REQUIRE_FALSE(compacted.has_value());
  check_noticed(compacted.error());
  {
    const auto directory = store::DataDirectory::open_store(member.path);
    REQUIRE(directory.has_value());
    const auto rebased = rebase_edits(*directory, member.world, false);
    REQUIRE_FALSE(rebased.has_value());
    check_noticed(rebased.error());
  }
  // What is said helps.
  member.scratch.write("data/store.toml", store::store_text({member.id, member.world.fingerprint()}));
  CHECK(member.join(member.path) == "");
}

}  // namespace talus::server
