// The commands of talus-gen.
#pragma once

#include <talus/tools/command.h>

namespace talus::tools {

// Commands for a region of a world (region_commands.cpp).
[[nodiscard]] Command add_map(CLI::App& app);
[[nodiscard]] Command add_section(CLI::App& app);
[[nodiscard]] Command add_export(CLI::App& app);
[[nodiscard]] Command add_hash(CLI::App& app);
[[nodiscard]] Command add_vox(CLI::App& app);

// Commands for authors of worlds (world_commands.cpp).
[[nodiscard]] Command add_preview(CLI::App& app);
[[nodiscard]] Command add_find(CLI::App& app);

// Commands for single chunks, without a world (chunk_commands.cpp).
[[nodiscard]] Command add_encode(CLI::App& app);
[[nodiscard]] Command add_decode(CLI::App& app);
[[nodiscard]] Command add_explain(CLI::App& app);

}  // namespace talus::tools
