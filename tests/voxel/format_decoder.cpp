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

std::vector<std::vector<int>> lines_of(const std::string& document, const std::string& block) {
  std::vector<std::vector<int>> all;
  std::istringstream lines{block_of(document, block)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers{line};
    all.emplace_back(std::istream_iterator<int>{numbers}, std::istream_iterator<int>{});
    if (all.back().size() != 16) fail("a line of " + block);
  }
  return all;
}

enum Kind { level, carried, first };

struct Tables {
  std::array<std::array<std::vector<std::vector<int>>, 2>, 3> weights;  // by kind; of even and odd columns
  std::vector<std::vector<int>> shares;

  explicit Tables(const std::string& document) : shares{lines_of(document, "shares")} {
    const std::array<std::string, 3> kinds{"level", "carried", "first"};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      weights[kind][0] = lines_of(document, "weights-" + kinds[kind] + "-even");
      weights[kind][1] = lines_of(document, "weights-" + kinds[kind] + "-odd");
      if (weights[kind][0].size() != 18 || weights[kind][1].size() != 26) fail("the tables' sizes");
    }
    if (shares.size() != 3) fail("the shares' lines");
  }
};

class Coder {
 public:
  explicit Coder(Bytes& bytes) : bytes_{bytes} {
    for (int& state : states_) {
      state = bytes_.next();
      state += 256 * bytes_.next();
      if (state < 256) fail("bad ending");
    }
  }

  int read(const std::array<int, 5>& starts, int i) {
    int& state = states_[static_cast<std::size_t>(i)];
    const int place = state % 256;
    std::size_t symbol = 0;
    while (starts[symbol + 1] <= place) ++symbol;
    state = (starts[symbol + 1] - starts[symbol]) * (state / 256) + place - starts[symbol];
    if (state < 256) state = state * 256 + bytes_.next();
    return static_cast<int>(symbol);
  }

  /// Byte i of what the states tell at the end.
  [[nodiscard]] int end(std::size_t i) const {
    if (states_[i] >= 512) fail("bad ending");
    return states_[i] - 256;
  }

 private:
  Bytes& bytes_;
  std::array<int, 16> states_{};
};

int sign(int v) {
  return v < 0 ? 0 : v == 0 ? 1 : 2;
}

int class_of(int score) {
  return std::max(score, 0) / 8;
}

using Row = std::array<int, kChunkSize>;
using Plane = std::array<Row, kChunkSize>;  // [z][x]

/// A row beyond its ends.
int at(const Row& row, int x) {
  return row[static_cast<std::size_t>(std::clamp(x, 0, kChunkSize - 1))];
}

struct Before {
  Row N;
  Row S;
  Row F;
  Row G;
};

std::array<int, 5> shares_of(const Tables& tables, const Before& before, Kind kind, const Row& symbol,
                             int x) {
  const auto& [N, S, F, G] = before;
  const auto step = [&](int dx) { return sign(x + dx < 0 || x + dx > 31 ? 0 : at(S, x + dx)); };
  const auto thick = [&](int dx) { return std::min(at(N, x + dx) - at(G, x + dx), 2); };
  const int west = sign(at(N, x) - at(N, x - 1));
  const int east = sign(at(N, x + 1) - at(N, x));
  const int far_east = sign(at(N, x + 2) - at(N, x));
  const int floor = sign(at(F, x) - at(G, x));
  const int symbol_west = x % 2 == 0 ? 0 : at(symbol, x - 1);
  const int symbol_east = x % 2 == 0 || x == 31 ? 0 : at(symbol, x + 1);
  const std::array<std::array<int, 2>, 13> pairs{{{step(-1), step(1)},
                                                  {floor, thick(1)},
                                                  {west, east},
                                                  {step(0), step(-2)},
                                                  {far_east, step(2)},
                                                  {thick(-1), thick(1)},
                                                  {west, thick(0)},
                                                  {east, thick(0)},
                                                  {floor, thick(0)},
                                                  {west, symbol_west},
                                                  {east, symbol_east},
                                                  {thick(0), symbol_west},
                                                  {thick(0), symbol_east}}};
  const auto& weights = tables.weights[kind][static_cast<std::size_t>(x % 2)];
  std::array<int, 2> scores{};
  for (std::size_t line = 0; line < weights.size(); ++line) {
    const auto [one, other] = pairs[line / 2];
    int& score = scores[line % 2];
    score = std::clamp(score + weights[line][static_cast<std::size_t>(one + 4 * other)], -128, 127);
  }
  const auto share = [&](std::size_t line, std::size_t score) {
    return tables.shares[line].at(static_cast<std::size_t>(class_of(scores[score])));
  };
  const int a = share(0, 0);
  const int o = share(1, 0);
  const int u = share(2, 1);
  return {0, a, a + 1 + (o - a - 2) * u / 256, o, 256};
}

/// The rows that are carried.
std::array<bool, kChunkSize> read_carried(Bytes& bytes) {
  std::array<bool, kChunkSize> rows{};
  const int present = bytes.next();
  if (present > 15) fail("bad number");
  for (std::size_t b = 0; b < 4; ++b) {
    if ((present >> b) % 2 == 0) continue;
    const int byte = bytes.next();
    for (std::size_t r = 0; r < 8; ++r) rows[8 * b + r] = (byte >> r) % 2 == 1;
  }
  if (rows[0]) fail("bad number");
  return rows;
}

Plane read_plane(Bytes& bytes, Coder& coder, const Tables& tables, const Plane& below) {
  const auto is_carried = read_carried(bytes);
  Plane plane{};
  Row step{};
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    const Row& F = below[z];
    const Before before{z == 0 ? F : plane[z - 1], z == 0 ? Row{} : step, F, z == 0 ? F : below[z - 1]};
    const Kind kind = z == 0 ? first : is_carried[z] ? carried : level;
    Row symbol{};
    for (const int odd : {0, 1}) {
      for (int x = odd; x < kChunkSize; x += 2) {
        symbol[static_cast<std::size_t>(x)] = coder.read(shares_of(tables, before, kind, symbol, x), x / 2);
      }
    }
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      constexpr std::array<int, 3> kChanges{0, 1, -1};
      int change = 0;
      if (symbol[x] < 3) {
        change = kChanges[static_cast<std::size_t>(symbol[x])];
      } else {
        change = bytes.next();
        if (change >= 128) change -= 256;
      }
      step[x] = change + (kind == level || x == 0 ? 0 : step[x - 1]);
      const bool absent = before.N[x] == before.G[x];
      plane[z][x] = (absent ? F[x] : std::max(before.N[x], F[x])) + step[x];
      if (plane[z][x] < F[x] || plane[z][x] > 32) fail("bad number");
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
  if (bytes.next() != 3 || bytes.next() != 0) fail("not a layered payload of version 3");
  Layers layers;
  const auto add = [&](int id) { layers.materials.push_back(MaterialId{static_cast<std::uint16_t>(id)}); };
  int count = bytes.number();
  const bool in_states = count > 64;
  if (in_states) count -= 64;
  for (int i = 0; i < count && !in_states; ++i) add(bytes.number());
  if (count == 1) return layers;
  Coder coder{bytes};
  Plane below{};
  for (int p = 1; p < count; ++p) {
    below = read_plane(bytes, coder, tables, below);
    for (const auto& row : below) {
      for (const int top : row) layers.tops.push_back(static_cast<std::uint8_t>(top));
    }
  }
  std::vector<std::byte> ends;
  for (std::size_t i = 0; i < 16; ++i) ends.push_back(static_cast<std::byte>(coder.end(i)));
  Bytes ids{ends};
  for (int i = 0; i < count && in_states; ++i) add(ids.number());
  while (!ids.at_end()) {
    if (ids.next() != 0) fail("bad ending");
  }
  if (!bytes.at_end()) fail("too long");
  return layers;
}

}  // namespace talus::testing
