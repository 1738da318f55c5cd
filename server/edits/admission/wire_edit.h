// Reads an Edit of the wire. Pure.
#pragma once

#include <cstddef>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/edit.h>
#include <talus/protocol/message.h>

#include "chunks/edit_error.h"

namespace talus::server {

struct AdmittedEdit {
  edits::Edit edit;
  edits::Extent extent{};          // EditAdmission completes it: `settles`, what is beside
  std::size_t bytes = 0;           // memory until it is answered
  std::size_t prepared_bytes = 0;  // additional memory while its base is looked up
  std::string subject{};           // the player behind a game server's edit; empty: the session itself
  bool settles = true;             // loose material around it may slide, if the world lets any
};

/// Costs no more than the length of the message and the decoding of one chunk; the bounds of the world and
/// its materials are checked when the edit is prepared. EditErrorCode::malformed ends the connection.
/// `settles`: the world lets material slide; `reveals`: it has secrets.
[[nodiscard]] tl::expected<AdmittedEdit, EditError> read_edit(const wire::Edit& edit, bool settles = false,
                                                              bool reveals = false);

}  // namespace talus::server
