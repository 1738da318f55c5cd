// Whether somebody watches standard error.
#pragma once

namespace talus {

/// Returns true if standard error is a terminal that understands escape sequences.
[[nodiscard]] bool standard_error_is_terminal();

}  // namespace talus
