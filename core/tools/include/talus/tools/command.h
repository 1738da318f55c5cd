// A command of a program: its options and its action.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <talus/tools/failure.h>
#include <CLI/CLI.hpp>

namespace talus::tools {

struct Command {
  CLI::App* options = nullptr;  // owned by the program's App
  std::function<Expected<void>()> run;
};

struct Program {
  std::string name;
  std::string version;
  std::string description;
  std::vector<Command> (*add_commands)(CLI::App& app);
};

/// Runs the command given by the arguments; errors are printed to stderr as one line. Returns the exit code:
/// 0 done, 1 failed, 2 wrong usage.
[[nodiscard]] int run_program(const Program& program, int argc, const char* const* argv);

// Options shared by several commands (program.cpp: files that include CLI11 compile slowly).
void add_world(CLI::App& command, std::string& world);
void add_threads(CLI::App& command, int& threads);
void add_lod(CLI::App& command, std::int64_t& lod);
void add_output(CLI::App& command, std::string& output, const char* meaning, const char* type);

}  // namespace talus::tools
