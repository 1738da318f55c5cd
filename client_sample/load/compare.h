// This run beside one before.
#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace talus::load {

/// A table of the figures that both have, with their ratios, and a line for each setting in which the runs
/// differ. Both are as report_json() makes them; `old_text` may be anything, and the error says what is
/// wrong.
[[nodiscard]] tl::expected<std::string, std::string> compare(const std::string& old_text,
                                                             const nlohmann::json& now);

}  // namespace talus::load
