#include "spec/spec_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

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

void multiply(std::string& digits, int factor) {
  int carry = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    carry += (*digit - '0') * factor;
    *digit = static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  if (carry != 0) digits.insert(digits.begin(), static_cast<char>('0' + carry));
}

struct Decimal {
  std::string digits;
  int power = 0;  // of ten, of the first digit
};

// Exact, then rounded to this many digits, half to even. Not by std::to_chars, whose tables of powers would
// be a quarter of core/wasm, nor by a stream, whose locales would be a tenth.
Decimal decimal_of(double number, std::size_t count) {
  int exponent = 0;
  auto whole = static_cast<std::uint64_t>(std::ldexp(std::frexp(number, &exponent), 53));
  if (whole == 0) return {"0", 0};
  for (exponent -= 53; exponent < 0 && whole % 2 == 0; ++exponent) whole /= 2;
  std::string digits = std::to_string(whole);
  for (int i = 0; i < std::abs(exponent); ++i) multiply(digits, exponent < 0 ? 5 : 2);
  int power = static_cast<int>(digits.size()) - 1 + std::min(exponent, 0);
  if (digits.size() <= count) return {digits, power};
  const bool half = digits[count] == '5' && digits.find_first_not_of('0', count + 1) == std::string::npos;
  const bool up = half ? (digits[count - 1] - '0') % 2 != 0 : digits[count] >= '5';
  digits.resize(count);
  if (!up) return {digits, power};
  const std::size_t last = digits.find_last_not_of('9');
  if (last == std::string::npos) return {"1", power + 1};
  digits.resize(last + 1);
  ++digits[last];
  return {digits, power};
}

}  // namespace

std::string plain(double number) {
  const std::string sign = std::signbit(number) ? "-" : "";
  // A power of two below 1/1000 is shown as a fraction.
  int exponent = 0;
  if (number > 0 && number < 1e-3 && std::frexp(number, &exponent) == 0.5 && exponent > -60) {
    return "1/" + std::to_string(std::uint64_t{1} << (1 - exponent));
  }
  if (!std::isfinite(number)) return sign + (std::isnan(number) ? "nan" : "inf");
  constexpr std::size_t kDigits = 12;  // hides the rounding of a product of two numbers
  auto rounded = decimal_of(std::abs(number), kDigits);
  std::string& digits = rounded.digits;
  const int power = rounded.power;
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
