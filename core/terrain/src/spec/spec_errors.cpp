#include "spec/spec_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ios>
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
  // Not by std::to_chars, whose tables of powers would be a quarter of core/wasm.
  constexpr int kDigits = 12;  // hides the rounding of a product of two numbers
  std::ostringstream rounded;
  rounded.imbue(std::locale::classic());
  rounded.precision(kDigits - 1);
  rounded << std::scientific << number;
  const std::string written = rounded.str();  // -1.23450000000e-05
  if (!std::isfinite(number)) return written;
  const std::string sign = written.front() == '-' ? "-" : "";
  const int power = std::stoi(written.substr(written.find('e') + 1));
  std::string digits = written.substr(sign.size(), 1) + written.substr(sign.size() + 2, kDigits - 1);
  digits.erase(std::max<std::size_t>(1, digits.find_last_not_of('0') + 1));
  const auto with_point = [&](std::size_t whole) {
    return digits.size() <= whole ? digits + std::string(whole - digits.size(), '0')
                                  : digits.substr(0, whole) + '.' + digits.substr(whole);
  };
  if (power < -9 || power >= 15) return sign + with_point(1) + 'e' + std::to_string(power);
  if (power >= 0) return sign + with_point(static_cast<std::size_t>(power) + 1);
  return sign + "0." + std::string(static_cast<std::size_t>(-power - 1), '0') + digits;
}

void SpecErrors::add(int line, int column, const std::string& key, const std::string& what) {
  if (first_) return;
  first_ = SpecError{"", line, column, one_line(key), one_line(what)};
  first_->message =
      text_of(one_line(file_), ':', line, ": ", first_->key, key.empty() ? "" : ": ", first_->text);
}

}  // namespace talus::terrain
