// Defaults, then the file, then the environment, then flags: each over the one before.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "config/config.h"

namespace talus::server {

/// Variables and their values; a test passes its own.
using Environment = std::map<std::string, std::string, std::less<>>;

/// The TALUS_* variables of this process.
[[nodiscard]] Environment process_environment();

/// Sets in `config` what `toml` says; `file` names the source in errors, which are one line:
/// "FILE:LINE: key: what is wrong; what would be right".
[[nodiscard]] tl::expected<void, std::string> apply_toml(Config& config, std::string_view toml,
                                                         std::string_view file);

/// Reads `file` and applies it.
[[nodiscard]] tl::expected<void, std::string> apply_file(Config& config, const std::filesystem::path& file);

/// Sets what TALUS_* variables say. Variables that name no setting are left alone: see unknown_variables.
[[nodiscard]] tl::expected<void, std::string> apply_environment(Config& config,
                                                                const Environment& environment);

/// A line for each TALUS_* variable that names no setting, with the one it may have meant.
[[nodiscard]] std::vector<std::string> unknown_variables(const Environment& environment);

}  // namespace talus::server
