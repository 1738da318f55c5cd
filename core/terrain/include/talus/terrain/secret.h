// Secret ore: drawn by a key that only the server has, and shown only where land or edits expose it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

class World;

inline constexpr std::size_t kSecretKeyBytes = 32;

/// The first half draws the ore, the second makes the world's fingerprint.
struct SecretKey {
  std::array<std::uint64_t, kSecretKeyBytes / 8> words{};  // little-endian
};

/// The secret ore that a world's chunks have. Levels 1 to 6 have none: a coarse column does not know whether
/// its sample is exposed at level 0.
enum class SecretView : std::uint8_t {
  exposed,     // voxels with a face neighbour that is not ground: air, water, the air of a cave, an object
  everything,  // for tests
};

/// The voxels of a chunk of level 0 that show rock in `shown`, the chunk of a world with secret veins, and
/// are ore, by ascending index. Empty for other worlds. As long as no edit changes them or a voxel beside
/// them, the shown world does not tell them from rock.
[[nodiscard]] std::vector<Override> hidden_ore(const World& world, ChunkCoord chunk, const Chunk& shown);

}  // namespace talus::terrain
