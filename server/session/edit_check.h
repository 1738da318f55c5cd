// Turns an Edit of the wire into one that can be logged, or says why it can not. Pure.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/edit.h>
#include <talus/protocol/message.h>

#include "session/rejection.h"

namespace talus::server {

/// An edit, and how many voxels it names: what the rates count.
struct CheckedEdit {
  edits::Edit edit;
  std::uint64_t voxels = 0;
  std::string subject{};  // for whom a game server edits; empty: for the session itself
};

/// Costs no more than the message is long, and one chunk's decoding: what an edit reaches, and whether its
/// materials are the world's, is asked where it is prepared. A Rejection of code malformed ends the
/// connection.
[[nodiscard]] tl::expected<CheckedEdit, Rejection> check_edit(const wire::Edit& edit);

}  // namespace talus::server
