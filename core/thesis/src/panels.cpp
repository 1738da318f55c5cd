#include "panels.h"

#include <algorithm>

namespace talus::tools {

Image join_panels(std::span<const Image> panels, int across) {
  constexpr int kBetween = 8;
  const int down = (static_cast<int>(panels.size()) + across - 1) / across;
  const int width = panels.front().width;
  const int height = panels.front().height;
  Image joined{across * (width + kBetween) - kBetween, down * (height + kBetween) - kBetween};
  std::fill(joined.rgb.begin(), joined.rgb.end(), std::uint8_t{255});
  for (int i = 0; i < static_cast<int>(panels.size()); ++i) {
    const int left = i % across * (width + kBetween);
    const int top = i / across * (height + kBetween);
    const Image& panel = panels[static_cast<std::size_t>(i)];
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) joined.set(left + x, top + y, panel.at(x, y));
    }
  }
  return joined;
}

}  // namespace talus::tools
