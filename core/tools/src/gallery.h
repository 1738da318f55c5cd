// The thesis' figures, drawn anew.
#pragma once

#include <filesystem>
#include <string>

#include <talus/progress/progress_bar.h>
#include "failure.h"
#include "world_file.h"

namespace talus::tools {

/// Writes the figures of gallery_figures.h whose file names contain `only` into `directory`, which is
/// made where it is missing. The same world gives the same pictures, for any number of threads (0: one a
/// core). An error where no file name does.
[[nodiscard]] Expected<void> write_gallery(const WorldText& text, const std::string& only,
                                           const std::filesystem::path& directory, int threads,
                                           ProgressBar& progress);

}  // namespace talus::tools
