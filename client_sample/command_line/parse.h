// Parses a command line, and describes how to exit if nothing is to be run.
#pragma once

#include <optional>
#include <string>

#include <talus/client/options.h>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace talus::command_line {

inline constexpr int kExitWrongUse = 2;

/// --help or --version: status 0 and text for standard output; error: status 2 and one line.
struct Exit {
  int status = 0;
  std::string text;
};

/// Returns nullopt if the program continues.
[[nodiscard]] std::optional<Exit> parse(CLI::App& app, int argc, const char* const* argv);

/// Adds --generate auto|never|always. `what` says of whose chunks it decides.
void add_generate_option(CLI::App& app, client::Generate& generate, const std::string& what);

/// Like CLI::Range, which accepts "nan".
[[nodiscard]] CLI::Validator within(double low, double high);

}  // namespace talus::command_line
