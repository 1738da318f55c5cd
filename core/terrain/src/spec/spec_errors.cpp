#include "spec/spec_errors.h"

namespace talus::terrain {
namespace {

std::string one_line(const std::string& message) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string line;
  for (const char c : message) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) {
      line += c;
    } else {
      line += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return line;
}

}  // namespace

void SpecErrors::add(int line, const std::string& what) {
  if (!first_) first_ = SpecError{one_line(text_of(file_, ':', line, ": ", what))};
}

}  // namespace talus::terrain
