#include "format_decoder.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace talus::testing {
namespace {

[[noreturn]] void fail(const std::string& why) {
  throw std::runtime_error{why};
}

class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> bytes) : bytes_{bytes} {}

  int next() {
    if (at_ == bytes_.size()) fail("truncated");
    return std::to_integer<int>(bytes_[at_++]);
  }
  int number() {
    int value = 0;
    for (int shift = 0;; shift += 7) {
      const int byte = next();
      value += (byte % 128) << shift;
      if (byte < 128) return value;
    }
  }
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

struct Tables {
  std::string of_context;
  std::vector<std::vector<int>> ends;  // of each set of odds, where its four shares end
  std::vector<int> further;
  std::vector<int> equal;

  explicit Tables(const std::string& document) {
    std::istringstream lines{block_of(document, "contexts")};
    for (std::string line; lines >> line;) of_context += line;
    std::istringstream odds{block_of(document, "odds")};
    for (std::array<int, 3> starts{}; odds >> starts[0] >> starts[1] >> starts[2];) {
      ends.push_back({starts[0], starts[1], starts[2], 4096});
    }
    std::istringstream shares{block_of(document, "further")};
    further.assign(std::istream_iterator<int>{shares}, {});
    for (int i = 1; i <= 128; ++i) equal.push_back(32 * i);
    if (of_context.size() != 1944 || ends.size() != 48 || further.size() != 16) fail("the tables' sizes");
  }

  [[nodiscard]] const std::vector<int>& of(int context) const {
    const char c = of_context.at(static_cast<std::size_t>(context));
    return ends.at(static_cast<std::size_t>(c <= '9' ? c - '0' : c <= 'Z' ? c - 'A' + 10 : c - 'a' + 36));
  }
};

class Coder {
 public:
  explicit Coder(Bytes& bytes) : bytes_{bytes} {
    for (int& state : state_) {
      for (int i = 0; i < 3; ++i) state = state * 256 + bytes_.next();
      if (state < 65536) fail("bad ending");
    }
  }

  int read(const std::vector<int>& ends, int i) {
    int& state = state_[static_cast<std::size_t>(i)];
    const int place = state % 4096;
    std::size_t symbol = 0;
    while (ends.at(symbol) <= place) ++symbol;
    const int start = symbol == 0 ? 0 : ends[symbol - 1];
    state = (ends[symbol] - start) * (state / 4096) + place - start;
    while (state < 65536) state = state * 256 + bytes_.next();
    return static_cast<int>(symbol);
  }

  [[nodiscard]] bool at_end() const { return state_[0] == 65536 && state_[1] == 65536 && bytes_.at_end(); }

 private:
  Bytes& bytes_;
  std::array<int, 2> state_{};
};

int sign(int v) {
  return v < 0 ? 0 : v == 0 ? 1 : 2;
}

int read_change(Coder& coder, const Tables& tables, int context, int i) {
  const int symbol = coder.read(tables.of(context), i);
  if (symbol < 3) return symbol == 2 ? -1 : symbol;
  int place = coder.read(tables.further, i);
  if (place == 15) place = coder.read(tables.equal, i);
  const int size = place / 2 + 2;
  return place % 2 == 0 ? size : -size;
}

using Plane = std::array<std::array<int, kChunkSize>, kChunkSize>;  // [z][x]

Plane read_plane(Coder& coder, const Tables& tables, const Plane& below) {
  Plane plane{};
  Plane step{};
  for (int z = 0; z < kChunkSize; ++z) {
    const auto row = static_cast<std::size_t>(z);
    const auto& F = below[row];
    const auto& G = z == 0 ? F : below[row - 1];
    const auto& northern = z == 0 ? F : plane[row - 1];
    const auto N = [&](int x) { return northern[static_cast<std::size_t>(std::clamp(x, 0, 31))]; };
    const auto S = [&](int x) {
      if (x < 0 || x > 31) return 0;
      return z == 0 ? 1 : step[row - 1][static_cast<std::size_t>(x)];
    };
    for (int x = 0; x < kChunkSize; ++x) {
      const auto column = static_cast<std::size_t>(x);
      const int f = F[column];
      const int g = G[column];
      const int west_step = x == 0 ? 0 : step[row][column - 1];
      const int bare = N(x) == g ? 1 : 0;
      const int west = west_step == 0 ? 0 : west_step == 1 ? 1 : west_step == -1 ? 2 : 3;
      const int signs =
          (((sign(N(x) - N(x - 1)) * 3 + sign(N(x + 2) - N(x))) * 3 + sign(S(x + 1))) * 3 + sign(S(x - 1))) *
              3 +
          sign(f - g);
      const int carried = std::abs(west_step) >= 2 ? west_step : 0;
      const int predicted = bare == 1 ? f : std::max(N(x), f);
      const int change = read_change(coder, tables, west * 486 + bare * 243 + signs, x % 2);
      step[row][column] = carried + change;
      if (std::abs(carried + change) > 32) fail("bad number");
      plane[row][column] = predicted + carried + change;
      if (plane[row][column] < f || plane[row][column] > 32) fail("bad number");
    }
  }
  return plane;
}

}  // namespace

std::string format_document() {
  std::ifstream file{TALUS_SOURCE_DIR "/core/voxel/FORMAT.md", std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::string block_of(const std::string& document, const std::string& name) {
  const std::string opening = "```" + name + "\n";
  const std::size_t start = document.find(opening);
  if (start == std::string::npos) fail("no block " + name);
  const std::size_t first = start + opening.size();
  return document.substr(first, document.find("```", first) - first);
}

Layers decode_by_document(const std::string& document, std::span<const std::byte> payload) {
  const Tables tables{document};
  Bytes bytes{payload};
  if (bytes.next() != 2 || bytes.next() != 0) fail("not a layered payload of version 2");
  Layers layers;
  for (int count = bytes.number(); count > 0; --count) {
    layers.materials.push_back(MaterialId{static_cast<std::uint16_t>(bytes.number())});
  }
  if (layers.materials.size() == 1) return layers;
  Coder coder{bytes};
  Plane below{};
  for (std::size_t p = 0; p < layers.plane_count(); ++p) {
    below = read_plane(coder, tables, below);
    for (const auto& row : below) {
      for (const int top : row) layers.tops.push_back(static_cast<std::uint8_t>(top));
    }
  }
  if (!coder.at_end()) fail("bad ending");
  return layers;
}

}  // namespace talus::testing
