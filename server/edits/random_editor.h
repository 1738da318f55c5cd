// Ids of editors, which nobody guesses.
#pragma once

#include <talus/edits/editors.h>

namespace talus::server {

[[nodiscard]] edits::EditorId random_editor();

}  // namespace talus::server
