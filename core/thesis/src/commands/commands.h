// The commands of talus-thesis.
#pragma once

#include <talus/tools/command.h>

namespace talus::tools {

// Commands that draw and measure a world (figure_commands.cpp).
[[nodiscard]] Command add_gallery(CLI::App& app);
[[nodiscard]] Command add_table1(CLI::App& app);
[[nodiscard]] Command add_likeness(CLI::App& app);
[[nodiscard]] Command add_lod_error(CLI::App& app);
[[nodiscard]] Command add_quality(CLI::App& app);

// Commands for height maps, without a world (height_map_commands.cpp).
[[nodiscard]] Command add_erode(CLI::App& app);
[[nodiscard]] Command add_diamond_square(CLI::App& app);

}  // namespace talus::tools
