// What each module needs of the configuration.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/edit_database.h>
#include <talus/terrain/world.h>

#include "chunks/column_cache/column_cache.h"
#include "chunks/generation/base_chunks.h"
#include "chunks/generation/generator_memory.h"
#include "chunks/generation/patch_size.h"
#include "config/config.h"
#include "edits/edit_state.h"
#include "limits/memory/memory_budget.h"
#include "limits/rates/rates.h"
#include "net/admission.h"
#include "net/departures.h"
#include "net/handshaker.h"
#include "net/session_runner.h"
#include "player/session/session_limits.h"
#include "runtime/clock.h"
#include "web/web_context.h"

namespace talus::server {

/// Threads that serve sockets, and threads that generate; from the machine where the configuration says 0.
[[nodiscard]] std::size_t io_threads(const Config& config);
[[nodiscard]] std::size_t generator_threads(const Config& config);

/// Tiles of 32 x 32 columns that one GetHeights may touch. Heights of eroded land cost a tile's terrain with
/// its halo for each, which was measured to take `tile_time`, and heights with talus a quarter of that: one
/// request takes a second of a thread, or one tile.
[[nodiscard]] std::uint64_t height_tiles_per_request(const terrain::World& world,
                                                     std::chrono::nanoseconds tile_time);

[[nodiscard]] EditRules edit_rules(const Config& config, VoxelPos spawn);
[[nodiscard]] SessionLimits session_limits(const Config& config, const terrain::World& world, VoxelPos spawn,
                                           std::chrono::nanoseconds tile_time);
/// `site_bytes`, here and below: files that the server keeps in memory to serve them.
[[nodiscard]] RateLimits rate_limits(const Config& config, std::uint64_t site_bytes = 0);
[[nodiscard]] RunnerLimits runner_limits(const Config& config);
[[nodiscard]] HandshakeSettings handshake_settings(const Config& config);
/// The same for the HTTP port.
[[nodiscard]] HandshakeSettings web_handshake_settings(const Config& config);
[[nodiscard]] BalanceSettings balance_settings(const Config& config);
[[nodiscard]] web::WebSettings web_settings(const Config& config);
/// Times of HTTP connections.
[[nodiscard]] http::Service web_service(const Config& config, const Clock& clock, Logger log);
[[nodiscard]] Admission::Limits admission_limits(const Config& config, std::uint64_t site_bytes = 0);
/// The least limits.memory_bytes but 0, with few threads. The program and the largest share of the generators
/// stay below the half at which connections are taken again: whatever a load took, the server opens again.
inline constexpr std::uint64_t kMinMemoryBytes = MemoryBudget::kProgramBytes * 3;
static_assert(MemoryBudget::kProgramBytes + kMinMemoryBytes / GeneratorMemory::kLargestShare <
              kMinMemoryBytes / 2);
/// With the threads that are configured.
[[nodiscard]] std::uint64_t min_memory_bytes(const Config& config);
/// An error, one line, where limits.memory_bytes is less.
[[nodiscard]] tl::expected<void, std::string> check_memory(const Config& config,
                                                           std::uint64_t site_bytes = 0);

/// What edits may take of limits.memory_bytes. With the program, the site and the largest share of the
/// generators they stay below the half at which connections are taken again; but for editors, who come and go
/// within a day, and what is not flushed, four times `dirty_bytes` and a batch, with which, and with
/// RocksDB's, they stay below the 5/8 at which a server without sessions takes them.
[[nodiscard]] EditStateSettings edit_state_settings(const Config& config, std::uint64_t site_bytes = 0);
/// What RocksDB may hold in memory of the store of edits. With what edit_state_settings() gives it stays
/// below that half, too.
[[nodiscard]] store::StoreMemory store_memory(const Config& config, std::uint64_t site_bytes = 0);
/// An error, one line, where an index of so many bytes, as a store has it, takes more than that, so that the
/// server might refuse every client for good. Below that it is served, and refuses to grow.
[[nodiscard]] tl::expected<void, std::string> check_index_memory(const Config& config,
                                                                 std::uint64_t index_bytes,
                                                                 std::uint64_t site_bytes = 0);

/// Where and how much is kept of columns that were dear to generate; none where nothing is.
[[nodiscard]] std::optional<ColumnCacheSettings> column_cache_settings(const Config& config,
                                                                       ContentHash fingerprint);

/// Where a pregen notes how far it is: beside the columns, and gone with them.
[[nodiscard]] inline std::filesystem::path pregen_file(const ColumnCacheSettings& columns) {
  return columns.path / "pregen";
}

/// What generators of the world keep of ground that patches share: nothing where that would not pay.
[[nodiscard]] std::size_t ground_bytes(const Config& config, const terrain::World& world);

/// `patch_tiles` as configured, or as chosen where the configuration leaves it open.
[[nodiscard]] GenerationSettings generation_settings(const Config& config, const terrain::World& world,
                                                     const PatchSize& patch);

/// Measures what the world's terrain costs on this machine.
[[nodiscard]] PatchSize measured_patch_size(const Config& config, const terrain::World& world,
                                            const Clock& clock);
/// For the log: what terrain costs, and what to change where that is much.
[[nodiscard]] std::string describe(const PatchSize& size);

/// Files and sockets that a server so configured may hold at once.
[[nodiscard]] std::uint64_t descriptors_wanted(const Config& config);

}  // namespace talus::server
