// Unpredictable ids of editors.
#pragma once

#include <talus/edits/editors.h>

namespace talus::server {

[[nodiscard]] edits::EditorId random_editor();

}  // namespace talus::server
