#include <talus/pictures/stroke_font.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace talus::pictures {
namespace {

// Capitals are 14 units high, small letters 10 with descenders of 4. y points up from the base line.
constexpr float kCapitals = 14;
constexpr float kGap = 4.2F;  // between letters
constexpr int kArcPieces = 6;

// M x y: moves the pen. L x y: a line. H x y and V x y: a quarter of an ellipse that starts horizontally or
// vertically. Q x1 y1 x y: a parabola with its control point.
struct Letter {
  char32_t code;
  float width;
  std::string_view strokes;
};

constexpr std::array kLetters{
    Letter{U' ', 2, ""},
    Letter{U'0', 9, "M 0 9.5 V 4.5 14 H 9 9.5 L 9 4.5 V 4.5 0 H 0 4.5 L 0 9.5"},
    Letter{U'1', 9, "M 1.5 11 L 5 14 L 5 0"},
    Letter{U'2', 9, "M 0.3 10.3 V 4.5 14 H 8.7 10.2 Q 8.7 7.8 6.4 5.6 L 0 0 L 9 0"},
    Letter{U'3', 9, "M 0.4 11.3 V 4.3 14 H 8.2 10.7 V 4.6 7.5 L 3.4 7.5 M 4.6 7.5 H 9 3.8 V 4.4 0 H 0 3.2"},
    Letter{U'4', 9, "M 6.6 0 L 6.6 14 L 0 4 L 9 4"},
    Letter{U'5', 9, "M 8 14 L 1.4 14 L 0.8 7.6 Q 2.4 8.8 4.4 8.8 H 9 4.4 V 4.4 0 H 0 3"},
    Letter{U'6', 9, "M 6.4 14 Q 0 9.5 0 4.4 V 4.5 0 H 9 4.4 V 4.5 8.8 H 0 4.4"},
    Letter{U'7', 9, "M 0 14 L 9 14 L 3.2 0"},
    Letter{U'8', 9, "M 4.5 7.6 H 0.6 10.8 V 4.5 14 H 8.4 10.8 V 4.5 7.6 H 9 3.8 V 4.5 0 H 0 3.8 V 4.5 7.6"},
    Letter{U'9', 9, "M 2.6 0 Q 9 4.5 9 9.6 V 4.5 14 H 0 9.6 V 4.5 5.2 H 9 9.6"},
    Letter{U'A', 10, "M 0 0 L 5 14 L 10 0 M 1.8 5 L 8.2 5"},
    Letter{U'B', 9, "M 0 0 L 0 14 L 4.6 14 H 8.2 10.8 V 4.6 7.5 L 0 7.5 M 4.6 7.5 H 9 3.8 V 4.6 0 L 0 0"},
    Letter{U'C', 9.6F, "M 9.6 10.8 V 5.4 14 H 0 8.6 L 0 5.4 V 5.4 0 H 9.6 3.2"},
    Letter{U'D', 10, "M 0 0 L 0 14 L 4.4 14 H 10 8.4 L 10 5.6 V 4.4 0 L 0 0"},
    Letter{U'E', 8, "M 8 14 L 0 14 L 0 0 L 8 0 M 0 7.4 L 6.8 7.4"},
    Letter{U'F', 8, "M 8 14 L 0 14 L 0 0 M 0 7.2 L 6.8 7.2"},
    Letter{U'G', 10, "M 9.6 11 V 5.4 14 H 0 8.6 L 0 5.4 V 5.2 0 H 10 4.4 L 10 6.8 L 5.8 6.8"},
    Letter{U'H', 9.5F, "M 0 0 L 0 14 M 9.5 0 L 9.5 14 M 0 7.2 L 9.5 7.2"},
    Letter{U'I', 0, "M 0 0 L 0 14"},
    Letter{U'J', 7, "M 7 14 L 7 3.8 V 3.4 0 H 0 3.2"},
    Letter{U'K', 9, "M 0 0 L 0 14 M 8.6 14 L 0 5.4 M 3 8.4 L 9 0"},
    Letter{U'L', 7.5F, "M 0 14 L 0 0 L 7.5 0"},
    Letter{U'M', 12, "M 0 0 L 0 14 L 6 4.5 L 12 14 L 12 0"},
    Letter{U'N', 10, "M 0 0 L 0 14 L 10 0 L 10 14"},
    Letter{U'O', 11, "M 0 8.4 V 5.5 14 H 11 8.4 L 11 5.6 V 5.5 0 H 0 5.6 L 0 8.4"},
    Letter{U'P', 9, "M 0 0 L 0 14 L 4.8 14 H 9 10.2 V 4.8 6.3 L 0 6.3"},
    Letter{U'Q', 11, "M 0 8.4 V 5.5 14 H 11 8.4 L 11 5.6 V 5.5 0 H 0 5.6 L 0 8.4 M 7 3.6 L 11 -0.6"},
    Letter{U'R', 9.2F, "M 0 0 L 0 14 L 4.8 14 H 9 10.2 V 4.8 6.3 L 0 6.3 M 5 6.3 L 9.2 0"},
    Letter{U'S', 9, "M 8.6 11.2 V 4.6 14 H 0.4 10.6 Q 0.4 8.2 4.6 7.3 Q 9 6.4 9 3.7 V 4.4 0 H 0 3.1"},
    Letter{U'T', 9, "M 0 14 L 9 14 M 4.5 14 L 4.5 0"},
    Letter{U'U', 9.5F, "M 0 14 L 0 4.7 V 4.75 0 H 9.5 4.7 L 9.5 14"},
    Letter{U'V', 10, "M 0 14 L 5 0 L 10 14"},
    Letter{U'W', 14, "M 0 14 L 3.5 0 L 7 12 L 10.5 0 L 14 14"},
    Letter{U'X', 9.5F, "M 0 14 L 9.5 0 M 9.5 14 L 0 0"},
    Letter{U'Y', 10, "M 0 14 L 5 7 L 10 14 M 5 7 L 5 0"},
    Letter{U'Z', 9, "M 0 14 L 9 14 L 0 0 L 9 0"},
    Letter{U'a', 7.6F, "M 0.7 7.9 V 4 10 H 7.6 6.6 L 7.6 0 M 7.6 5.9 L 3.3 5.9 H 0 2.95 V 3.2 0 H 7.6 3.2"},
    Letter{U'b', 8, "M 0 14 L 0 0 M 0 4.4 V 4 0 H 8 4.4 L 8 5.6 V 4 10 H 0 5.6"},
    Letter{U'c', 7.4F, "M 7.4 7.4 V 4 10 H 0 5.6 L 0 4.4 V 4 0 H 7.4 2.6"},
    Letter{U'd', 8, "M 8 14 L 8 0 M 8 5.6 V 4 10 H 0 5.6 L 0 4.4 V 4 0 H 8 4.4"},
    Letter{U'e', 8, "M 0 5.2 L 8 5.2 L 8 5.8 V 4 10 H 0 5.6 L 0 4.4 V 4.2 0 H 7.6 2.2"},
    Letter{U'f', 5, "M 5.4 14 H 1.8 10.6 L 1.8 0 M 0 9.6 L 4.8 9.6"},
    Letter{U'g', 8, "M 8 10 L 8 -0.2 V 4 -4 H 0.4 -1.8 M 8 5.6 V 4 10 H 0 5.6 L 0 4.4 V 4 0 H 8 4.4"},
    Letter{U'h', 7.6F, "M 0 14 L 0 0 M 0 6 V 4 10 H 7.6 6.2 L 7.6 0"},
    Letter{U'i', 0, "M 0 10 L 0 0 M 0 13.5 L 0 13.7"},
    Letter{U'j', 2, "M 2 10 L 2 -1.4 V -0.6 -4 M 2 13.5 L 2 13.7"},
    Letter{U'k', 7.2F, "M 0 14 L 0 0 M 6.6 10 L 0 3.8 M 2.4 6 L 7.2 0"},
    Letter{U'l', 1.8F, "M 0 14 L 0 2.2 V 2 0"},
    Letter{U'm', 12, "M 0 10 L 0 0 M 0 6.4 V 3.2 10 H 6 6.8 L 6 0 M 6 6.4 V 9.2 10 H 12 6.8 L 12 0"},
    Letter{U'n', 7.6F, "M 0 10 L 0 0 M 0 6 V 4 10 H 7.6 6.2 L 7.6 0"},
    Letter{U'o', 8.4F, "M 0 5.4 V 4.2 10 H 8.4 5.4 L 8.4 4.6 V 4.2 0 H 0 4.6 L 0 5.4"},
    Letter{U'p', 8, "M 0 10 L 0 -4 M 0 4.4 V 4 0 H 8 4.4 L 8 5.6 V 4 10 H 0 5.6"},
    Letter{U'q', 8, "M 8 10 L 8 -4 M 8 5.6 V 4 10 H 0 5.6 L 0 4.4 V 4 0 H 8 4.4"},
    Letter{U'r', 4.6F, "M 0 10 L 0 0 M 0 5.8 V 4 10 L 4.8 10"},
    Letter{U's', 7, "M 6.6 8 V 3.5 10 H 0.4 7.6 Q 0.4 5.8 3.6 5.2 Q 7 4.6 7 2.6 V 3.4 0 H 0 2.1"},
    Letter{U't', 5.2F, "M 1.8 13.4 L 1.8 3.2 V 5 0 L 5.2 0 M 0 10 L 5 10"},
    Letter{U'u', 7.6F, "M 0 10 L 0 3.8 V 3.6 0 H 7.6 4 M 7.6 10 L 7.6 0"},
    Letter{U'v', 8, "M 0 10 L 4 0 L 8 10"},
    Letter{U'w', 11, "M 0 10 L 2.8 0 L 5.5 8.6 L 8.2 0 L 11 10"},
    Letter{U'x', 7.4F, "M 0 10 L 7.4 0 M 7.4 10 L 0 0"},
    Letter{U'y', 8, "M 0 10 L 4 0 M 8 10 L 3.6 -1.4 Q 2.6 -4 0.4 -4"},
    Letter{U'z', 7, "M 0 10 L 7 10 L 0 0 L 7 0"},
    Letter{U'.', 0, "M 0 0.2 L 0 0"},
    Letter{U',', 0.6F, "M 0.7 0.2 L 0 -2.4"},
    Letter{U':', 0, "M 0 0.2 L 0 0 M 0 8 L 0 7.8"},
    Letter{U';', 0.6F, "M 0.7 0.2 L 0 -2.4 M 0.6 8 L 0.6 7.8"},
    Letter{U'\'', 0, "M 0 14 L 0 10.6"},
    Letter{U'"', 3, "M 0 14 L 0 10.6 M 3 14 L 3 10.6"},
    Letter{U'!', 0, "M 0 14 L 0 4.4 M 0 0.2 L 0 0"},
    Letter{U'?', 7.4F, "M 0 11 V 3.7 14 H 7.4 10.6 Q 7.4 8.6 5.4 7.4 Q 3.7 6.2 3.7 4.2 M 3.7 0.2 L 3.7 0"},
    Letter{U'-', 5, "M 0 5.2 L 5 5.2"},
    Letter{U'\u2013', 8, "M 0 5.2 L 8 5.2"},
    Letter{U'\u2212', 7, "M 0 6 L 7 6"},
    Letter{U'_', 8, "M 0 -2 L 8 -2"},
    Letter{U'+', 8, "M 0 6 L 8 6 M 4 2 L 4 10"},
    Letter{U'\u00B1', 8, "M 0 7.4 L 8 7.4 M 4 3.6 L 4 11.2 M 0 0.4 L 8 0.4"},
    Letter{U'=', 8, "M 0 7.8 L 8 7.8 M 0 4.2 L 8 4.2"},
    Letter{U'<', 7, "M 7 10.4 L 0 6 L 7 1.6"},
    Letter{U'>', 7, "M 0 10.4 L 7 6 L 0 1.6"},
    Letter{U'\u00B5', 7.6F, "M 0 10 L 0 -4 M 0 3.8 V 3.6 0 H 7.6 4 M 7.6 10 L 7.6 0"},
    Letter{U'\u00D7', 6.4F, "M 0 9.2 L 6.4 2.8 M 6.4 9.2 L 0 2.8"},
    Letter{U'\u00B7', 0, "M 0 6 L 0 6.2"},
    Letter{U'\u00B0', 4, "M 0 12 V 2 14 H 4 12 V 2 10 H 0 12"},
    Letter{U'\u00B2', 4.6F, "M 0.2 12.4 V 2.3 14 H 4.4 12.3 Q 4.4 11.2 3.2 10.2 L 0 7.4 L 4.6 7.4"},
    Letter{U'%', 12,
           "M 10 14 L 2 0 M 0 11.2 V 2.5 14 H 5 11.2 V 2.5 8.4 H 0 11.2 M 7 2.8 V 9.5 5.6 H 12 2.8 V 9.5 0 H "
           "7 2.8"},
    Letter{U'/', 5.5F, "M 0 -1.5 L 5.5 15"},
    Letter{U'\\', 5.5F, "M 0 15 L 5.5 -1.5"},
    Letter{U'(', 3, "M 3 15 Q 0 11.5 0 6.5 Q 0 1.5 3 -2"},
    Letter{U')', 3, "M 0 15 Q 3 11.5 3 6.5 Q 3 1.5 0 -2"},
    Letter{U'[', 3, "M 3 15 L 0 15 L 0 -2 L 3 -2"},
    Letter{U']', 3, "M 0 15 L 3 15 L 3 -2 L 0 -2"},
    Letter{U'#', 9, "M 3.4 13 L 1.6 1 M 7.4 13 L 5.6 1 M 0.4 9.2 L 9 9.2 M 0 4.8 L 8.6 4.8"},
    Letter{U'&', 10,
           "M 10 0 L 2.2 9.6 Q 1.2 10.8 1.2 11.4 V 4 14 H 6.8 11.4 Q 6.8 9.6 4 8 Q 0 6 0 3.6 V 3.9 0 Q 8 0 "
           "9.4 6.4"},
};
constexpr Letter kNoLetter{0, 8, "M 0 0 L 0 14 L 8 14 L 8 0 L 0 0"};

struct Point {
  float x = 0;
  float y = 0;
};
struct Segment {
  Point from;
  Point to;
};

class StrokeReader {
 public:
  explicit StrokeReader(std::string_view text) : text_{text} {}

  std::vector<Segment> read() {
    for (skip(); !text_.empty(); skip()) {
      const char command = text_.front();
      text_.remove_prefix(1);
      const Point control = command == 'Q' ? point() : Point{};
      const Point to = point();
      if (command == 'L') line_to(to);
      if (command == 'Q') parabola(control, to);
      if (command == 'H') quarter(to, {to.x, pen_.y});
      if (command == 'V') quarter(to, {pen_.x, to.y});
      pen_ = to;
    }
    return std::move(segments_);
  }

 private:
  void skip() { text_.remove_prefix(std::min(text_.find_first_not_of(' '), text_.size())); }
  float number() {
    skip();
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return error == std::errc{} ? static_cast<float>(value) : 0;
  }
  Point point() {
    const float x = number();
    return {x, number()};
  }

  void line_to(Point to) {
    segments_.push_back({pen_, to});
    pen_ = to;
  }
  void parabola(Point control, Point to) {
    const Point from = pen_;
    for (int i = 1; i <= kArcPieces; ++i) {
      const float t = static_cast<float>(i) / kArcPieces;
      const float s = 1 - t;
      line_to({s * s * from.x + 2 * s * t * control.x + t * t * to.x,
               s * s * from.y + 2 * s * t * control.y + t * t * to.y});
    }
  }
  // A cubic curve with the corner of the ellipse's box.
  void quarter(Point to, Point corner) {
    constexpr float kRound = 0.5523F;  // position of a quarter circle's control points towards the corner
    const Point from = pen_;
    const Point first{from.x + kRound * (corner.x - from.x), from.y + kRound * (corner.y - from.y)};
    const Point second{to.x + kRound * (corner.x - to.x), to.y + kRound * (corner.y - to.y)};
    for (int i = 1; i <= kArcPieces; ++i) {
      const float t = static_cast<float>(i) / kArcPieces;
      const float s = 1 - t;
      const auto at = [&](float a, float b, float c, float d) {
        return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
      };
      line_to({at(from.x, first.x, second.x, to.x), at(from.y, first.y, second.y, to.y)});
    }
  }

  std::string_view text_;
  Point pen_;
  std::vector<Segment> segments_;
};

const Letter& letter_of(char32_t code) {
  const auto found = std::find_if(kLetters.begin(), kLetters.end(),
                                  [&](const Letter& letter) { return letter.code == code; });
  return found == kLetters.end() ? kNoLetter : *found;
}

// Removes the next code point; an invalid byte counts as one.
char32_t take_code(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
  std::size_t used = 1;
  while (used < length && used < text.size() && (byte(used) & 0xC0U) == 0x80) {
    code = (code << 6U) | (byte(used++) & 0x3FU);
  }
  text.remove_prefix(used);
  return code;
}

float distance(Point p, const Segment& segment) {
  const Point along{segment.to.x - segment.from.x, segment.to.y - segment.from.y};
  const Point to{p.x - segment.from.x, p.y - segment.from.y};
  const float squared = along.x * along.x + along.y * along.y;
  const float t = squared > 0 ? std::clamp((to.x * along.x + to.y * along.y) / squared, 0.0F, 1.0F) : 0.0F;
  return std::hypot(to.x - t * along.x, to.y - t * along.y);
}

// The letter's origin is at (x, y) in pixels, y downwards.
void draw_letter(const Letter& letter, float x, float y, const TextStyle& style,
                 const std::function<void(int, int, float)>& ink) {
  const std::vector<Segment> segments = StrokeReader{letter.strokes}.read();
  if (segments.empty()) return;
  const float scale = style.size / kCapitals;
  const float reach = style.pen / 2 + 1;
  const int left = static_cast<int>(std::floor(x - scale - reach));
  const int right = static_cast<int>(std::ceil(x + (letter.width + 1) * scale + reach));
  const int top = static_cast<int>(std::floor(y - 16 * scale - reach));
  const int bottom = static_cast<int>(std::ceil(y + 5 * scale + reach));
  for (int py = top; py <= bottom; ++py) {
    for (int px = left; px <= right; ++px) {
      const Point at{(static_cast<float>(px) + 0.5F - x) / scale,
                     (y - static_cast<float>(py) - 0.5F) / scale};
      float nearest = reach;
      for (const Segment& segment : segments) nearest = std::min(nearest, distance(at, segment) * scale);
      const float part = std::clamp(style.pen / 2 - nearest + 0.5F, 0.0F, 1.0F);
      if (part > 0) ink(px, py, part);
    }
  }
}

}  // namespace

float text_width(std::string_view text, const TextStyle& style) {
  float units = 0;
  while (!text.empty()) units += letter_of(take_code(text)).width + kGap;
  return std::max(0.0F, units - kGap) * style.size / kCapitals + style.pen;
}

void draw_text(std::string_view text, int x, int y, const TextStyle& style,
               const std::function<void(int, int, float)>& ink) {
  // Relative to (x, y), so that a text looks the same at every position.
  const float base = 1 - style.pen / 2;
  float at = style.pen / 2;
  const auto moved = [&](int px, int py, float part) { ink(x + px, y + py, part); };
  while (!text.empty()) {
    const Letter& letter = letter_of(take_code(text));
    draw_letter(letter, std::round(at * 4) / 4, base, style, moved);
    at += (letter.width + kGap) * style.size / kCapitals;
  }
}

}  // namespace talus::pictures
