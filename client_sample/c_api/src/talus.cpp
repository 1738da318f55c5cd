// Functions of talus.h: checks arguments, and converts failures to a status and a message.
#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include <talus/protocol/limits.h>
#include <talus/voxel/coords.h>
#ifdef TALUS_HAS_GENERATOR
#include <talus/local_source/local_source.h>
#endif

#include "client.h"
#include "convert.h"
#include "structs.h"

using namespace talus;
using namespace talus::c_api;

namespace {

constexpr std::string_view kNoClient = "client is NULL; talus_create() makes one";
constexpr std::string_view kNotJoined = "not connected; talus_connect() and the event JOINED come first";

// For calls without a client: talus_last_error(NULL).
thread_local ErrorLine error_of_thread;

// One call: its name and the place of its error message.
class Call {
 public:
  Call(const char* function, talus_client* client) : function_{function}, client_{client} {}

  talus_status fail(talus_status status, std::string_view what) const noexcept {
    (client_ == nullptr ? error_of_thread : client_->error).set(function_, what);
    return status;
  }
  talus_status wrong(std::string_view what) const noexcept { return fail(TALUS_INVALID_ARGUMENT, what); }
  talus_status fail(const client::ClientError& error) const noexcept {
    return fail(status_of(error.kind), error.message);
  }

 private:
  const char* function_;
  talus_client* client_;
};

// Runs `work`. An exception becomes a status and ends the session, whose state may be inconsistent.
template <typename Work>
talus_status guarded(const char* function, talus_client* client, Work&& work) noexcept {
  const Call call{function, client};
  if (client == nullptr) return call.wrong(kNoClient);
  try {
    return work(call);
  } catch (const std::bad_alloc&) {
    client->session.reset();
    return call.fail(TALUS_OUT_OF_MEMORY, "out of memory; the connection is closed");
  } catch (const std::exception& error) {
    client->session.reset();
    return call.fail(TALUS_INTERNAL, error.what());
  } catch (...) {
    client->session.reset();
    return call.fail(TALUS_INTERNAL, "a fault of the library");
  }
}

// Like guarded(), for calls that require a joined client.
template <typename Work>
talus_status guarded_joined(const char* function, talus_client* client, Work&& work) noexcept {
  return guarded(function, client, [&](const Call& call) {
    if (!client->session || !client->session->takes_requests()) {
      return call.fail(TALUS_NOT_CONNECTED, kNotJoined);
    }
    return work(call, *client->session);
  });
}

std::string wrong_struct(const char* name) {
  return std::string{name} + " is NULL or has a wrong size; set its size to sizeof the struct";
}

std::string newer_struct(const char* name) {
  return std::string{name} + " asks for what only a newer library can do, this one is " +
         std::to_string(TALUS_API_MAJOR) + "." + std::to_string(TALUS_API_MINOR);
}

// Copies a caller's struct and passes it to `convert`.
template <typename T, typename Convert>
auto read_argument(const T* given, const char* name, Convert&& convert) -> decltype(convert(*given)) {
  if (!has_size(given)) return tl::unexpected{wrong_struct(name)};
  const auto own = read_struct(given);
  if (!own) return tl::unexpected{newer_struct(name)};
  return convert(*own);
}

// The columns, if their number is allowed; an absurd count is never read.
ConversionResult<std::vector<client::Column>> columns_of(const std::int64_t* columns, std::size_t count) {
  if (columns == nullptr || count == 0)
    return tl::unexpected<std::string>{"no columns; give x and z of at least one"};
  std::vector<client::Column> own;
  own.reserve(count);
  for (std::size_t i = 0; i < count; ++i) own.push_back({columns[2 * i], columns[2 * i + 1]});
  return own;
}

talus_status check_count(const Call& call, const Session& session, std::size_t count) {
  const std::uint32_t most = session.newest_world()->limits.heights_per_request;
  if (count <= most) return TALUS_OK;
  return call.fail(TALUS_OUT_OF_RANGE,
                   std::to_string(count) + " columns; this server allows " + std::to_string(most));
}

void tell_number(std::uint32_t number, std::uint32_t* request) {
  if (request != nullptr) *request = number;
}

std::int32_t uniform_material(const Chunk* chunk) {
  return chunk != nullptr && chunk->is_uniform() ? to_integer(chunk->at({})) : -1;
}

template <typename T>
const T* data_or_null(const std::vector<T>& list) {
  return list.empty() ? nullptr : list.data();
}

// Converts `current` to the caller's struct; its pointers belong to the client.
talus_event told(const QueuedEvent& current, const talus_chunk* chunk) {
  talus_event event{};
  event.type = current.type;
  event.request = current.request;
  const auto& [x, y, z] = current.chunk.key.coord;
  event.x = x;
  event.y = y;
  event.z = z;
  event.level = static_cast<std::uint32_t>(current.chunk.key.lod.value());
  event.revision = current.chunk.revision;
  event.hash_low = current.chunk.hash.low;
  event.hash_high = current.chunk.hash.high;
  event.chunk = chunk;
  event.uniform_material = uniform_material(current.chunk.chunk.get());
  event.message = "";
  if (current.error) {
    event.status = status_of(current.error->kind);
    event.message = current.error->message.c_str();
    event.retry_after_ms = static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(current.error->retry_after.count(), 0, UINT32_MAX));
  }
  event.heights_fx = data_or_null(current.places.heights_fx);
  event.looks = data_or_null(current.places.looks);
  event.values = data_or_null(current.places.values);
  event.column_count = static_cast<std::uint32_t>(current.places.heights_fx.size());
  event.field_count = current.field_count;
  if (current.type == TALUS_EVENT_EDITED) event.revision = current.done.revision;
  event.changed_voxels = current.done.changed;
  event.round_trip_ns = static_cast<std::uint64_t>(std::max<std::int64_t>(current.round_trip.count(), 0));
  return event;
}

}  // namespace

uint32_t talus_api_version(void) {
  return (std::uint32_t{TALUS_API_MAJOR} << 16) | TALUS_API_MINOR;
}

const char* talus_version(void) {
  return TALUS_VERSION;
}

talus_status talus_create(talus_client** client) {
  const Call call{"talus_create", nullptr};
  if (client == nullptr) return call.wrong("client is NULL; give where to put it");
  *client = new (std::nothrow) talus_client;
  return *client == nullptr ? call.fail(TALUS_OUT_OF_MEMORY, "out of memory") : TALUS_OK;
}

void talus_destroy(talus_client* client) {
  delete client;
}

const char* talus_last_error(const talus_client* client) {
  return (client == nullptr ? error_of_thread : client->error).text();
}

talus_status talus_connect(talus_client* client, const talus_connect_options* options) {
  return guarded("talus_connect", client, [&](const Call& call) {
    if (client->session && !client->session->is_over()) {
      return call.fail(TALUS_ALREADY_CONNECTED, "connected or connecting; call talus_disconnect() first");
    }
    auto own = read_argument(options, "options", options_of);
    if (!own) return call.wrong(own.error());
    if (own->generate != client::Generate::never) {
#ifdef TALUS_HAS_GENERATOR
      own->maker = std::make_shared<LocalSource>(LocalSourceOptions{read_struct(options)->generate_threads});
#else
      return call.fail(TALUS_UNSUPPORTED, "this library was built without the generator");
#endif
    }
#ifndef TALUS_HAS_TLS
    if (own->tls.on || own->websocket.on) {
      return call.fail(TALUS_UNSUPPORTED, "this library was built without TLS, and so without WebSocket");
    }
#endif
    const std::uint32_t port = options->port == 0 ? TALUS_DEFAULT_PORT : options->port;
    auto session = std::make_unique<Session>(options->host, std::to_string(port), *own);
    client->current = {};
    client->chunk.reset();
    client->world.reset();
    client->session = std::move(session);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_disconnect(talus_client* client) {
  return guarded("talus_disconnect", client, [&](const Call&) {
    client->session.reset();
    client->world.reset();
    return talus_status{TALUS_OK};
  });
}

talus_status talus_poll(talus_client* client, talus_event* event, std::int32_t timeout_ms) {
  return guarded("talus_poll", client, [&](const Call& call) {
    if (!has_size(event)) return call.wrong(wrong_struct("event"));
    if (!client->session || client->session->is_over()) {
      return call.fail(TALUS_NOT_CONNECTED, "no event can come; call talus_connect() first");
    }
    client->chunk.reset();
    const QueuedEvent* next = client->session->wait(timeout_ms);
    if (next == nullptr) return talus_status{TALUS_NO_EVENT};
    if (next->chunk.chunk) client->chunk.reset(new talus_chunk{next->chunk.chunk});
    client->current = client->session->pop();
    if (client->current.world) client->world = client->current.world;
    write_struct(event, told(client->current, client->chunk.get()));
    return talus_status{TALUS_OK};
  });
}

talus_status talus_get_world(talus_client* client, talus_world* world) {
  return guarded("talus_get_world", client, [&](const Call& call) {
    if (!has_size(world)) return call.wrong(wrong_struct("world"));
    if (!client->world) return call.fail(TALUS_NOT_CONNECTED, kNotJoined);
    write_struct(world, world_of(*client->world));
    return talus_status{TALUS_OK};
  });
}

talus_status talus_get_material(talus_client* client, std::uint32_t index, talus_material* material) {
  return guarded("talus_get_material", client, [&](const Call& call) {
    if (!has_size(material)) return call.wrong(wrong_struct("material"));
    if (!client->world) return call.fail(TALUS_NOT_CONNECTED, kNotJoined);
    const auto& all = client->world->materials;
    if (index >= all.size()) {
      return call.wrong("material " + std::to_string(index) + "; this world has " +
                        std::to_string(all.size()));
    }
    write_struct(material, material_of(all[index]));
    return talus_status{TALUS_OK};
  });
}

const char* talus_look_name(talus_client* client, std::uint32_t index) {
  const char* name = nullptr;
  (void)guarded("talus_look_name", client, [&](const Call& call) {
    if (!client->world) return call.fail(TALUS_NOT_CONNECTED, kNotJoined);
    const auto& all = client->world->looks;
    if (index >= all.size()) {
      return call.wrong("look " + std::to_string(index) + "; this world has " + std::to_string(all.size()));
    }
    name = all[index].c_str();
    return talus_status{TALUS_OK};
  });
  return name;
}

const char* talus_field_name(talus_client* client, std::uint32_t index) {
  const char* name = nullptr;
  (void)guarded("talus_field_name", client, [&](const Call& call) {
    if (!client->world) return call.fail(TALUS_NOT_CONNECTED, kNotJoined);
    const auto& all = client->world->fields;
    if (index >= all.size()) {
      return call.wrong("field " + std::to_string(index) + "; this world has " + std::to_string(all.size()));
    }
    name = all[index].c_str();
    return talus_status{TALUS_OK};
  });
  return name;
}

talus_status talus_set_view(talus_client* client, const talus_view* view) {
  return guarded_joined("talus_set_view", client, [&](const Call& call, Session& session) {
    const auto own = read_argument(view, "view", view_of);
    if (!own) return call.wrong(own.error());
    if (own->horizon && !session.newest_world()->limits.view_horizon) {
      return call.fail(TALUS_UNSUPPORTED,
                       "this server does not support TALUS_VIEW_HORIZON; check talus_world.has_horizon");
    }
    if (session.is_full()) {
      return call.fail(TALUS_TOO_MANY_EVENTS, "too many events wait; poll until TALUS_NO_EVENT comes");
    }
    const auto set = session.set_view(*own);
    return set ? talus_status{TALUS_OK} : call.fail(set.error());
  });
}

talus_status talus_count_view(talus_client* client, const talus_view* view, std::uint64_t* chunks) {
  return guarded_joined("talus_count_view", client, [&](const Call& call, Session& session) {
    if (chunks == nullptr) return call.wrong("chunks is NULL; give where to put the number");
    const auto own = read_argument(view, "view", view_of);
    if (!own) return call.wrong(own.error());
    *chunks = static_cast<std::uint64_t>(client::ViewShape{*own, session.newest_world()->heights()}.count());
    return talus_status{TALUS_OK};
  });
}

talus_status talus_fill_rings(talus_view* view, std::uint16_t farthest) {
  const Call call{"talus_fill_rings", nullptr};
  try {
    if (!has_size(view)) return call.wrong(wrong_struct("view"));
    std::fill(std::begin(view->ring_radius), std::end(view->ring_radius), std::uint16_t{0});
    for (const client::LodRing& ring : client::rings_between(view->horizontal_radius, farthest)) {
      view->ring_radius[ring.lod.value() - 1] = ring.radius;
    }
    return TALUS_OK;
  } catch (const std::bad_alloc&) {
    return call.fail(TALUS_OUT_OF_MEMORY, "out of memory");
  }
}

talus_status talus_get_chunk(talus_client* client, std::int32_t x, std::int32_t y, std::int32_t z,
                             std::uint32_t level, const std::uint64_t known[2], std::uint32_t* request) {
  return guarded_joined("talus_get_chunk", client, [&](const Call& call, Session& session) {
    const auto lod = Lod::checked(level);
    if (!lod) return call.fail(TALUS_OUT_OF_RANGE, lod.error().message);
    const auto key = checked_chunk(x, y, z, *lod);
    if (!key) return call.fail(TALUS_OUT_OF_RANGE, key.error().message);
    std::optional<ContentHash> hash;
    if (known != nullptr) hash = ContentHash{known[0], known[1]};
    tell_number(session.get_chunk(*key, hash), request);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_get_heights(talus_client* client, const std::int64_t* columns, std::size_t count,
                               std::uint32_t* request) {
  return guarded_joined("talus_get_heights", client, [&](const Call& call, Session& session) {
    if (const auto status = check_count(call, session, count); status != TALUS_OK) return status;
    auto own = columns_of(columns, count);
    if (!own) return call.wrong(own.error());
    tell_number(session.get_heights(std::move(*own)), request);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_get_places(talus_client* client, const std::int64_t* columns, std::size_t count,
                              const char* const* fields, std::size_t field_count, std::uint32_t* request) {
  return guarded_joined("talus_get_places", client, [&](const Call& call, Session& session) {
    if (const auto status = check_count(call, session, count); status != TALUS_OK) return status;
    auto own = columns_of(columns, count);
    if (!own) return call.wrong(own.error());
    if (field_count > protocol::kMaxFieldsPerRequest) {
      return call.wrong(std::to_string(field_count) + " fields; the most is " +
                        std::to_string(protocol::kMaxFieldsPerRequest));
    }
    if (fields == nullptr && field_count > 0) return call.wrong("fields is NULL; give their names");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < field_count; ++i) names.push_back(text_of(fields[i]));
    tell_number(session.get_places(std::move(*own), std::move(names)), request);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_send_edit(talus_client* client, const talus_edit* edit, std::uint32_t* request) {
  return guarded_joined("talus_send_edit", client, [&](const Call& call, Session& session) {
    auto own = read_argument(edit, "edit", edit_of);
    if (!own) return call.wrong(own.error());
    tell_number(session.edit(std::move(*own)), request);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_ping(talus_client* client, std::uint32_t* request) {
  return guarded_joined("talus_ping", client, [&](const Call&, Session& session) {
    tell_number(session.ping(), request);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_cancel(talus_client* client, std::uint32_t request) {
  return guarded_joined("talus_cancel", client, [&](const Call&, Session& session) {
    session.cancel(request);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_get_stats(talus_client* client, talus_stats* stats) {
  return guarded("talus_get_stats", client, [&](const Call& call) {
    if (!has_size(stats)) return call.wrong(wrong_struct("stats"));
    if (!client->session) return call.fail(TALUS_NOT_CONNECTED, "call talus_connect() first");
    const client::Stats& own = client->session->stats();
    write_struct(stats,
                 talus_stats{0, 0, own.received_bytes, own.sent_bytes, own.chunk_frames, own.chunk_bytes,
                             own.uniform_chunks, own.kept_chunks, own.bad_chunks, own.connections,
                             own.made_chunks, own.proofs, own.failed_proofs, own.file_bytes});
    return talus_status{TALUS_OK};
  });
}

talus_status talus_decode(const talus_chunk* chunk, std::uint16_t* voxels, std::size_t count) {
  const Call call{"talus_decode", nullptr};
  if (chunk == nullptr) return call.wrong("chunk is NULL; give an event's chunk");
  if (voxels == nullptr) return call.wrong("voxels is NULL; give room for TALUS_CHUNK_VOLUME of them");
  if (count != kChunkVolume) return call.wrong("count is not TALUS_CHUNK_VOLUME, 32768");
  // An enumeration is laid out as its underlying type, and the caller's compiler does not see this store.
  static_assert(sizeof(MaterialId) == sizeof(std::uint16_t));
  chunk->voxels->copy_to(
      std::span<MaterialId, kChunkVolume>{reinterpret_cast<MaterialId*>(voxels), kChunkVolume});
  return TALUS_OK;
}

void talus_chunk_retain(const talus_chunk* chunk) {
  if (chunk != nullptr) chunk->holders.fetch_add(1, std::memory_order_relaxed);
}

void talus_chunk_release(const talus_chunk* chunk) {
  // The last holder must see all other holders' accesses.
  if (chunk != nullptr && chunk->holders.fetch_sub(1, std::memory_order_acq_rel) == 1) delete chunk;
}
