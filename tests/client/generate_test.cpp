#include <algorithm>
#include <set>

#include <asio/strand.hpp>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "published_peer.h"

namespace talus::client {
namespace {

using namespace testing;

Chunk wrong_chunk(const ChunkKey& key) {
  return some_chunk(key_at(key.coord.x + 1, key.coord.y, key.coord.z)).with_overrides({{{5, MaterialId{1}}}});
}

// A client and what it met, after `visit` ended.
struct Scene {
  asio::io_context io;
  PublishedPeer published{io};
  std::shared_ptr<HandMaker> maker = std::make_shared<HandMaker>();
  Told told;
  std::optional<Client> client;

  void play(const std::function<asio::awaitable<void>()>& visit, Generate generate = Generate::automatic,
            const std::function<void(Options&)>& change = {}) {
    Options options = generating(maker, generate);
    if (change) change(options);
    client.emplace(io.get_executor(), options, told.events());
    const auto whole = [&]() -> asio::awaitable<void> {
      co_await join(*client, published.peer);
      co_await visit();
      client->close();
      published.peer.hang_up();
    };
    run(io, {whole, [&] { return published.serve(); }});
  }
  [[nodiscard]] asio::awaitable<void> until_generates() {
    return until(*client, [this] { return client->generates(); });
  }
  [[nodiscard]] asio::awaitable<void> until_complete(int times = 1) {
    return until(*client, [this, times] { return told.completes >= times; });
  }
  [[nodiscard]] bool all_are(const std::function<Chunk(const ChunkKey&)>& truth) const {
    return told.chunks.size() == 27 &&
           std::all_of(told.chunks.begin(), told.chunks.end(), [&](const auto& each) {
             return *each.second.chunk == truth(each.first) &&
                    each.second.hash == content_hash(*each.second.chunk);
           });
  }
};

}  // namespace

TEST_CASE("a View's chunks are made here, and sixteen are compared") {
  Scene scene;
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    co_await until(*scene.client, [&] { return scene.client->stats().proofs >= kFirstProofs; });
  });
  CHECK(scene.all_are(some_chunk));
  REQUIRE(scene.published.views.size() == 1);
  CHECK(scene.published.views[0].has_base);
  CHECK(scene.told.all.size() == 27);
  CHECK(scene.told.completes == 1);
  CHECK(scene.client->stats().made_chunks == 27);
  CHECK(scene.client->stats().proofs == kFirstProofs);
  CHECK(scene.client->stats().failed_proofs == 0);
  CHECK(scene.client->stats().file_bytes == 100);
  CHECK(scene.published.asked_chunks.size() == kFirstProofs);
  CHECK(std::set<ChunkKey>{scene.published.asked_chunks.begin(), scene.published.asked_chunks.end()}.size() ==
        kFirstProofs);
  CHECK(scene.told.errors.empty());
  CHECK(scene.told.files == scene.maker->opened);
}

TEST_CASE("by default nothing is made here, and no file is fetched") {
  Scene scene;
  scene.play(
      [&]() -> asio::awaitable<void> {
        CHECK(scene.client->set_view(small_view()).has_value());
        co_await scene.until_complete();
      },
      Generate::never);
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.published.asked_files.empty());
  CHECK_FALSE(scene.published.views.at(0).has_base);
}

TEST_CASE("where the world is not published, chunks come without a word") {
  Scene scene;
  scene.published.more.view_base = false;
  scene.play([&]() -> asio::awaitable<void> {
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
  });
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.told.errors.empty());
  CHECK(scene.published.asked_files.empty());
}

TEST_CASE("until the world is open the View is streamed, and what came is not made again") {
  Scene scene;
  scene.maker->holds_open = true;
  scene.play([&]() -> asio::awaitable<void> {
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    CHECK(scene.maker->batches.empty());
    scene.maker->release();
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view(kChunkSize)).has_value());
    co_await scene.until_complete(2);
  });
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.client->stats().made_chunks == 9);
  REQUIRE(scene.published.views.size() == 2);
  CHECK_FALSE(scene.published.views[0].has_base);
  CHECK(scene.published.views[1].has_base);
}

TEST_CASE("a View that is being streamed when the world opens is sent again with its base") {
  Scene scene;
  scene.maker->holds_open = true;
  scene.published.answers_views = false;
  scene.play([&]() -> asio::awaitable<void> {
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await until(*scene.client, [&] { return scene.published.views.size() == 1; });
    scene.published.answers_views = true;
    scene.maker->release();
    co_await scene.until_complete();
  });
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.client->stats().made_chunks == 27);
  REQUIRE(scene.published.views.size() == 2);
  CHECK(scene.published.views[1].has_base);
  CHECK(scene.told.completes == 1);
}

TEST_CASE("files that the world names are fetched too, in parts") {
  Scene scene;
  scene.maker->names = {"heights.npy", "tree.vox"};
  scene.published.part_bytes = 1000;
  std::vector<std::byte> file(2500);
  for (std::size_t i = 0; i < file.size(); ++i) file[i] = static_cast<std::byte>(i * 7);
  scene.published.files["heights.npy"] = file;
  scene.published.files["tree.vox"] = {};
  scene.play([&]() -> asio::awaitable<void> { co_await scene.until_generates(); });
  CHECK(scene.published.asked_files ==
        std::vector<std::string>{"", "heights.npy", "heights.npy", "heights.npy", "tree.vox"});
  CHECK(scene.maker->opens == 2);
  CHECK(*scene.maker->opened->at("heights.npy") == file);
  CHECK(scene.client->stats().file_bytes == 2600);
}

TEST_CASE("kept files are not fetched, unless they are another world's, or incomplete") {
  Scene scene;
  std::vector<std::string> fetched;
  SECTION("the same world") {}
  SECTION("another world") {
    scene.maker->empty_is_another = true;
    fetched = {""};
  }
  SECTION("incomplete") {
    scene.maker->names = {"added.vox"};
    fetched = {"added.vox"};
  }
  scene.published.files["added.vox"] = {};
  scene.play([&]() -> asio::awaitable<void> { co_await scene.until_generates(); }, Generate::automatic,
             [&](Options& options) {
               options.kept_files = [&](ContentHash fingerprint) {
                 CHECK(fingerprint == kPublished);
                 return std::make_shared<const WorldFiles>(
                     WorldFiles{{"", std::make_shared<const std::vector<std::byte>>()}});
               };
             });
  CHECK(scene.published.asked_files == fetched);
  CHECK((scene.told.files != nullptr) == !fetched.empty());
  CHECK(scene.told.errors.empty());
}

TEST_CASE("a wrong world is found by the first proofs, and each of its chunks is replaced") {
  Scene scene;
  scene.maker->chunk = wrong_chunk;
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await until(*scene.client, [&] { return scene.all_are(some_chunk); });
    CHECK(scene.client->set_view(small_view(kChunkSize)).has_value());
    co_await until(*scene.client,
                   [&] { return scene.published.views.size() == 3 && scene.all_are(some_chunk); });
  });
  CHECK(scene.client->stats().made_chunks > 0);
  CHECK(scene.client->stats().failed_proofs == 1);
  CHECK(scene.client->stats().proofs <= kFirstProofs);
  REQUIRE(scene.told.errors.size() == 1);
  CHECK(scene.told.errors[0].kind == ErrorKind::cannot_generate);
  CHECK_THAT(scene.told.errors[0].message, Catch::Contains("differs from the server's"));
  CHECK_FALSE(scene.client->generates());
  CHECK_FALSE(scene.published.views.back().has_base);
}

TEST_CASE("a world that cannot be made is streamed, and the reason is told once") {
  Scene scene;
  std::string reason;
  SECTION("another fingerprint") {
    scene.maker->fingerprint = {2, 0};
    reason = "another version of the generator";
  }
  SECTION("a newer world") {
    scene.maker->failure = "world.toml:1: generator: this is version 3";
    reason = "generator: this is version 3";
  }
  SECTION("a file that is not there") {
    scene.maker->names = {"gone.vox"};
    reason = "'gone.vox' did not come: the server says: no such file";
  }
  SECTION("a file too large") {
    scene.published.files[""].resize((1U << 20) + 1);
    reason = "has 1048577 bytes; at most 1048576 are fetched";
  }
  scene.play([&]() -> asio::awaitable<void> {
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    co_await until(*scene.client, [&] { return !scene.told.errors.empty(); });
    CHECK(scene.client->set_view(small_view(kChunkSize)).has_value());
    co_await scene.until_complete(2);
  });
  CHECK(scene.all_are(some_chunk));
  REQUIRE(scene.told.errors.size() == 1);
  CHECK(scene.told.errors[0].kind == ErrorKind::cannot_generate);
  CHECK_THAT(scene.told.errors[0].message, Catch::Contains(reason));
  for (const auto& view : scene.published.views) CHECK_FALSE(view.has_base);
  CHECK(scene.client->stats().made_chunks == 0);
}

TEST_CASE("without a maker chunks are streamed, and the reason is told once") {
  Scene scene;
  scene.published.connections = 2;
  scene.play(
      [&]() -> asio::awaitable<void> {
        CHECK(scene.client->set_view(small_view()).has_value());
        co_await scene.until_complete();
        scene.published.peer.hang_up();
        co_await scene.until_complete(2);
      },
      Generate::automatic, [](Options& options) { options.maker = nullptr; });
  CHECK(scene.all_are(some_chunk));
  REQUIRE(scene.told.errors.size() == 1);
  CHECK(scene.told.errors[0].kind == ErrorKind::cannot_generate);
  CHECK_THAT(scene.told.errors[0].message, Catch::Contains("Options::maker is null"));
}

TEST_CASE("a client that closes cancels the opening of its world") {
  Scene scene;
  scene.maker->holds_open = true;
  scene.play([&]() -> asio::awaitable<void> {
    co_await until(*scene.client, [&] { return scene.maker->opens == 1; });
    CHECK_FALSE(scene.maker->open_cancel->load());
  });
  CHECK(scene.maker->open_cancel->load());
  scene.maker->release();
}

TEST_CASE("always: a world that cannot be made ends the connection") {
  Scene scene;
  scene.maker->failure = "no";
  scene.play(
      [&]() -> asio::awaitable<void> {
        co_await until(*scene.client, [&] { return !scene.told.disconnects.empty(); });
      },
      Generate::always);
  REQUIRE(scene.told.disconnects.size() == 1);
  CHECK(scene.told.disconnects[0].first.kind == ErrorKind::cannot_generate);
  CHECK_FALSE(scene.told.disconnects[0].second);
}

TEST_CASE("always: a server that does not publish its world is not joined") {
  asio::io_context io;
  Peer peer{io};
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), generating(std::make_shared<HandMaker>(), Generate::always)};
    const auto world = co_await client.connect("127.0.0.1", peer.port());
    REQUIRE_FALSE(world.has_value());
    CHECK(world.error().kind == ErrorKind::cannot_generate);
  };
  run(io, {visit, [&]() -> asio::awaitable<void> { co_await peer.welcome(); }});
}

namespace {
const ChunkKey kEdited = key_at(0, 0, 0);
Chunk edited(std::vector<Override> voxels) {
  return some_chunk(kEdited).with_overrides(voxels);
}
}  // namespace

TEST_CASE("edits that come before their chunk is made are in it") {
  Scene scene;
  scene.maker->holds_chunks = true;
  scene.published.edits = [] {
    std::vector<protocol::Frame> frames;
    frames.push_back(edit_frame(kEdited, 0, 5, {{1, MaterialId{1}}, {2, MaterialId{1}}}));
    frames.push_back(edit_frame(kEdited, 5, 6, {{2, MaterialId{3}}}));
    return frames;
  };
  scene.published.on_view = [&] { scene.maker->release(); };
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
  });
  CHECK(scene.told.all.size() == 27);
  CHECK(scene.told.chunks.at(kEdited).revision == 6);
  CHECK(*scene.told.chunks.at(kEdited).chunk == edited({{1, MaterialId{1}}, {2, MaterialId{3}}}));
  CHECK(std::count(scene.published.asked_chunks.begin(), scene.published.asked_chunks.end(), kEdited) == 0);
}

TEST_CASE("edits that come after their chunk was made are applied to it") {
  Scene scene;
  scene.published.edits = [&] {
    std::vector<protocol::Frame> frames;
    frames.push_back(edit_frame(kEdited, 0, 5, {{1, MaterialId{1}}}));
    return frames;
  };
  scene.published.answers_views = false;
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    View view = small_view();
    CHECK(scene.client->set_view(view).has_value());
    co_await until(*scene.client, [&] { return scene.told.chunks.size() == 27; });
    scene.published.answers_views = true;
    view.direction = {1, 0, 0};
    CHECK(scene.client->set_view(view).has_value());
    co_await scene.until_complete();
  });
  CHECK(scene.told.all.size() == 28);
  CHECK(scene.told.chunks.at(kEdited).revision == 5);
  CHECK(*scene.told.chunks.at(kEdited).chunk == edited({{1, MaterialId{1}}}));
}

TEST_CASE("an edit that does not follow what is here is fetched") {
  Scene scene;
  scene.maker->holds_chunks = true;
  scene.published.edits = [] {
    std::vector<protocol::Frame> frames;
    frames.push_back(edit_frame(kEdited, 4, 5, {{1, MaterialId{1}}}));
    return frames;
  };
  scene.published.on_view = [&] { scene.maker->release(); };
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
  });
  CHECK(std::count(scene.published.asked_chunks.begin(), scene.published.asked_chunks.end(), kEdited) >= 1);
  CHECK(scene.told.chunks.size() == 27);
}

TEST_CASE("what leaves the View before it is made is cancelled") {
  Scene scene;
  scene.maker->holds_chunks = true;
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await until(*scene.client, [&] { return scene.maker->asked() == 27; });
    CHECK_FALSE(scene.maker->cancels.at(0)->load());
    const std::size_t before = scene.maker->cancels.size();
    CHECK(scene.client->set_view(small_view(100 * kChunkSize)).has_value());
    for (std::size_t i = 0; i < before; ++i) CHECK(scene.maker->cancels[i]->load());
    scene.maker->release();
    co_await scene.until_complete();
  });
  CHECK(scene.told.all.size() == 27);
  CHECK(scene.told.chunks.begin()->first.coord.x == 99);
}

TEST_CASE("after a reconnect the world is kept, and proved again") {
  Scene scene;
  scene.published.connections = 2;
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    scene.published.peer.hang_up();
    co_await until(*scene.client, [&] { return scene.told.reconnects == 1; });
    co_await scene.until_complete(2);
    CHECK(scene.client->set_view(small_view(10 * kChunkSize)).has_value());
    co_await scene.until_complete(3);
    co_await until(*scene.client, [&] { return scene.client->stats().proofs >= 2 * kFirstProofs; });
  });
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.published.asked_files.size() == 1);
  CHECK(scene.client->stats().made_chunks == 2 * 27);
  CHECK(scene.told.all.size() == 2 * 27);
  for (const auto& view : scene.published.views) CHECK(view.has_base);
}

TEST_CASE("after a reconnect edits of a chunk apply to it as generated") {
  Scene scene;
  scene.published.connections = 2;
  int views = 0;
  scene.published.edits = [&] {
    std::vector<protocol::Frame> frames;
    // Meanwhile voxel 1 was restored.
    frames.push_back(++views == 1 ? edit_frame(kEdited, 0, 5, {{1, MaterialId{1}}})
                                  : edit_frame(kEdited, 0, 8, {{2, MaterialId{1}}}));
    return frames;
  };
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    scene.published.peer.hang_up();
    co_await scene.until_complete(2);
  });
  REQUIRE(scene.published.views.size() == 2);
  CHECK(scene.published.views[1].known.size() == 1);  // the edited chunk
  CHECK(scene.told.chunks.at(kEdited).revision == 8);
  CHECK(*scene.told.chunks.at(kEdited).chunk == edited({{2, MaterialId{1}}}));
}

TEST_CASE("after a reconnect to another store edited chunks are made again") {
  Scene scene;
  scene.published.connections = 2;
  scene.published.edits = [&] {
    std::vector<protocol::Frame> frames;
    if (scene.told.reconnects == 0) frames.push_back(edit_frame(kEdited, 0, 5, {{1, MaterialId{1}}}));
    return frames;
  };
  scene.play([&]() -> asio::awaitable<void> {
    co_await scene.until_generates();
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    CHECK(scene.told.chunks.at(kEdited).revision == 5);
    scene.published.more.store_id = 8;
    scene.published.peer.hang_up();
    co_await scene.until_complete(2);
  });
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.told.chunks.at(kEdited).revision == 0);
}

TEST_CASE("a server with another store that publishes the world, after one that did not, is met as well") {
  Scene scene;
  scene.published.connections = 2;
  scene.published.more.view_base = false;
  scene.published.revision = 5;
  scene.published.chunk = [](const ChunkKey& key) {
    return key == kEdited ? edited({{1, MaterialId{1}}}) : some_chunk(key);
  };
  scene.play([&]() -> asio::awaitable<void> {
    CHECK(scene.client->set_view(small_view()).has_value());
    co_await scene.until_complete();
    CHECK(*scene.told.chunks.at(kEdited).chunk != some_chunk(kEdited));
    scene.published.chunk = some_chunk;
    scene.published.answers_views = false;
    scene.published.more.view_base = true;
    scene.published.more.store_id = 8;
    scene.published.peer.hang_up();
    co_await scene.until_generates();
    scene.published.answers_views = true;
    View view = small_view();
    view.direction = {1, 0, 0};
    CHECK(scene.client->set_view(view).has_value());
    co_await scene.until_complete(2);
  });
  CHECK(scene.all_are(some_chunk));
  CHECK(scene.told.errors.empty());
}

TEST_CASE("a client may be closed or destroyed while chunks are made and when they come") {
  asio::io_context io;
  PublishedPeer published{io};
  const auto maker = std::make_shared<HandMaker>();
  maker->holds_chunks = true;
  std::optional<Client> client;
  int came = 0;
  Events events;
  events.on_chunk = [&](const ReceivedChunk&) {
    ++came;
    client.reset();
  };
  const bool before = GENERATE(true, false);
  client.emplace(io.get_executor(), generating(maker), events);
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(*client, published.peer);
    co_await until(*client, [&] { return client->generates(); });
    CHECK(client->set_view(small_view()).has_value());
    co_await until(*client, [&] { return maker->asked() == 27; });
    if (before) client.reset();
    maker->release();
  };
  run(io, {visit, [&] { return published.serve(); }});
  CHECK(came == (before ? 0 : 1));
}

TEST_CASE("chunks may be made after the client and its io_context are gone") {
  std::optional<asio::io_context> io{std::in_place};
  const auto maker = std::make_shared<HandMaker>();
  maker->holds_chunks = true;
  const bool strand = GENERATE(false, true);
  {
    PublishedPeer published{*io};
    asio::any_io_executor executor = io->get_executor();
    if (strand) executor = asio::make_strand(*io);
    Client client{executor, generating(maker)};
    const auto visit = [&]() -> asio::awaitable<void> {
      co_await join(client, published.peer);
      co_await until(client, [&] { return client.generates(); });
      CHECK(client.set_view(small_view()).has_value());
      co_await until(client, [&] { return maker->asked() == 27; });
      client.close();
    };
    run(*io, {visit, [&] { return published.serve(); }});
  }
  io.reset();
  maker->release();
  CHECK(maker->held.empty());
}

}  // namespace talus::client
