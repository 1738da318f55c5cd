// What a program under test prints does not depend on the machine's pace: without a terminal a ProgressBar
// prints a line every ten seconds.
#pragma once

#include <regex>
#include <sstream>
#include <string>

namespace talus::test {

/// Returns the lines of stderr that are not a ProgressBar's, such as "map: 12 %, 1.2 k columns/s, 3 s left".
[[nodiscard]] inline std::string without_progress(const std::string& stderr_text) {
  static const std::regex progress{"[a-z][a-z0-9 :-]*: [0-9]{1,3} %(, .*)?"};
  std::istringstream lines{stderr_text};
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, progress)) continue;
    kept += line;
    if (!lines.eof()) kept += '\n';
  }
  return kept;
}

}  // namespace talus::test
