// Who may change which voxels: what a token gives and what the server's settings say. Pure.
#pragma once

#include <optional>
#include <string>

#include <talus/edits/edit.h>

#include "config/access/access_control.h"
#include "config/boxes.h"

namespace talus::server {

/// The server's own rules, whatever a token gives.
struct EditRules {
  Boxes protected_boxes;          // which only the right admin lets edit
  bool gateway_required = false;  // edits come from sessions with the right gateway alone
};

/// Why this session may not edit at all; none: it may, somewhere.
[[nodiscard]] std::optional<std::string> edits_forbidden(const Grant& grant, const EditRules& rules);

/// Why it may not make this edit: names the first operation that is forbidden, and the box. What a guard
/// reads is free. A fill lies in one of the token's boxes whole, and so does what a paste writes.
[[nodiscard]] std::optional<std::string> edit_forbidden(const edits::Edit& edit, const Grant& grant,
                                                        const EditRules& rules);

/// Whether what is loose around the edit may slide: not where that could change a voxel that the session may
/// not edit.
[[nodiscard]] bool may_settle(const edits::Edit& edit, const Grant& grant, const EditRules& rules);

}  // namespace talus::server
