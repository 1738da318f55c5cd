// A peer that publishes a world, and a maker of its chunks by hand: both have some_chunk() everywhere.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <asio/awaitable.hpp>

#include <talus/client/chunk_maker.h>
#include <talus/client/client.h>

#include "peer.h"

namespace talus::client::testing {

inline constexpr ContentHash kPublished{1, 0};  // fingerprint

class HandMaker final : public ChunkMaker, public std::enable_shared_from_this<HandMaker> {
 public:
  ContentHash fingerprint = kPublished;
  std::vector<std::string> names;  // of files that the world names
  std::string failure;             // of every open(); empty: none
  bool empty_is_another = false;   // a world's file without bytes is another world
  std::function<Chunk(const ChunkKey&)> chunk = some_chunk;
  bool holds_open = false, holds_chunks = false;  // until release()

  std::deque<std::function<void()>> held;
  std::vector<std::vector<ChunkKey>> batches;
  std::vector<std::shared_ptr<const std::atomic<bool>>> cancels;
  std::shared_ptr<const WorldFiles> opened;
  int opens = 0;
  std::shared_ptr<const std::atomic<bool>> open_cancel;

  void open(std::shared_ptr<const WorldFiles> files, std::shared_ptr<const std::atomic<bool>> cancel,
            Opened done) override;
  /// What was held is done.
  void release();
  [[nodiscard]] std::size_t asked() const;

 private:
  class World;
  void run(bool hold, std::function<void()> job);
};

/// What the client told, and the last of each chunk.
struct Told {
  std::map<ChunkKey, ReceivedChunk> chunks;
  std::vector<ReceivedChunk> all;
  int completes = 0;
  std::vector<ClientError> errors;
  std::vector<std::pair<ClientError, bool>> disconnects;
  int reconnects = 0;
  std::shared_ptr<const WorldFiles> files;
  [[nodiscard]] Events events();
};

/// Serves connections until the client closes the last.
class PublishedPeer {
 public:
  explicit PublishedPeer(asio::io_context& io) : peer{io} {}

  Peer peer;
  WelcomeMore more{.view_base = true};
  std::map<std::string, std::vector<std::byte>> files{{"", std::vector<std::byte>(100)}};
  std::uint32_t part_bytes = 65'536;
  std::function<Chunk(const ChunkKey&)> chunk = some_chunk;
  std::function<std::vector<protocol::Frame>()> edits;  // of a View with has_base; null: none
  bool answers_views = true;
  std::uint64_t revision = 0;  // of what is streamed
  int connections = 1;

  struct SeenView {
    bool has_base = false;
    std::int64_t x = 0;
    std::vector<wire::KnownChunk> known;
  };
  std::vector<SeenView> views;
  std::vector<std::string> asked_files;
  std::vector<ChunkKey> asked_chunks;
  std::function<void()> on_view;  // a View was answered

  [[nodiscard]] asio::awaitable<void> serve();

 private:
  [[nodiscard]] asio::awaitable<void> serve_one();
};

[[nodiscard]] Options generating(const std::shared_ptr<HandMaker>& maker,
                                 Generate generate = Generate::automatic);
/// A View of 27 chunks.
[[nodiscard]] View small_view(std::int64_t x = 0);
[[nodiscard]] protocol::Frame edit_frame(const ChunkKey& key, std::uint64_t previous, std::uint64_t revision,
                                         const std::vector<Override>& voxels);

/// Lets the peer and the client go on until `held` is true.
[[nodiscard]] asio::awaitable<void> until(Client& client, std::function<bool()> held);

}  // namespace talus::client::testing
