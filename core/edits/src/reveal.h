// Reveals secret voxels that an edit exposes. Private to core/edits.
#pragma once

#include <vector>

#include <talus/edits/evaluate.h>

namespace talus::edits {

/// Adds to `changes`, an edit's on the state `overrides`, the secret voxels that are exposed after it: as
/// generated, with a face to a see-through override. REQUIRES: `changes` has no unchanged voxels, by
/// ascending chunk and index. Afterwards a voxel that was revealed before may be unchanged.
void reveal(const SecretVoxels& secrets, const OverrideSource& overrides, std::vector<ChunkChanges>& changes);

}  // namespace talus::edits
