#include "convert.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/protocol/endpoint.h>

#include "edit_argument.h"

namespace talus::c_api {
namespace {

template <typename T, typename U>
void set_unless_zero(T& value, U given) {
  if (given != 0) value = T{given};
}

}  // namespace

talus_status status_of(client::ErrorKind kind) {
  using client::ErrorKind;
  switch (kind) {
    case ErrorKind::unreachable:
      return TALUS_UNREACHABLE;
    case ErrorKind::refused:
      return TALUS_REFUSED;
    case ErrorKind::untrusted:
      return TALUS_UNTRUSTED;
    case ErrorKind::disconnected:
      return TALUS_DISCONNECTED;
    case ErrorKind::timed_out:
      return TALUS_TIMED_OUT;
    case ErrorKind::world_changed:
      return TALUS_WORLD_CHANGED;
    case ErrorKind::broken_protocol:
      return TALUS_BROKEN_PROTOCOL;
    case ErrorKind::bad_chunk:
      return TALUS_BAD_CHUNK;
    case ErrorKind::out_of_range:
      return TALUS_OUT_OF_RANGE;
    case ErrorKind::overloaded:
      return TALUS_OVERLOADED;
    case ErrorKind::cancelled:
      return TALUS_CANCELLED;
    case ErrorKind::server_failed:
      return TALUS_SERVER_FAILED;
    case ErrorKind::not_connected:
      return TALUS_NOT_CONNECTED;
    case ErrorKind::conflict:
      return TALUS_CONFLICT;
    case ErrorKind::not_applied:
      return TALUS_NOT_APPLIED;
    case ErrorKind::outcome_unknown:
      return TALUS_OUTCOME_UNKNOWN;
    case ErrorKind::cannot_generate:
      return TALUS_CANNOT_GENERATE;
  }
  return TALUS_INTERNAL;
}

ConversionResult<client::Options> options_of(const talus_connect_options& options) {
  if (options.host == nullptr || *options.host == '\0') {
    return tl::unexpected<std::string>{"options.host is empty; give a name or an address"};
  }
  if (options.port > std::numeric_limits<std::uint16_t>::max()) {
    return tl::unexpected{"options.port is " + std::to_string(options.port) + "; the highest is 65535"};
  }
  if ((options.flags & ~std::uint32_t{TALUS_TLS | TALUS_TLS_NO_VERIFY | TALUS_WEBSOCKET}) != 0) {
    return tl::unexpected{"options.flags is " + std::to_string(options.flags) +
                          "; it may hold TALUS_TLS, TALUS_TLS_NO_VERIFY and TALUS_WEBSOCKET"};
  }
  if (options.generate > TALUS_GENERATE_ALWAYS) {
    return tl::unexpected{"options.generate is " + std::to_string(options.generate) +
                          "; it may be TALUS_GENERATE_NEVER, TALUS_GENERATE_AUTO or TALUS_GENERATE_ALWAYS"};
  }
  constexpr std::uint32_t kMaxThreads = 256;
  if (options.generate_threads > kMaxThreads) {
    return tl::unexpected{"options.generate_threads is " + std::to_string(options.generate_threads) +
                          "; the highest is " + std::to_string(kMaxThreads)};
  }
  client::Options own;
  own.generate = static_cast<client::Generate>(options.generate);
  own.token = text_of(options.token);
  own.client_name = text_of(options.client_name);
  if (own.client_name.empty()) own.client_name = "libtalus";
  set_unless_zero(own.window_bytes, options.window_bytes);
  set_unless_zero(own.keep_bytes, options.keep_bytes);
  own.tls.on = (options.flags & TALUS_TLS) != 0;
  own.tls.verify = (options.flags & TALUS_TLS_NO_VERIFY) == 0;
  own.tls.ca_file = text_of(options.tls_ca_file);
  own.tls.server_name = text_of(options.tls_server_name);
  own.websocket.on = (options.flags & TALUS_WEBSOCKET) != 0;
  set_unless_zero(own.connect_timeout, options.connect_timeout_ms);
  set_unless_zero(own.handshake_timeout, options.handshake_timeout_ms);
  set_unless_zero(own.ping_interval, options.ping_interval_ms);
  set_unless_zero(own.silence_timeout, options.silence_timeout_ms);
  own.reconnect.max_attempts =
      static_cast<int>(std::min<std::uint32_t>(options.reconnect_attempts, std::numeric_limits<int>::max()));
  set_unless_zero(own.reconnect.first_delay, options.reconnect_first_delay_ms);
  set_unless_zero(own.reconnect.max_delay, options.reconnect_max_delay_ms);
  std::string_view more = options.more_servers == nullptr ? std::string_view{} : options.more_servers;
  while (!more.empty()) {
    const std::size_t comma = std::min(more.find(','), more.size());
    const auto server = protocol::parse_endpoint(more.substr(0, comma));
    if (!server || comma + 1 == more.size()) {
      return tl::unexpected{"options.more_servers is \"" + std::string{options.more_servers} +
                            "\"; give HOST:PORT, or several with commas between"};
    }
    own.more_servers.push_back({server->host, std::to_string(server->port)});
    more.remove_prefix(std::min(comma + 1, more.size()));
  }
  return own;
}

ConversionResult<client::View> view_of(const talus_view& view) {
  if ((view.flags & ~std::uint32_t{TALUS_VIEW_HORIZON}) != 0) {
    return tl::unexpected{"view.flags is " + std::to_string(view.flags) + "; it may hold TALUS_VIEW_HORIZON"};
  }
  const glm::vec3 direction{view.direction_x, view.direction_y, view.direction_z};
  if (!std::isfinite(direction.x) || !std::isfinite(direction.y) || !std::isfinite(direction.z)) {
    return tl::unexpected<std::string>{
        "view.direction is not finite; give any length, or 0 for no preference"};
  }
  if (view.reserved != 0) return tl::unexpected<std::string>{"view.reserved is not 0"};
  client::View own;
  own.centre = {view.centre_x, view.centre_y, view.centre_z};
  own.direction = direction;
  own.horizontal_radius = view.horizontal_radius;
  own.vertical_radius = view.vertical_radius;
  own.horizon = (view.flags & TALUS_VIEW_HORIZON) != 0;
  int level = 0;
  for (const std::uint16_t radius : view.ring_radius) {
    ++level;
    if (radius != 0) own.rings.push_back({Lod::of(level), radius});
  }
  return own;
}

ConversionResult<client::Edit> edit_of(const talus_edit& edit) {
  auto own = plain_edit_of(edit);
  if (!own) return tl::unexpected{std::move(own.error())};
  return client::Edit{*std::move(own), text_of(edit.subject)};
}

talus_world world_of(const client::WorldInfo& world) {
  talus_world own{};
  own.material_count = static_cast<std::uint32_t>(world.materials.size());
  own.fingerprint_low = world.fingerprint.low;
  own.fingerprint_high = world.fingerprint.high;
  own.store_low = world.store_id.low;
  own.store_high = world.store_id.high;
  own.min_y = world.min_y;
  own.max_y = world.max_y;
  own.spawn_x = world.spawn.x;
  own.spawn_y = world.spawn.y;
  own.spawn_z = world.spawn.z;
  own.server = world.server.c_str();
  own.look_count = static_cast<std::uint32_t>(world.looks.size());
  own.field_count = static_cast<std::uint32_t>(world.fields.size());
  own.max_horizontal_radius = world.limits.view_horizontal_radius;
  own.max_vertical_radius = world.limits.view_vertical_radius;
  own.max_view_chunks = world.limits.view_chunks;
  own.max_columns = world.limits.heights_per_request;
  own.has_horizon = world.limits.view_horizon ? 1 : 0;
  return own;
}

talus_material material_of(const client::Material& material) {
  talus_material own{};
  own.id = to_integer(material.id);
  own.colour = material.colour;
  own.phase = static_cast<std::uint32_t>(material.phase);
  own.name = material.name.c_str();
  return own;
}

}  // namespace talus::c_api
