// A session on a scripted source and a manual clock, in the test's own thread.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <talus/edits/runs.h>
#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>

#include "config/access/access_control.h"
#include "frames.h"
#include "player/session/session.h"
#include "runtime/manual_clock.h"
#include "scripted_source.h"
#include "session_limits_of_tests.h"

namespace talus::server {

/// One frame of the server, in values.
struct SessionFrame {
  wire::Body kind{};
  std::uint32_t id = 0;  // of the request; 0: about none
  ChunkKey key;
  std::uint64_t revision = 0;
  std::uint64_t previous_revision = 0;  // of an EditBroadcast
  std::vector<Override> voxels;         // likewise
  wire::ErrorCode code{};
  wire::ErrorAbout about{};
  std::uint32_t repeated_id = 0;
  std::uint32_t view_number = 0;  // of an Error or a ViewComplete
  std::string text;
  std::uint32_t retry_after_ms = 0;
  std::vector<std::array<std::int32_t, 3>> runs;  // first row, last row, material
  std::size_t frame_bytes = 0;
  std::uint64_t size = 0;  // of a FilePart's file; its bytes are `text`
};

[[nodiscard]] inline ChunkKey key_of(const wire::ChunkKey& key) {
  return {{key.x(), key.y(), key.z()}, Lod::of(key.lod())};
}

[[nodiscard]] inline SessionFrame said(const protocol::Frame& frame) {
  const wire::Message& message = **protocol::read_message(frame);
  SessionFrame said;
  said.kind = message.body_type();
  said.frame_bytes = frame.size();
  if (const auto* chunk = message.body_as_Chunk()) {
    said.id = chunk->id();
    said.key = key_of(*chunk->key());
    said.revision = chunk->revision();
  } else if (const auto* unchanged = message.body_as_Unchanged()) {
    said.id = unchanged->id();
    said.key = key_of(*unchanged->key());
    said.revision = unchanged->revision();
  } else if (const auto* result = message.body_as_EditResult()) {
    said.id = result->id();
    said.revision = result->revision();
  } else if (const auto* broadcast = message.body_as_EditBroadcast()) {
    said.key = key_of(*broadcast->key());
    said.revision = broadcast->revision();
    said.previous_revision = broadcast->previous_revision();
    said.voxels = edits::decode_runs({reinterpret_cast<const std::byte*>(broadcast->runs()->data()),
                                      broadcast->runs()->size()})
                      .value();
  } else if (const auto* heights = message.body_as_Heights()) {
    said.id = heights->id();
  } else if (const auto* part = message.body_as_FilePart()) {
    said.id = part->id();
    said.size = part->size();
    said.text.assign(part->bytes()->begin(), part->bytes()->end());
  } else if (const auto* error = message.body_as_Error()) {
    said.id = error->request_id();
    said.code = error->code();
    said.about = error->about();
    said.repeated_id = error->repeated_id();
    said.view_number = error->view_number();
    if (error->chunk() != nullptr) said.key = key_of(*error->chunk());
    said.text = error->text()->str();
    said.retry_after_ms = error->retry_after_ms();
  } else if (const auto* complete = message.body_as_ViewComplete()) {
    said.view_number = complete->number();
  } else if (const auto* away = message.body_as_GoAway()) {
    said.retry_after_ms = away->retry_after_ms();
  } else if (const auto* column = message.body_as_UniformColumn()) {
    said.key = {{column->x(), 0, column->z()}, Lod::of(column->lod())};
    said.revision = column->revision();
    for (const wire::UniformRun* run : *column->runs()) {
      said.runs.push_back({run->first_y(), run->last_y(), run->material()});
    }
  }
  return said;
}

[[nodiscard]] inline std::vector<wire::Body> kinds(const std::vector<SessionFrame>& all) {
  std::vector<wire::Body> kinds;
  for (const SessionFrame& each : all) kinds.push_back(each.kind);
  return kinds;
}

[[nodiscard]] inline ChunkKey chunk_at(std::int32_t x, std::int32_t y = 0, std::int32_t z = 0) {
  return {{x, y, z}, Lod{}};
}

struct SessionBench {
  struct Options {
    RateLimits rates{};
    AddressBucketsPtr address{};
    std::uint64_t memory_bytes = 0;
    Access access{};
    bool greet = true;
    HeightRange heights{};  // of the world
    EditTaker* edits = nullptr;
    EditRules rules{};
    std::shared_ptr<const PublishedWorld> published{};
  };

  ScriptedSource source;
  ManualClock clock{std::chrono::sys_seconds{std::chrono::seconds{1'700'000'000}}};
  MemoryBudget memory;
  Metrics metrics;
  SessionLimits limits = test_limits();
  WorldInfo world;
  CurrentRates rates;
  FlowUses flows;
  AccessControl access;
  MailboxPtr mailbox = std::make_shared<Mailbox>(ClientId{1}, [] {});
  Session session;
  // Of the Views to come.
  std::uint32_t view_number = 0;
  bool has_base = false;

  explicit SessionBench(const Options& options)
      : memory{options.memory_bytes},
        world{.heights = options.heights, .published = options.published},
        rates{options.rates},
        access{options.access, *load_keys(options.access)},
        session{{limits, world, source, memory, metrics, access, rates, flows, clock, options.edits},
                mailbox,
                options.address} {
    limits.edits = options.rules;
    limits.view_base = options.published != nullptr;
    if (!options.greet) return;
    hello();
    (void)output();
  }
  SessionBench() : SessionBench(Options{}) {}

  // ---- the client says
  template <typename Make>
  void receive(Make&& make) {
    session.receive(protocol::make_frame(make));
    session.pump();
  }
  void hello(const std::string& token = "", std::uint8_t codec = kCodecVersion) {
    receive([&](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{codec});
      const auto shown = builder.CreateString(token);
      return wire::CreateHello(builder, protocol::kOldestProtocol, protocol::kProtocolVersion, codecs, shown);
    });
  }
  void get_chunk(std::uint32_t id, ChunkKey key, const EncodedChunkPtr& known = nullptr) {
    receive([&](auto& builder) {
      const auto hash = known == nullptr ? ContentHash{} : known->hash();
      const wire::ChunkKey at{key.coord.x, key.coord.y, key.coord.z,
                              static_cast<std::uint8_t>(key.lod.value())};
      const std::vector<wire::ChunkRequest> requests{
          {id, at, known != nullptr, wire::Hash128{hash.low, hash.high}}};
      return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
    });
  }
  /// Several requests in one message.
  void get_chunks(const std::vector<std::pair<std::uint32_t, ChunkKey>>& wanted) {
    receive([&](auto& builder) {
      std::vector<wire::ChunkRequest> requests;
      for (const auto& [id, key] : wanted) {
        const auto lod = static_cast<std::uint8_t>(key.lod.value());
        requests.emplace_back(id, wire::ChunkKey{key.coord.x, key.coord.y, key.coord.z, lod}, false,
                              wire::Hash128{});
      }
      return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
    });
  }
  void get_heights(std::uint32_t id, std::int64_t x = 0) {
    receive([&](auto& builder) {
      return wire::CreateGetHeights(builder, id,
                                    builder.CreateVectorOfStructs(std::vector{wire::ColumnPos{x, 0}}));
    });
  }
  void get_file(std::uint32_t id, const std::string& name = "", std::uint64_t offset = 0) {
    receive([&](auto& builder) {
      return wire::CreateGetFile(builder, id, name.empty() ? 0 : builder.CreateString(name), offset);
    });
  }
  void cancel(std::uint32_t id) {
    receive([&](auto& builder) {
      return wire::CreateCancel(builder, builder.CreateVector(std::vector<std::uint32_t>{id}));
    });
  }
  void ping() {
    receive([](auto& builder) { return wire::CreatePing(builder, 7); });
  }
  void edit(std::uint32_t id) {
    receive([&](auto& builder) { return wire::CreateEdit(builder, id); });
  }
  void attach(edits::EditorId editor = {}, std::uint64_t seen_revision = 0) {
    receive([&](auto& builder) {
      const wire::Hash128 id{editor.low, editor.high};
      return wire::CreateAttach(builder, &id, seen_revision);
    });
  }
  /// One voxel.
  void write_voxel(std::uint32_t id, std::uint64_t sequence, VoxelPos at = {}, std::uint16_t material = 1,
                   const std::string& subject = "") {
    receive([&](auto& builder) {
      const std::vector<wire::VoxelWrite> writes{{{at.x, at.y, at.z}, material}};
      const auto list = builder.CreateVectorOfStructs(writes);
      return wire::CreateEdit(builder, id, list, sequence, 0, 0, 0,
                              subject.empty() ? 0 : builder.CreateString(subject));
    });
  }
  void credit(std::uint64_t total_bytes) {
    receive([&](auto& builder) { return wire::CreateCredit(builder, total_bytes); });
  }
  /// A View around chunk (chunk_x, 0, 0), which waits to be applied.
  void say_view(std::int64_t chunk_x, std::uint16_t radius, std::uint16_t vertical_radius = 0,
                const std::vector<EncodedChunkPtr>& known = {}, const std::vector<ChunkKey>& keys = {}) {
    receive([&](auto& builder) {
      std::vector<wire::KnownChunk> held;
      for (std::size_t i = 0; i < known.size(); ++i) {
        const auto [x, y, z] = keys[i].coord;
        const ContentHash hash = known[i]->hash();
        held.push_back({wire::ChunkKey{x, y, z, 0}, wire::Hash128{hash.low, hash.high}});
      }
      const wire::Voxel centre{chunk_x * kChunkSize, 0, 0};
      const wire::Direction none{0, 0, 0};
      const auto list = builder.CreateVectorOfStructs(held);
      return wire::CreateView(builder, &centre, &none, radius, vertical_radius, 0, list, view_number,
                              /*horizon=*/false, has_base);
    });
  }
  void move_view(std::int64_t chunk_x, std::uint16_t radius, std::uint16_t vertical_radius = 0) {
    say_view(chunk_x, radius, vertical_radius);
    apply_view();
  }
  void apply_view() {
    (void)session.apply_view();
    session.pump();
  }

  // ---- the source answers
  void take_mail() {
    session.take_mail();
    session.pump();
  }
  void answer_all() {
    source.answer_all();
    take_mail();
  }

  // ---- the server says
  [[nodiscard]] std::vector<SessionFrame> output(std::size_t enough_bytes = 1 << 20) {
    std::vector<SessionFrame> all;
    for (const auto& frame : cut(session.take_output(enough_bytes))) all.push_back(said(frame));
    session.written();
    session.pump();
    return all;
  }
  /// All that comes while the source answers at once.
  [[nodiscard]] std::vector<SessionFrame> run_dry() {
    std::vector<SessionFrame> all;
    for (bool more = true; more;) {
      answer_all();
      const auto some = output();
      all.insert(all.end(), some.begin(), some.end());
      more = !some.empty();
    }
    return all;
  }
};

using Kinds = std::vector<wire::Body>;
using Runs = std::vector<std::array<std::int32_t, 3>>;

}  // namespace talus::server
