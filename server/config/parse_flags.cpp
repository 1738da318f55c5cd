#include "config/parse_flags.h"

#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "log/escape.h"

namespace talus::server {

std::optional<Exit> parse_flags(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& wanted) {  // --help and --version arrive here
    std::ostringstream out;
    app.exit(wanted, out, out);
    return Exit{out.str(), 0};
  } catch (const CLI::ParseError& error) {
    return Exit{fmt::format("{0}: {1}; see {0} --help\n", app.get_name(), escaped(error.what(), 500)),
                kWrongUse};
  }
}

}  // namespace talus::server
