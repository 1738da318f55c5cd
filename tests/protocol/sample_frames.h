// One frame of every kind of message, with every field set.
#pragma once

#include <vector>

#include <talus/protocol/message.h>

namespace talus::protocol::testing {

struct Sample {
  wire::Body kind;
  Frame frame;
};

/// In the order of the union Body.
[[nodiscard]] std::vector<Sample> sample_frames();

/// The frames whose bytes golden_test.cpp freezes.
[[nodiscard]] Frame sample_hello();
[[nodiscard]] Frame sample_view(bool newer_fields);
[[nodiscard]] Frame sample_chunk();

}  // namespace talus::protocol::testing
