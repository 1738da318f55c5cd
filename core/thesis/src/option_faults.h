// Checks of options that CLI11 reads wrongly.
#pragma once

#include <string>

namespace talus::tools {

/// Returns the error of a seed for CLI11's check(); empty if valid. CLI11 reads more than 64 bits as the
/// maximum.
[[nodiscard]] std::string fault_of_seed(const std::string& text);
/// Returns the error of a number from `min` to `max`; empty if valid. CLI::Range would accept nan.
[[nodiscard]] std::string fault_of_number(const std::string& text, double min, double max);

}  // namespace talus::tools
