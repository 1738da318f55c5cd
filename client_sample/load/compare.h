// Compares this run with an earlier one.
#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace talus::load {

/// Returns a table of the figures that both runs have, with ratios, and a line for each setting that differs.
/// Both have the format of report_json(); `old_text` may be invalid, which the error describes.
[[nodiscard]] tl::expected<std::string, std::string> compare(const std::string& old_text,
                                                             const nlohmann::json& now);

}  // namespace talus::load
