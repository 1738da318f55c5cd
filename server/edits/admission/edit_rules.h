// Restricts the voxels that a session may change, by its token and the server's settings. Pure.
#pragma once

#include <optional>
#include <string>

#include <talus/edits/edit.h>

#include "config/access/grant.h"
#include "config/boxes.h"

namespace talus::server {

/// The server's own rules, which no token lifts.
struct EditRules {
  Boxes protected_boxes;          // only the right admin may edit in them
  bool gateway_required = false;  // only sessions with the right gateway may edit
};

/// Returns why the session may not edit at all; nullopt if it may edit somewhere.
[[nodiscard]] std::optional<std::string> edits_forbidden(const Grant& grant, const EditRules& rules);

/// Returns why the session may not make this edit: names the first forbidden operation, and the box. Guards
/// are exempt. All voxels of a fill, and all that a paste writes, must lie in one of the token's boxes.
[[nodiscard]] std::optional<std::string> edit_forbidden(const edits::Edit& edit, const Grant& grant,
                                                        const EditRules& rules);

/// Returns true if loose material in the box, which lies in the world, may slide: no voxel of it is
/// forbidden.
[[nodiscard]] bool may_settle(const edits::VoxelBox& loose, const Grant& grant, const EditRules& rules);

}  // namespace talus::server
