#include "config/parse_flags.h"

#include <sstream>

#include <fmt/format.h>
#include <talus/mistyped/command_line.h>
#include <CLI/CLI.hpp>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

/// Command with its subcommand, if given, whose --help lists its flags.
std::string command_name(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app.get_name() : fmt::format("{} {}", app.get_name(), given.back()->get_name());
}

}  // namespace

std::optional<Exit> parse_flags(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& wanted) {  // --help and --version arrive here
    std::ostringstream out;
    app.exit(wanted, out, out);
    return Exit{out.str(), 0};
  } catch (const CLI::ParseError& error) {
    const std::string wrong = escaped(describe(app, error), 500);
    return Exit{fmt::format("{0}: {1}{2} {0} --help\n", command_name(app), wrong,
                            wrong.ends_with('?') ? " See" : "; see"),
                kWrongUse};
  }
}

}  // namespace talus::server
