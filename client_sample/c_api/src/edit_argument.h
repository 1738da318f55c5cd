// Edits of talus.h, for both libraries.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include <talus.h>
#include <talus/edits/edit.h>

namespace talus::c_api {

/// The edit without its subject. The error completes "FUNCTION: ...".
[[nodiscard]] tl::expected<edits::Edit, std::string> plain_edit_of(const talus_edit& edit);

}  // namespace talus::c_api
