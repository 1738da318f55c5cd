// Turns an Edit of the wire into one that can be logged, or says why it can not. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/edit.h>
#include <talus/protocol/message.h>

#include "player/session/rejection.h"

namespace talus::server {

struct CheckedEdit {
  edits::Edit edit;
  std::uint64_t voxels = 0;        // that it names
  std::size_t bytes = 0;           // of memory until it is answered
  std::size_t prepared_bytes = 0;  // beside those while it is the session's next: it waits for its base
  std::string subject{};           // for whom a game server edits; empty: for the session itself
  bool settles = true;             // what is loose around it may slide, where anything does
};

/// Costs no more than the message is long, and one chunk's decoding: what an edit reaches, and whether its
/// materials are the world's, is asked where it is prepared. A Rejection of code malformed ends the
/// connection. `settles`: it takes memory for what may slide, too.
[[nodiscard]] tl::expected<CheckedEdit, Rejection> check_edit(const wire::Edit& edit, bool settles = false);

}  // namespace talus::server
