// A command of talus-gen: its options and its action.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "failure.h"

namespace talus::tools {

struct Command {
  CLI::App* options = nullptr;  // owned by the program's App
  std::function<Expected<void>()> run;
};

// Commands for a region of a world (region_commands.cpp).
[[nodiscard]] Command add_map(CLI::App& app);
[[nodiscard]] Command add_section(CLI::App& app);
[[nodiscard]] Command add_export(CLI::App& app);
[[nodiscard]] Command add_hash(CLI::App& app);
[[nodiscard]] Command add_vox(CLI::App& app);

// Commands that draw and measure a world (figure_commands.cpp).
[[nodiscard]] Command add_gallery(CLI::App& app);
[[nodiscard]] Command add_table1(CLI::App& app);
[[nodiscard]] Command add_likeness(CLI::App& app);
[[nodiscard]] Command add_lod_error(CLI::App& app);

// Commands for authors of worlds (world_commands.cpp).
[[nodiscard]] Command add_preview(CLI::App& app);
[[nodiscard]] Command add_find(CLI::App& app);
[[nodiscard]] Command add_quality(CLI::App& app);

// Commands for height maps, without a world (height_map_commands.cpp).
[[nodiscard]] Command add_erode(CLI::App& app);
[[nodiscard]] Command add_diamond_square(CLI::App& app);

// Commands for single chunks, without a world (chunk_commands.cpp).
[[nodiscard]] Command add_encode(CLI::App& app);
[[nodiscard]] Command add_decode(CLI::App& app);
[[nodiscard]] Command add_explain(CLI::App& app);

// Options shared by several commands (command_line.cpp: files that include CLI11 compile slowly).
void add_world(CLI::App& command, std::string& world);
void add_threads(CLI::App& command, int& threads);
void add_lod(CLI::App& command, std::int64_t& lod);
void add_output(CLI::App& command, std::string& output, const char* meaning, const char* type);

}  // namespace talus::tools
