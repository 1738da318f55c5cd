// What a client may change, and what it is told.
#pragma once

#include <cstdint>
#include <string>

#include <talus/edits/edit.h>

namespace talus::client {

using edits::Fill;
using edits::Paste;
using edits::VoxelWrite;

/// Guards, writes, fills and a paste, as core/edits has them: where all guards hold, all of it happens, on
/// whatever chunks it reaches, or nothing does.
struct Edit : edits::Edit {
  /// Of a game server whose token has the right "gateway": the player for whom it edits, at most 256 bytes,
  /// whom the world's history then names. Empty: the token's own subject.
  std::string subject;
};

/// The edit happened, and is stored.
struct EditDone {
  std::uint64_t revision = 0;  // of the world after it
  std::uint32_t changed = 0;   // voxels; 0: all was so before
};

}  // namespace talus::client
