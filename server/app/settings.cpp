#include "app/settings.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <talus/protocol/limits.h>
#include <talus/voxel/coords.h>

#include "admin/admin_server.h"
#include "net/descriptors.h"

namespace talus::server {
namespace {

std::chrono::milliseconds milliseconds_of(std::uint64_t count) {
  return std::chrono::milliseconds{static_cast<std::chrono::milliseconds::rep>(count)};
}

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

std::uint64_t height_tiles_per_request(const terrain::World& world) {
  constexpr std::uint64_t kColumnSteps = 100'000'000;
  if (world.spec().method != terrain::Method::erosion) return protocol::kMaxHeightsPerRequest;
  const auto side = static_cast<std::uint64_t>(kChunkSize + 2 * world.halo());
  const std::uint64_t tile = side * side * static_cast<std::uint64_t>(world.spec().erosion_steps);
  return std::max<std::uint64_t>(1, kColumnSteps / tile);
}

SessionLimits session_limits(const Config& config, const terrain::World& world) {
  SessionLimits limits = config.limits;
  limits.height_tiles_per_request = height_tiles_per_request(world);
  return limits;
}

RunnerLimits runner_limits(const Config& config) {
  const Limits& limits = config.limits;
  return {static_cast<std::uint32_t>(limits.frame_bytes), limits.queued_bytes_per_session,
          SessionTimeouts{milliseconds_of(limits.handshake_timeout_ms), milliseconds_of(limits.idle_timeout_ms),
                          milliseconds_of(limits.write_timeout_ms)}};
}

HandshakeSettings handshake_settings(const Config& config) {
  const Limits& limits = config.limits;
  return {limits.handshakes_per_address_per_second, limits.handshakes_per_address_burst,
          limits.handshakes_under_way, milliseconds_of(limits.handshake_timeout_ms), config.proxies};
}

ServiceSettings generation_settings(const Config& config) {
  return {generator_threads(config), static_cast<int>(config.generation.patch_tiles),
          config.generation.queue_chunks, config.cache.chunk_bytes, config.cache.patch_bytes};
}

std::uint64_t descriptors_wanted(const Config& config) {
  const std::uint64_t of_operators =
      config.admin ? AdminServer::kMaxConnections + AdminServer::kReservedDescriptors : 0;
  // A connection whose PROXY header has not come is not among limits.connections, and has a socket.
  const std::uint64_t of_handshakes = config.proxies.empty() ? 0 : config.limits.handshakes_under_way;
  return descriptors_needed(config.limits.connections + of_handshakes + of_operators, io_threads(config) + 1);
}

}  // namespace talus::server
