// Redraws the thesis' figures.
#pragma once

#include <filesystem>
#include <string>

#include <talus/progress/progress_bar.h>
#include <talus/tools/failure.h>
#include <talus/tools/world_file.h>

namespace talus::tools {

/// Writes the figures of gallery_figures.h whose file names contain `only` into `directory`, which is created
/// if missing. Fails if no file name matches. The same world gives the same pictures for any number of
/// threads (0: one per core).
[[nodiscard]] Expected<void> write_gallery(const WorldText& text, const std::string& only,
                                           const std::filesystem::path& directory, int threads,
                                           ProgressBar& progress);

}  // namespace talus::tools
