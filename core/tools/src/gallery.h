// The thesis' figures, drawn anew.
#pragma once

#include <filesystem>
#include <string>

#include <talus/progress/progress_bar.h>
#include "failure.h"
#include "world_file.h"

namespace talus::tools {

/// Writes the figures of gallery_figures.h that have `only` in their files' names into `directory`, which is
/// made where it is missing. The same world gives the same pictures, for any number of threads (0: one a
/// core). An error where no figure is meant.
[[nodiscard]] Expected<void> write_gallery(const WorldText& text, const std::string& only,
                                           const std::filesystem::path& directory, int threads,
                                           ProgressBar& progress);

}  // namespace talus::tools
