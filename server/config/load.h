// Reads settings: defaults, then the file, the environment, and flags. Each overrides the previous.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "config/config.h"
#include "config/origins.h"

namespace talus::server {

/// Settings read so far.
struct Settings {
  Config config{};
  Origins origins{};
  std::vector<std::string> warnings{};  // one line each, for the log
};

/// Variables and their values.
using Environment = std::map<std::string, std::string, std::less<>>;

/// The TALUS_* variables of this process.
[[nodiscard]] Environment process_environment();

/// Applies `toml`; `file` names the source in errors and warnings. An error is one line: "FILE:LINE: KEY:
/// what is wrong; what is expected". After an error the settings are partly applied.
[[nodiscard]] tl::expected<void, std::string> apply_toml(Settings& settings, std::string_view toml,
                                                         std::string_view file);

/// Reads a regular file of at most kMaxTomlBytes and applies it.
[[nodiscard]] tl::expected<void, std::string> apply_file(Settings& settings,
                                                         const std::filesystem::path& file);

/// Applies TALUS_* variables. An unknown variable causes a warning with a suggestion.
[[nodiscard]] tl::expected<void, std::string> apply_environment(Settings& settings,
                                                                const Environment& environment);

}  // namespace talus::server
