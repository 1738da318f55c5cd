// What a session says, frame by frame.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <talus/protocol/frame.h>
#include <talus/protocol/limits.h>
#include <talus/protocol/message.h>

#include "player/view/output.h"

namespace talus::server {

[[nodiscard]] inline std::vector<protocol::Frame> cut(std::span<const std::byte> output) {
  std::vector<protocol::Frame> frames;
  protocol::FrameReader reader{protocol::kServerFrameBytes};
  while (!output.empty()) {
    output = output.subspan(reader.feed(output).value());
    if (!reader.has_frame()) continue;
    frames.emplace_back(reader.frame().begin(), reader.frame().end());
    reader.pop();
  }
  return frames;
}

/// All of a write's bytes.
[[nodiscard]] inline std::vector<std::byte> flat(const Output& output) {
  std::vector<std::byte> bytes;
  for (const auto piece : output.pieces()) bytes.insert(bytes.end(), piece.begin(), piece.end());
  return bytes;
}

[[nodiscard]] inline std::vector<protocol::Frame> cut(const Output& output) {
  return cut(flat(output));
}

}  // namespace talus::server
