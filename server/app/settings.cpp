#include "app/settings.h"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include <talus/edits/edit.h>
#include <talus/map/tile_painting.h>
#include <talus/protocol/limits.h>
#include <talus/voxel/coords.h>

#include "admin/admin_server.h"
#include "net/descriptors.h"

namespace talus::server {
namespace {

std::size_t threads_or_cores(std::uint64_t threads) {
  return threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

std::size_t io_threads(const Config& config) {
  return threads_or_cores(config.threads.io);
}

std::size_t generator_threads(const Config& config) {
  return threads_or_cores(config.threads.generator);
}

std::uint64_t height_tiles_per_request(const terrain::World& world, std::chrono::nanoseconds tile_time) {
  constexpr std::chrono::nanoseconds kLongest = std::chrono::seconds{1};
  // With talus a column needs the ground around it: measured as under a quarter of a tile with halo.
  const bool erodes = world.spec().method == terrain::Method::erosion;
  if (!erodes && !world.spec().talus) return protocol::kMaxHeightsPerRequest;
  if (!erodes) tile_time /= 4;
  const auto tiles = kLongest / std::max(tile_time, std::chrono::nanoseconds{1});
  return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(tiles), 1, protocol::kMaxHeightsPerRequest);
}

EditRules edit_rules(const Config& config, VoxelPos spawn) {
  EditRules rules{config.edits.protected_boxes, config.edits.gateway == "required"};
  if (const auto around = static_cast<std::int64_t>(config.edits.protect_spawn); around > 0) {
    rules.protected_boxes.add(
        Box::of_columns(spawn.x - around, spawn.z - around, spawn.x + around, spawn.z + around));
  }
  return rules;
}

SessionLimits session_limits(const Config& config, const terrain::World& world, VoxelPos spawn,
                             std::chrono::nanoseconds tile_time) {
  const Limits& limits = config.limits;
  return {.frame_bytes = static_cast<std::uint32_t>(limits.frame_bytes),
          .requests_in_flight = static_cast<std::uint32_t>(limits.requests_in_flight),
          .heights_per_request = static_cast<std::uint32_t>(limits.heights_per_request),
          .height_tiles_per_request = height_tiles_per_request(world, tile_time),
          .view_horizontal_radius = static_cast<std::uint16_t>(limits.view_horizontal_radius),
          .view_vertical_radius = static_cast<std::uint16_t>(limits.view_vertical_radius),
          .view_chunks = static_cast<std::uint32_t>(limits.view_chunks),
          .window_bytes = limits.window_bytes,
          .queued_bytes = limits.queued_bytes_per_session,
          .idle_timeout = limits.idle_timeout,
          .edits = edit_rules(config, spawn)};
}

std::uint64_t files_bytes(const web::Site* site, const PublishedWorld* published) {
  return (site == nullptr ? 0 : site->bytes()) + (published == nullptr ? 0 : published->bytes());
}

namespace {

/// New editors per hour. A configured rate ignores the budget, because many players may share one address.
std::uint64_t editors_of_address(const Config& config, std::uint64_t site_bytes, std::uint64_t hours) {
  if (config.rates.address_editors) return *config.rates.address_editors;
  constexpr std::uint64_t kMaxEditorsPerHour = 512;
  constexpr std::uint64_t kShare = 4;
  constexpr std::uint64_t kFew = 16;  // 0 would mean unlimited
  const std::uint64_t have_room = std::min<std::uint64_t>(
      edit_state_settings(config, site_bytes).editor_bytes / EditState::kUsedEditorBytes, edits::kMaxEditors);
  return std::min(kMaxEditorsPerHour, std::max(have_room / kShare / hours, kFew));
}

}  // namespace

RateLimits rate_limits(const Config& all, std::uint64_t site_bytes) {
  const Rates& config = all.rates;
  const auto rate = [&](std::uint64_t per_second) { return Rate::with_burst_of(per_second, config.burst); };
  // However short the burst, one edit of maximum size must fit.
  const auto voxels = [&](std::uint64_t per_second) {
    Rate of_voxels = rate(per_second);
    if (of_voxels.limited()) of_voxels.burst = std::max<std::uint64_t>(of_voxels.burst, edits::kMaxVoxels);
    return of_voxels;
  };
  constexpr std::uint64_t kSavedUp = std::uint64_t{8} * 3'600;
  // An address with a full burst needs at least a day to fill the index, and by default then has a quarter of
  // the editors, however few fit.
  constexpr std::uint64_t kHoursToFill = 32;
  const std::uint64_t editors_an_hour = editors_of_address(all, site_bytes, kHoursToFill);
  const Rate editors{editors_an_hour, editors_an_hour * kSavedUp};
  constexpr std::uint64_t kFewNewChunks = 16;  // 0 would mean unlimited
  const std::uint64_t fitting =
      edit_state_settings(all, site_bytes).index_bytes / ChunkIndex::kMaxBytesEach / kHoursToFill;
  const std::uint64_t an_hour = std::min(config.address_new_chunks, std::max(fitting, kFewNewChunks));
  Rate new_chunks{an_hour, an_hour * kSavedUp};
  // One edit of maximum size must fit, with the neighbouring chunks into which loose material slides.
  if (new_chunks.limited()) {
    new_chunks.burst = std::max<std::uint64_t>(new_chunks.burst, 2 * edits::kMaxChunks * kNewChunkTokens);
  }
  return {{rate(config.session_chunks), rate(config.session_bytes), rate(config.session_requests),
           voxels(config.session_voxels)},
          {rate(config.address_chunks), rate(config.address_bytes), rate(config.address_requests),
           voxels(config.address_voxels), editors, new_chunks},
          config.burst,
          rate(config.gateway_requests),
          voxels(config.gateway_voxels)};
}

RunnerLimits runner_limits(const Config& config) {
  const Limits& limits = config.limits;
  return {static_cast<std::uint32_t>(limits.frame_bytes),
          limits.queued_bytes_per_session,
          {limits.handshake_timeout, limits.idle_timeout, limits.write_timeout}};
}

HandshakeSettings handshake_settings(const Config& config) {
  const Limits& limits = config.limits;
  return {.per_address_per_second = limits.handshakes_per_address_per_second,
          .per_address_burst = limits.handshakes_per_address_burst,
          .max_in_flight = limits.handshakes_in_flight,
          .timeout = limits.handshake_timeout,
          .proxies = config.proxies,
          .silence = std::max(limits.idle_timeout, limits.write_timeout)};
}

HandshakeSettings web_handshake_settings(const Config& config) {
  HandshakeSettings settings = handshake_settings(config);
  settings.header_optional = true;
  return settings;
}

BalanceSettings balance_settings(const Config& config) {
  return {config.balance.per_second, config.balance.above_percent, config.balance.session};
}

std::string http_place(const Config& config) {
  constexpr std::string_view kHere = "this port is for game clients, not for HTTP";
  if (!config.http.listen) {
    return fmt::format("{}; talusd serves the viewer with --http HOST:PORT --web DIR", kHere);
  }
  const bool tls = config.http.tls && !config.tls.certificate.empty();
  // Port 0 lets the system choose.
  const std::uint16_t number = config.http.listen->port;
  const std::string port = number == 0 ? "PORT, which talusd's log names" : fmt::format("{}/", number);
  return fmt::format("{}; {} at {}://HOST:{}", kHere, config.http.web.empty() ? "HTTP is" : "the viewer is",
                     tls ? "https" : "http", port);
}

web::WebSettings web_settings(const Config& config) {
  AllowedOrigins origins = config.http.origins;
  // Behind a proxy such an address does not mean that the pages are a developer's.
  const bool alone = config.http.listen && config.proxies.empty();
  if (alone && is_loopback(config.http.listen->host)) origins.allow_loopback();
  return {config.http.public_chunks, std::move(origins), config.proxies, config.http.log_every};
}

http::Service web_service(const Config& config, const Clock& clock, Logger log) {
  const Limits& limits = config.limits;
  return {clock, std::move(log), {}, limits.idle_timeout, limits.handshake_timeout, limits.write_timeout};
}

Admission::Limits admission_limits(const Config& config, std::uint64_t site_bytes) {
  return {config.limits.connections, config.limits.connections_per_address, config.rates.burst,
          rate_limits(config, site_bytes).address};
}

std::uint64_t min_memory_bytes(const Config& config) {
  return MemoryBudget::program_bytes(io_threads(config) + generator_threads(config)) * 3;
}

tl::expected<void, std::string> check_memory(const Config& config, std::uint64_t site_bytes) {
  const std::uint64_t bytes = config.limits.memory_bytes;
  const std::uint64_t least = min_memory_bytes(config) + 3 * site_bytes;
  if (bytes == 0 || bytes >= least) return {};
  return tl::make_unexpected(fmt::format(
      "limits.memory_bytes: {} is too little: after one load the server might refuse every client; give at "
      "least {}, or 0 for no limit",
      bytes, least));
}

namespace {

constexpr std::uint64_t kMaxRecentBytes = EditStateSettings{}.recent_bytes;

/// Permanent memory of edits within the budget.
std::uint64_t room_for_edits(const Config& config, std::uint64_t site_bytes) {
  const std::uint64_t limit = config.limits.memory_bytes;
  const std::uint64_t others = MemoryBudget::program_bytes(io_threads(config) + generator_threads(config)) +
                               site_bytes + limit / GeneratorMemory::kLargestShare;
  return limit / 2 - std::min(limit / 2, others);
}

/// Divides the room left by recent changes; the index may use three quarters of it.
store::StoreMemory store_memory_of(std::uint64_t left) {
  constexpr std::uint64_t kMinBytes = std::uint64_t{128} << 10U;  // for each
  store::StoreMemory memory;
  memory.write_buffer_bytes = std::clamp<std::uint64_t>(left / 16, kMinBytes, memory.write_buffer_bytes);
  memory.block_cache_bytes = std::clamp<std::uint64_t>(left / 64, kMinBytes, memory.block_cache_bytes);
  return memory;
}

}  // namespace

EditStateSettings edit_state_settings(const Config& config, std::uint64_t site_bytes) {
  EditStateSettings settings;
  const std::uint64_t limit = config.limits.memory_bytes;
  if (limit == 0) return settings;
  settings.recent_bytes = std::min<std::size_t>(settings.recent_bytes, limit / 64);
  settings.cache_bytes = std::min<std::size_t>(settings.cache_bytes, limit / 8);
  settings.editor_bytes = std::min<std::size_t>(settings.editor_bytes, limit / 12);
  const std::uint64_t room = room_for_edits(config, site_bytes);
  const std::uint64_t for_index = room - std::min<std::uint64_t>(room, settings.recent_bytes);
  // When the index is full, existing sessions need part of the rest before new ones are accepted.
  settings.index_bytes = std::min<std::size_t>({settings.index_bytes, limit / 4, for_index / 4 * 3});
  // At four times this size edits wait for the disk; another batch may come on top.
  constexpr std::uint64_t kTimes = 5;
  const std::uint64_t others = limit / 2 - room + settings.recent_bytes + settings.index_bytes +
                               store_memory_of(for_index).max_bytes() + settings.editor_bytes;
  const std::uint64_t most = limit / 8 * 5;
  settings.dirty_bytes =
      std::min<std::size_t>({settings.dirty_bytes, limit / 64, (most - std::min(most, others)) / kTimes});
  return settings;
}

store::StoreMemory store_memory(const Config& config, std::uint64_t site_bytes) {
  if (config.limits.memory_bytes == 0) return {};
  const std::uint64_t room = room_for_edits(config, site_bytes);
  return store_memory_of(room -
                         std::min<std::uint64_t>(room, edit_state_settings(config, site_bytes).recent_bytes));
}

tl::expected<void, std::string> check_index_memory(const Config& config, std::uint64_t index_bytes,
                                                   std::uint64_t site_bytes) {
  constexpr std::uint64_t kMebibyte = 1U << 20U;
  const std::uint64_t limit = config.limits.memory_bytes;
  const EditStateSettings settings = edit_state_settings(config, site_bytes);
  if (limit == 0 || index_bytes <= settings.index_bytes) return {};
  if (index_bytes + settings.recent_bytes + store_memory(config, site_bytes).max_bytes() <
      room_for_edits(config, site_bytes))
    return {};
  // The room is three eighths of the budget less the program; the index may use three quarters of it.
  Config enough = config;
  enough.limits.memory_bytes = (limit / kMebibyte + 1) * kMebibyte;
  while (index_bytes + kMaxRecentBytes + store_memory(enough, site_bytes).max_bytes() >=
         room_for_edits(enough, site_bytes)) {
    enough.limits.memory_bytes += kMebibyte;
  }
  return tl::make_unexpected(fmt::format(
      "limits.memory_bytes: {} is too little for the edits in {}, whose index of edited chunks takes {} "
      "bytes: the server might refuse every client; give at least {}, or 0 for no limit",
      limit, config.data.string(), index_bytes, enough.limits.memory_bytes));
}

std::optional<ColumnCacheSettings> column_cache_settings(const Config& config, ContentHash fingerprint) {
  if (config.data.empty() || config.cache.disk_bytes == 0) return std::nullopt;
  constexpr std::size_t kMaxMemory = std::size_t{24} << 20U;
  constexpr std::size_t kMinMemory = std::size_t{3} << 19U;
  constexpr std::uint64_t kShare = 64;  // of the budget
  const std::uint64_t limit = config.limits.memory_bytes;
  const std::uint64_t memory = limit == 0 ? kMaxMemory : limit / kShare;
  return ColumnCacheSettings{
      .path = config.data / "columns",
      .fingerprint = fingerprint,
      .bytes = config.cache.disk_bytes,
      .memory_bytes = std::clamp<std::size_t>(static_cast<std::size_t>(memory), kMinMemory, kMaxMemory)};
}

std::size_t ground_bytes(const Config& config, const terrain::World& world) {
  if (!world.spec().surface.regions) return 0;
  constexpr std::size_t kGroundBytes = std::size_t{8} << 20;  // a View's edge of 16 chunks all around, twice
  constexpr std::uint64_t kLargestShare = 64;                 // of the budget
  if (config.limits.memory_bytes == 0) return kGroundBytes;
  return std::min<std::uint64_t>(kGroundBytes, config.limits.memory_bytes / kLargestShare);
}

GenerationSettings generation_settings(const Config& config, const terrain::World& world,
                                       const PatchSize& patch) {
  // Maps are requested only over HTTP.
  constexpr std::uint64_t kMapsShare = 8;
  // Share for chunks merged with edits, if edits are stored.
  constexpr std::uint64_t kMergedShare = 8;
  constexpr std::size_t kMapBytesAColumn =
      160;  // of a map being painted: its stacks and the surface to be lit
  const bool maps = config.http.listen.has_value();
  const std::size_t map_bytes = maps ? map::TilePainting::kColumnsAtOnce * kMapBytesAColumn : 0;
  return {.threads = generator_threads(config),
          .patch_tiles = patch.tiles,
          .queue_chunks = config.generation.queue_chunks,
          .chunk_cache_bytes = config.cache.chunk_bytes,
          .patch_cache_bytes = config.cache.patch_bytes,
          .piece_bytes = std::max(patch.bytes_at_work(), map_bytes),
          .ground_bytes = ground_bytes(config, world),
          .map_cache_bytes = maps ? config.cache.chunk_bytes / kMapsShare : 0,
          .merged_cache_bytes = config.data.empty() ? 0 : config.cache.chunk_bytes / kMergedShare};
}

PatchSize measured_patch_size(const Config& config, const terrain::World& world, const Clock& clock) {
  const TileCost tile = measure_tile(world, clock);
  const auto tiles = static_cast<int>(config.generation.patch_tiles);
  PatchSize size = tiles == 0 ? choose_patch_size(tile.terrain, world.halo())
                              : patch_size(tiles, tile.terrain, world.halo());
  size.chunk_time = tile.chunk;
  size.tile_bytes = tile.bytes;
  const std::uint64_t limit = config.limits.memory_bytes;
  if (tiles != 0 || limit == 0) return size;
  const std::uint64_t share = limit / GeneratorMemory::kLargestShare - ground_bytes(config, world);
  return reduced_to(share / generator_threads(config), size);
}

std::string describe(const PatchSize& size) {
  std::string text = fmt::format(
      "terrain takes {} ns a column here, {:.1f} ms a patch of {} x {} tiles, {} us a chunk",
      size.ns_a_column(), std::chrono::duration<double, std::milli>{size.patch_time}.count(), size.tiles,
      size.tiles, std::chrono::duration_cast<std::chrono::microseconds>(size.chunk_time).count());
  if (size.reduced) text += ", as limits.memory_bytes has no room for generators that make larger ones";
  if (!size.expensive && !size.chunks_expensive()) return text;
  text += ": this world is expensive, and players wait for it; ";
  if (size.expensive) text += "fewer erosion_steps make it cheaper, ";
  if (size.chunks_expensive()) text += "fewer or smaller [[object]]s make its chunks cheaper, ";
  return text + "more threads.generator and larger caches serve more players";
}

std::uint64_t descriptors_wanted(const Config& config) {
  const std::uint64_t of_operators = config.admin ? AdminServer::kMaxConnections : 0;
  // A connection that waits for its PROXY header or its TLS thread is not counted by limits.connections, but
  // has a socket.
  const bool waits = !config.proxies.empty() || config.tls.wanted();
  const std::uint64_t of_handshakes = waits ? config.limits.handshakes_in_flight : 0;
  return descriptors_needed(config.limits.connections + of_handshakes + of_operators, io_threads(config) + 1);
}

}  // namespace talus::server
