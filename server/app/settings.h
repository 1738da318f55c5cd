// Derives each module's settings from the configuration.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/edit_database.h>
#include <talus/terrain/world.h>

#include "chunks/chunks.h"
#include "chunks/column_cache/column_cache.h"
#include "chunks/generation/generator_memory.h"
#include "chunks/generation/patch_size.h"
#include "config/config.h"
#include "edits/edit_state.h"
#include "limits/memory/memory_budget.h"
#include "limits/rates/rates.h"
#include "net/admission.h"
#include "net/departures.h"
#include "net/handshaker.h"
#include "net/runner_context.h"
#include "player/session/published_world.h"
#include "player/session/session_limits.h"
#include "runtime/clock.h"
#include "web/web_context.h"

namespace talus::server {

/// Threads that serve sockets, and threads that generate; chosen for the machine if configured as 0.
[[nodiscard]] std::size_t io_threads(const Config& config);
[[nodiscard]] std::size_t generator_threads(const Config& config);

/// Maximum number of tiles of 32 x 32 columns that one GetHeights may touch, so that it takes at most a
/// second of a thread, or one tile. On eroded land a tile costs its terrain with halo, measured as
/// `tile_time`; heights with talus cost a quarter of that.
[[nodiscard]] std::uint64_t height_tiles_per_request(const terrain::World& world,
                                                     std::chrono::nanoseconds tile_time);

[[nodiscard]] EditRules edit_rules(const Config& config, VoxelPos spawn);
[[nodiscard]] SessionLimits session_limits(const Config& config, const terrain::World& world, VoxelPos spawn,
                                           std::chrono::nanoseconds tile_time);
/// Size of the files that the server serves from memory; each may be null.
[[nodiscard]] std::uint64_t files_bytes(const web::Site* site, const PublishedWorld* published);
/// `site_bytes`, here and below: files_bytes().
[[nodiscard]] RateLimits rate_limits(const Config& config, std::uint64_t site_bytes = 0);
[[nodiscard]] RunnerLimits runner_limits(const Config& config);
[[nodiscard]] HandshakeSettings handshake_settings(const Config& config);
/// For the HTTP port.
[[nodiscard]] HandshakeSettings web_handshake_settings(const Config& config);
[[nodiscard]] BalanceSettings balance_settings(const Config& config);
/// Line for HTTP clients of the port for game clients: where the viewer is.
[[nodiscard]] std::string http_place(const Config& config);
[[nodiscard]] web::WebSettings web_settings(const Config& config);
/// Timeouts of HTTP connections.
[[nodiscard]] http::Service web_service(const Config& config, const Clock& clock, Logger log);
[[nodiscard]] Admission::Limits admission_limits(const Config& config, std::uint64_t site_bytes = 0);
/// Minimum limits.memory_bytes other than 0, with few threads. The program and the generators' largest share
/// stay below the half at which connections are accepted again, so the server recovers from any load.
inline constexpr std::uint64_t kMinMemoryBytes = MemoryBudget::kProgramBytes * 3;
static_assert(MemoryBudget::kProgramBytes + kMinMemoryBytes / GeneratorMemory::kLargestShare <
              kMinMemoryBytes / 2);
/// With the configured threads.
[[nodiscard]] std::uint64_t min_memory_bytes(const Config& config);
/// Fails if limits.memory_bytes is less. An error is one line.
[[nodiscard]] tl::expected<void, std::string> check_memory(const Config& config,
                                                           std::uint64_t site_bytes = 0);

/// Memory limits of edits within limits.memory_bytes. With the program, the site and the generators' largest
/// share they stay below the half at which connections are accepted again, except editors, which change
/// within a day, and unflushed data (four times `dirty_bytes` and a batch). Including these and RocksDB they
/// stay below the 5/8 at which a server without sessions accepts connections.
[[nodiscard]] EditStateSettings edit_state_settings(const Config& config, std::uint64_t site_bytes = 0);
/// RocksDB's memory for the edit store. With edit_state_settings() it also stays below that half.
[[nodiscard]] store::StoreMemory store_memory(const Config& config, std::uint64_t site_bytes = 0);
/// Fails (one line) if a stored index of `index_bytes` exceeds that half, so that the server might refuse
/// every client for ever. A smaller index is served, but cannot grow beyond its limit.
[[nodiscard]] tl::expected<void, std::string> check_index_memory(const Config& config,
                                                                 std::uint64_t index_bytes,
                                                                 std::uint64_t site_bytes = 0);

/// Location and limits of the disk cache of expensive columns; nullopt if disabled.
[[nodiscard]] std::optional<ColumnCacheSettings> column_cache_settings(const Config& config,
                                                                       ContentHash fingerprint);

/// File in which pregen stores its progress; it is deleted together with the columns.
[[nodiscard]] inline std::filesystem::path pregen_file(const ColumnCacheSettings& columns) {
  return columns.path / "pregen";
}

/// Memory for ground that patches share; 0 if caching it would not pay.
[[nodiscard]] std::size_t ground_bytes(const Config& config, const terrain::World& world);

/// Uses the configured patch_tiles, or `patch` if it is not configured.
[[nodiscard]] GenerationSettings generation_settings(const Config& config, const terrain::World& world,
                                                     const PatchSize& patch);

/// Measures what the world's terrain costs on this machine.
[[nodiscard]] PatchSize measured_patch_size(const Config& config, const terrain::World& world,
                                            const Clock& clock);
/// Log line on the cost of terrain, with advice if it is high.
[[nodiscard]] std::string describe(const PatchSize& size);

/// Number of files and sockets that a server with this configuration may hold at once.
[[nodiscard]] std::uint64_t descriptors_wanted(const Config& config);

}  // namespace talus::server
