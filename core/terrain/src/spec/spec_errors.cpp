#include "spec/spec_errors.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>

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

std::string plain(double number) {
  // A power of two below 1/1000 is shown as a fraction.
  int exponent = 0;
  if (number > 0 && number < 1e-3 && std::frexp(number, &exponent) == 0.5 && exponent > -60) {
    return "1/" + std::to_string(std::uint64_t{1} << (1 - exponent));
  }
  constexpr int kDigits = 12;  // hides the rounding of a product of two numbers
  std::array<char, 64> digits{};
  const auto written = [&](auto... how) {
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, how...).ptr;
    return std::string{digits.data(), end};
  };
  if (!std::isfinite(number)) return written();
  const std::string rounded = written(std::chars_format::scientific, kDigits - 1);
  // libc++ before 20 has no std::from_chars of floating-point numbers.
  std::istringstream digits_only{rounded};
  digits_only.imbue(std::locale::classic());
  digits_only >> number;
  const double size = std::abs(number);
  if (size == 0 || (size >= 1e-9 && size < 1e15)) return written(std::chars_format::fixed);
  std::string text = written(std::chars_format::scientific);
  const std::size_t power = text.find('e') + 1;
  if (text[power] == '+') text.erase(power, 1);
  const std::size_t digit = power + (text[power] == '-' ? 1 : 0);
  if (text[digit] == '0') text.erase(digit, 1);
  return text;
}

void SpecErrors::add(int line, int column, const std::string& key, const std::string& what) {
  if (first_) return;
  first_ = SpecError{"", line, column, one_line(key), one_line(what)};
  first_->message =
      text_of(one_line(file_), ':', line, ": ", first_->key, key.empty() ? "" : ": ", first_->text);
}

}  // namespace talus::terrain
