#include "walk.h"

#include <bit>
#include <type_traits>

namespace talus::protocol::testing {
namespace {

class Digest {
 public:
  template <typename... Values>
  void add(const Values&... values) {
    (one(values), ...);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  template <typename Number>
  requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void one(Number number) {
    std::uint64_t bits = 0;
    if constexpr (std::is_floating_point_v<Number>) {
      bits = std::bit_cast<std::uint32_t>(number);
    } else {
      bits = static_cast<std::uint64_t>(number);
    }
    value_ = (value_ ^ bits) * 0x100000001B3U;
  }

  void one(const wire::Hash128& hash) { add(hash.low(), hash.high()); }
  void one(const wire::ChunkKey& key) { add(key.x(), key.y(), key.z(), key.lod()); }
  void one(const wire::Voxel& voxel) { add(voxel.x(), voxel.y(), voxel.z()); }
  void one(const wire::Direction& direction) { add(direction.x(), direction.y(), direction.z()); }
  void one(const wire::ColumnPos& column) { add(column.x(), column.z()); }
  void one(const wire::LodRing& ring) { add(ring.lod(), ring.radius()); }
  void one(const wire::UniformRun& run) { add(run.first_y(), run.last_y(), run.material()); }
  void one(const wire::VoxelWrite& write) { add(write.voxel(), write.material()); }
  void one(const wire::ChunkRequest& request) {
    add(request.id(), request.key(), request.has_known(), request.known());
  }
  void one(const wire::KnownChunk& chunk) { add(chunk.key(), chunk.hash()); }
  void one(const wire::Material& material) {
    add(material.id(), material.name(), material.colour(), material.phase());
  }
  void one(const wire::Limits& limits) {
    add(limits.frame_bytes(), limits.requests_in_flight(), limits.heights_per_request(),
        limits.view_horizontal_radius(), limits.view_vertical_radius(), limits.view_chunks(),
        limits.window_bytes(), limits.idle_timeout_ms(), limits.session_rates(), limits.address_rates(),
        limits.view_horizon(), limits.view_base());
  }
  void one(const wire::Fill& fill) {
    add(fill.first(), fill.last(), fill.material(), fill.only(), fill.flags());
  }
  void one(const wire::Paste& paste) { add(paste.origin(), paste.payload(), paste.with_air()); }
  void one(const wire::EditLimits& limits) {
    add(limits.voxels(), limits.chunks(), limits.unanswered(), limits.voxels_per_second());
  }
  void one(const wire::Rates& rates) {
    add(rates.chunks(), rates.bytes(), rates.requests(), rates.burst_ms());
  }

  void one(const flatbuffers::String* text) {
    add(text != nullptr);
    if (text == nullptr) return;
    for (const char c : text->string_view()) add(c);
  }
  template <typename Element>
  void one(const flatbuffers::Vector<Element>* vector) {
    add(vector != nullptr);
    if (vector == nullptr) return;
    for (const auto& element : *vector) add(element);
  }
  template <typename Pointed>
  void one(const Pointed* pointer) {
    add(pointer != nullptr);
    if (pointer != nullptr) add(*pointer);
  }

  std::uint64_t value_ = 0xCBF29CE484222325U;
};

void walk_from_client(const wire::Message& message, Digest& digest) {
  if (const auto* m = message.body_as_Hello()) {
    digest.add(m->protocol_min(), m->protocol_max(), m->codecs(), m->token(), m->client(), m->window_bytes());
  } else if (const auto* view = message.body_as_View()) {
    digest.add(view->centre(), view->direction(), view->horizontal_radius(), view->vertical_radius(),
               view->rings(), view->known(), view->number(), view->horizon(), view->has_base());
  } else if (const auto* chunks = message.body_as_GetChunks()) {
    digest.add(chunks->requests());
  } else if (const auto* cancel = message.body_as_Cancel()) {
    digest.add(cancel->ids());
  } else if (const auto* heights = message.body_as_GetHeights()) {
    digest.add(heights->id(), heights->columns(), heights->looks(), heights->fields());
  } else if (const auto* credit = message.body_as_Credit()) {
    digest.add(credit->total_bytes());
  } else if (const auto* edit = message.body_as_Edit()) {
    digest.add(edit->id(), edit->writes(), edit->sequence(), edit->guards(), edit->fills(), edit->paste(),
               edit->subject());
  } else if (const auto* attach = message.body_as_Attach()) {
    digest.add(attach->editor(), attach->seen_revision());
  } else if (const auto* file = message.body_as_GetFile()) {
    digest.add(file->id(), file->name(), file->offset());
  } else if (const auto* ping = message.body_as_Ping()) {
    digest.add(ping->nonce());
  }
}

void walk_from_server(const wire::Message& message, Digest& digest) {
  if (const auto* m = message.body_as_Welcome()) {
    digest.add(m->protocol(), m->codec(), m->fingerprint(), m->store_id(), m->chunk_size(), m->materials(),
               m->min_y(), m->max_y(), m->spawn(), m->limits(), m->server(), m->looks(), m->fields(),
               m->world_file());
  } else if (const auto* chunk = message.body_as_Chunk()) {
    digest.add(chunk->id(), chunk->key(), chunk->revision(), chunk->hash(), chunk->codec(), chunk->payload());
  } else if (const auto* unchanged = message.body_as_Unchanged()) {
    digest.add(unchanged->id(), unchanged->key(), unchanged->revision(), unchanged->hash());
  } else if (const auto* column = message.body_as_UniformColumn()) {
    digest.add(column->x(), column->z(), column->lod(), column->revision(), column->runs());
  } else if (const auto* heights = message.body_as_Heights()) {
    digest.add(heights->id(), heights->heights_fx(), heights->looks(), heights->values());
  } else if (const auto* error = message.body_as_Error()) {
    digest.add(error->code(), error->text(), error->request_id(), error->retry_after_ms(), error->about(),
               error->repeated_id(), error->view_number(), error->chunk());
  } else if (const auto* part = message.body_as_FilePart()) {
    digest.add(part->id(), part->size(), part->bytes());
  } else if (const auto* result = message.body_as_EditResult()) {
    digest.add(result->id(), result->revision(), result->changed());
  } else if (const auto* broadcast = message.body_as_EditBroadcast()) {
    digest.add(broadcast->key(), broadcast->revision(), broadcast->previous_revision(), broadcast->writes(),
               broadcast->runs());
  } else if (const auto* pong = message.body_as_Pong()) {
    digest.add(pong->nonce());
  } else if (const auto* away = message.body_as_GoAway()) {
    digest.add(away->reason(), away->retry_after_ms());
  } else if (const auto* complete = message.body_as_ViewComplete()) {
    digest.add(complete->number());
  } else if (const auto* attached = message.body_as_Attached()) {
    digest.add(attached->editor(), attached->epoch(), attached->last_sequence(), attached->known(),
               attached->revision(), attached->limits());
  }
}

}  // namespace

std::uint64_t walk(const wire::Message& message) {
  Digest digest;
  digest.add(message.body_type());
  walk_from_client(message, digest);
  walk_from_server(message, digest);
  return digest.value();
}

}  // namespace talus::protocol::testing
