#include "option_faults.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <system_error>

namespace talus::tools {

std::string fault_of_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc{} && stop == end) return {};
  return "'" + text + "' is not a seed; give a whole number from 0 to 18446744073709551615";
}

std::string fault_of_number(const std::string& text, double min, double max) {
  char* stop = nullptr;
  const double value = std::strtod(text.c_str(), &stop);
  if (!text.empty() && *stop == '\0' && min <= value && value <= max) return {};
  std::ostringstream fault;
  fault << "'" << text << "' is not a number from " << min << " to " << max;
  return fault.str();
}

}  // namespace talus::tools
