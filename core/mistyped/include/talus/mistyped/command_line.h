// Describes CLI11's parse errors in one line. Inline: every file that parses includes CLI11 anyway.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/mistyped/nearest.h>
#include <CLI/CLI.hpp>

namespace talus {

/// Names unexpected words in their order, each with the nearest command of `app`, or flag of `app` or of the
/// given command, if one is near. Reports a value that is not a number. Other errors are CLI11's text.
/// REQUIRES: `error` was thrown by app.parse().
[[nodiscard]] inline std::string describe(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  const auto given = app.get_subcommands();
  const std::vector<std::string> words = app.remaining(true);
  const bool extras = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const bool no_command = app.get_require_subcommand_min() > 0 && given.empty() &&
                          error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ConversionError)) {
    // "Could not convert: NAME = VALUE"; only numbers are converted.
    const std::string text = error.what();
    const std::size_t name = text.find(": ");
    const std::size_t value = text.find(" = ", name);
    if (value == std::string::npos) return text;
    return text.substr(name + 2, value - name - 2) + ": '" + text.substr(value + 3) +
           "' is not a number that it takes";
  }
  if (!extras && !no_command) return error.what();

  std::vector<std::string> names;
  for (const CLI::App* const command : commands) names.push_back(command->get_name());
  if (words.empty()) return std::string{error.what()} + ": " + CLI::detail::join(names, ", ");
  const std::string word = words.front().substr(0, words.front().find('='));
  const bool is_command = given.empty() && !commands.empty() && !word.starts_with('-');
  if (!is_command) {
    names.clear();
    std::vector<const CLI::App*> apps{&app};
    apps.insert(apps.end(), given.begin(), given.end());
    for (const CLI::App* const each : apps) {
      for (const CLI::Option* const option : each->get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      }
    }
  }
  const std::string_view near = meant(word, std::vector<std::string_view>{names.begin(), names.end()});
  const std::string hint = near.empty() ? std::string{}
                           : near == word && !given.empty()
                               ? "; " + word + " stands after " + given.back()->get_name()
                               : "; did you mean " + std::string{near} + "?";
  if (!is_command) return "not expected: " + CLI::detail::join(words, " ") + hint;
  return "unknown command " + words.front() +
         (near.empty() ? "; there are " + CLI::detail::join(names, ", ") : hint);
}

}  // namespace talus
