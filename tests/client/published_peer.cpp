#include "published_peer.h"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include <talus/edits/runs.h>

namespace talus::client::testing {

class HandMaker::World final : public LocalWorld {
 public:
  World(std::shared_ptr<HandMaker> maker, ContentHash own_fingerprint)
      : maker_{std::move(maker)}, fingerprint_{own_fingerprint} {}
  [[nodiscard]] ContentHash fingerprint() const override { return fingerprint_; }
  void make(std::vector<ChunkKey> keys, std::shared_ptr<const std::atomic<bool>> cancel, Made done) override {
    maker_->batches.push_back(keys);
    maker_->cancels.push_back(cancel);
    maker_->run(maker_->holds_chunks,
                [maker = maker_, keys = std::move(keys), cancel = std::move(cancel), done = std::move(done)] {
                  std::vector<MadeChunk> made;
                  for (const ChunkKey& key : keys) {
                    if (*cancel) break;
                    auto chunk = std::make_shared<const Chunk>(maker->chunk(key));
                    made.push_back({key, content_hash(*chunk), chunk});
                  }
                  done(std::move(made));
                });
  }

 private:
  std::shared_ptr<HandMaker> maker_;
  ContentHash fingerprint_;
};

void HandMaker::run(bool hold, std::function<void()> job) {
  if (hold) {
    held.push_back(std::move(job));
  } else {
    job();
  }
}

void HandMaker::release() {
  holds_open = holds_chunks = false;
  for (const auto& job : std::exchange(held, {})) job();
}

std::size_t HandMaker::asked() const {
  std::size_t count = 0;
  for (const auto& batch : batches) count += batch.size();
  return count;
}

void HandMaker::open(std::shared_ptr<const WorldFiles> files, std::shared_ptr<const std::atomic<bool>> cancel,
                     Opened done) {
  ++opens;
  open_cancel = std::move(cancel);
  run(holds_open, [self = shared_from_this(), files = std::move(files), done = std::move(done)] {
    if (!self->failure.empty()) return done(tl::unexpected{OpenFailure{{}, self->failure}});
    OpenFailure lacking{{}, "a file is missing"};
    for (const std::string& name : self->names) {
      if (!files->contains(name)) lacking.missing_files.insert(name);
    }
    if (!lacking.missing_files.empty()) return done(tl::unexpected{lacking});
    self->opened = files;
    const bool another = self->empty_is_another && files->at("")->empty();
    done(std::make_shared<World>(self, another ? ContentHash{9, 9} : self->fingerprint));
  });
}

Events Told::events() {
  Events events;
  events.on_chunk = [this](const ReceivedChunk& chunk) {
    chunks.insert_or_assign(chunk.key, chunk);
    all.push_back(chunk);
  };
  events.on_left_view = [this](ChunkKey key) { chunks.erase(key); };
  events.on_view_complete = [this](const View&) { ++completes; };
  events.on_error = [this](const ClientError& error) { errors.push_back(error); };
  events.on_disconnect = [this](const ClientError& error, bool retrying) {
    disconnects.emplace_back(error, retrying);
  };
  events.on_reconnect = [this](const WorldInfo&) { ++reconnects; };
  events.on_world_files = [this](ContentHash, const std::shared_ptr<const WorldFiles>& fetched) {
    files = fetched;
  };
  return events;
}

asio::awaitable<void> PublishedPeer::serve() {
  for (int i = 0; i < connections; ++i) {
    co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, more);
    try {
      co_await serve_one();
    } catch (const std::system_error&) {
      // The client or the test has closed it.
    }
  }
}

asio::awaitable<void> PublishedPeer::serve_one() {
  while (true) {
    const wire::Message* message = co_await peer.receive();
    std::vector<protocol::Frame> answers;
    bool answered_view = false;
    if (const auto* get = message->body_as_GetFile()) {
      const std::string name = get->name() == nullptr ? "" : get->name()->str();
      asked_files.push_back(name);
      const auto file = files.find(name);
      if (file == files.end()) {
        answers.push_back(error_frame(wire::ErrorCode::out_of_range, "no such file", get->id()));
      } else {
        const std::size_t from = get->offset();
        const std::size_t count = std::min<std::size_t>(part_bytes, file->second.size() - from);
        answers.push_back(protocol::make_frame([&](auto& b) {
          const auto* bytes = reinterpret_cast<const std::uint8_t*>(file->second.data()) + from;
          return wire::CreateFilePart(b, get->id(), file->second.size(), b.CreateVector(bytes, count));
        }));
      }
    } else if (const auto* chunks = message->body_as_GetChunks()) {
      for (const auto* request : *chunks->requests()) {
        const wire::ChunkKey& at = request->key();
        const ChunkKey key = key_at(at.x(), at.y(), at.z(), at.lod());
        asked_chunks.push_back(key);
        const ContentHash hash = content_hash(chunk(key));
        const bool known =
            request->has_known() && ContentHash{request->known().low(), request->known().high()} == hash;
        if (!known) answers.push_back(chunk_frame(request->id(), key, chunk(key)));
        if (known) {
          answers.push_back(protocol::make_frame([&](auto& b) {
            const wire::Hash128 wire_hash{hash.low, hash.high};
            return wire::CreateUnchanged(b, request->id(), &at, 0, &wire_hash);
          }));
        }
      }
    } else if (const auto* ping = message->body_as_Ping()) {
      const auto nonce = ping->nonce();
      answers.push_back(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
    } else if (const auto* view = message->body_as_View()) {
      views.push_back({view->has_base(), view->centre()->x(), {}});
      if (view->known() != nullptr) {
        for (const auto* known : *view->known()) views.back().known.push_back(*known);
      }
      const std::uint32_t number = view->number();
      answered_view = answers_views;
      if (answered_view) {
        if (!view->has_base()) {
          ViewShape{small_view(view->centre()->x())}.for_each(
              [&](const ChunkKey& key) { answers.push_back(chunk_frame(0, key, chunk(key), revision)); });
        } else if (edits) {
          answers = edits();
        }
        answers.push_back(complete_frame(number));
      }
    }
    for (auto& answer : answers) co_await peer.send(std::move(answer));
    if (answered_view && on_view) on_view();
  }
}

Options generating(const std::shared_ptr<HandMaker>& maker, Generate generate) {
  Options options;
  options.generate = generate;
  options.maker = maker;
  options.reconnect.max_attempts = 3;
  options.reconnect.first_delay = std::chrono::milliseconds{0};
  options.reconnect.max_delay = std::chrono::milliseconds{1};
  return options;
}

View small_view(std::int64_t x) {
  View view;
  view.centre = {x, 0, 0};
  view.horizontal_radius = 1;
  view.vertical_radius = 1;
  return view;
}

protocol::Frame edit_frame(const ChunkKey& key, std::uint64_t previous, std::uint64_t revision,
                           const std::vector<Override>& voxels) {
  std::vector<std::byte> runs;
  edits::encode_runs(voxels, runs);
  return protocol::make_frame([&](auto& b) {
    const wire::ChunkKey wire_key{key.coord.x, key.coord.y, key.coord.z,
                                  static_cast<std::uint8_t>(key.lod.value())};
    const auto bytes = b.CreateVector(reinterpret_cast<const std::uint8_t*>(runs.data()), runs.size());
    return wire::CreateEditBroadcast(b, &wire_key, revision, previous, 0, bytes);
  });
}

asio::awaitable<void> until(Client& client, std::function<bool()> held) {
  while (!held()) (void)co_await client.ping();
}

}  // namespace talus::client::testing
