// Parsing a command line, and how a program ends that has nothing to do.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace talus::command_line {

inline constexpr int kExitWrongUse = 2;

/// --help or --version with status 0 and text for standard output, or one line with status 2.
struct Exit {
  int status = 0;
  std::string text;
};

/// Empty where the program goes on.
[[nodiscard]] std::optional<Exit> parse(CLI::App& app, int argc, const char* const* argv);

/// As CLI::Range, which accepts "nan".
[[nodiscard]] CLI::Validator within(double low, double high);

}  // namespace talus::command_line
