// Views, and what they want.
#pragma once

#include <vector>

#include "player/view/view_stream.h"

namespace talus::server {

/// The View's chunks, most wanted first.
[[nodiscard]] inline std::vector<ChunkKey> chunks_in_view(const View& view) {
  ViewStream stream;
  stream.replace(AreaOfInterest{view});
  std::vector<ChunkKey> keys;
  while (const auto key = stream.nearest()) {
    keys.push_back(*key);
    stream.start(*key);
  }
  return keys;
}

}  // namespace talus::server
