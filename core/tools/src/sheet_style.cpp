#include "sheet_style.h"

#include <cmath>
#include <cstdlib>

namespace talus::tools::sheet {

std::string counted(std::int64_t number) {
  std::string digits = std::to_string(std::abs(number));
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return number < 0 ? "\u2212" + digits : digits;
}

std::string rounded(double number) {
  return counted(std::lround(number));
}

void title(Canvas& canvas, int x, int y, int width, const std::string& words, const std::string& remark) {
  canvas.text(x, y, words, kTitle, kInk);
  const int used = static_cast<int>(text_width(words, kTitle)) + 16;
  canvas.text(x + used, y, fitted(remark, kSmall, width - used), kSmall, kPale);
}

void swatch(Canvas& canvas, int x, int y, terrain::Colour colour) {
  canvas.fill({x, y - 12, 14, 14}, colour);
  canvas.frame({x, y - 12, 14, 14}, kInk);
}

}  // namespace talus::tools::sheet
