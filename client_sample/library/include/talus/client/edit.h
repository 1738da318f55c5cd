// Edits that a client sends, and their result.
#pragma once

#include <cstdint>
#include <string>

#include <talus/edits/edit.h>

namespace talus::client {

using edits::Fill;
using edits::Paste;
using edits::VoxelWrite;

/// Guards, writes, fills and a paste, as in core/edits. If all guards hold, the whole edit is applied, in all
/// chunks that it touches; otherwise nothing is.
struct Edit : edits::Edit {
  /// For a game server whose token has the right "gateway": the player for whom it edits, at most 256 bytes,
  /// recorded in the world's history. Empty: the token's own subject.
  std::string subject;
};

/// The edit was applied and is stored.
struct EditDone {
  std::uint64_t revision = 0;  // world revision after the edit
  std::uint32_t changed = 0;   // voxels; 0: they already had these materials
};

}  // namespace talus::client
