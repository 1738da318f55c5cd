#include "command_line/parse.h"

#include <iomanip>
#include <map>
#include <sstream>

#include <talus/mistyped/command_line.h>
#include <CLI/CLI.hpp>

namespace talus::command_line {

std::optional<Exit> parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help and --version
    std::ostringstream out;
    app.exit(wanted, out, out);
    return Exit{0, out.str()};
  } catch (const CLI::ParseError& error) {
    return Exit{kExitWrongUse, describe(app, error) + " (see --help)"};
  }
  return std::nullopt;
}

void add_generate_option(CLI::App& app, client::Generate& generate, const std::string& what) {
  static const std::map<std::string, client::Generate> kWords{{"auto", client::Generate::automatic},
                                                              {"never", client::Generate::never},
                                                              {"always", client::Generate::always}};
  app.add_option_function<std::string>(
         "--generate", [&generate](const std::string& word) { generate = kWords.at(word); }, what)
      ->check(CLI::IsMember({"auto", "never", "always"}));
}

CLI::Validator within(double low, double high) {
  std::ostringstream range;
  range << low << " to " << std::setprecision(9) << high;
  const auto check = [low, high, range = range.str()](const std::string& text) -> std::string {
    double value = 0;
    const bool inside = CLI::detail::lexical_cast(text, value) && low <= value && value <= high;
    return inside ? "" : "Value " + text + " not in range " + range;
  };
  return {check, "in [" + range.str() + "]"};
}

}  // namespace talus::command_line
