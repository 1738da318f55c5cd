// The thesis' figures, drawn anew.
#pragma once

#include <filesystem>

#include "failure.h"
#include "progress.h"
#include "world_file.h"

namespace talus::tools {

/// Writes every figure of gallery_figures.h into `directory`, which is made where it is missing. The same
/// world gives the same pictures, for any number of threads (0: one a core).
[[nodiscard]] Expected<void> write_gallery(const WorldText& text, const std::filesystem::path& directory,
                                           int threads, Progress& progress);

}  // namespace talus::tools
