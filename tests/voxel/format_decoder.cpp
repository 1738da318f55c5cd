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
  std::vector<std::vector<int>> intervals;

  explicit Tables(const std::string& document) : intervals{lines_of(document, "intervals")} {
    const std::array<std::string, 3> kinds{"level", "carried", "first"};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      weights[kind][0] = lines_of(document, "weights-" + kinds[kind] + "-even");
      weights[kind][1] = lines_of(document, "weights-" + kinds[kind] + "-odd");
      if (weights[kind][0].size() != 18 || weights[kind][1].size() != 26) fail("the tables' sizes");
    }
    if (intervals.size() != 3) fail("the intervals' lines");
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

  /// `starts`: of the intervals, and 256.
  template <class Starts>
  int read(const Starts& starts, int i) {
    int& state = states_[static_cast<std::size_t>(i)];
    const int slot = state % 256;
    std::size_t symbol = 0;
    while (starts[symbol + 1] <= slot) ++symbol;
    state = (starts[symbol + 1] - starts[symbol]) * (state / 256) + slot - starts[symbol];
    if (state < 256) state = state * 256 + bytes_.next();
    return static_cast<int>(symbol);
  }

  /// Byte i of what is in the final states.
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

std::array<int, 5> intervals_of(const Tables& tables, const Before& before, Kind kind, const Row& symbol,
                                int x) {
  const Row& N = before.N;
  const Row& S = before.S;
  const Row& F = before.F;
  const Row& G = before.G;
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
  const auto line_of = [&](std::size_t line, std::size_t score) {
    return tables.intervals[line].at(static_cast<std::size_t>(class_of(scores[score])));
  };
  const int a = line_of(0, 0);
  const int o = line_of(1, 0);
  const int u = line_of(2, 1);
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
        symbol[static_cast<std::size_t>(x)] =
            coder.read(intervals_of(tables, before, kind, symbol, x), x / 2);
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

/// "Materials with probabilities".
struct Materials {
  std::vector<int> ids;
  std::vector<int> starts;

  explicit Materials(Bytes& bytes) {
    const int count = bytes.number();
    if (count < 1 || count > 256) fail("bad materials");
    for (int i = 0; i < count; ++i) ids.push_back(bytes.number());
    starts.push_back(0);
    for (int i = 0; i < count; ++i) starts.push_back(starts.back() + bytes.next() + 1);
    if (starts.back() != 256) fail("bad number");
  }
  [[nodiscard]] int read(Coder& coder, int i) const {
    return ids[static_cast<std::size_t>(coder.read(starts, i))];
  }
};

std::vector<int> starts_of_sizes(const std::vector<int>& sizes) {
  std::vector<int> starts{0};
  for (const int size : sizes) starts.push_back(starts.back() + size);
  if (starts.back() != 256) fail("bad number");
  return starts;
}

/// "Digits".
std::vector<int> read_digits(Bytes& bytes, Coder& coder, const std::vector<int>& starts, int count) {
  std::vector<int> digits;
  for (int k = 0; k < count; ++k) digits.push_back(coder.read(starts, k));
  std::vector<int> numbers;
  int byte = 0;
  int left = 0;
  for (const int each : digits) {
    int number = each == 0 ? 0 : 1 << (each - 1);
    for (int digit = 0; digit + 1 < each; ++digit) {
      if (left == 0) {
        byte = bytes.next();
        left = 8;
      }
      number += byte % 2 << digit;
      byte /= 2;
      --left;
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<int> numbers_of(const std::string& text) {
  std::istringstream numbers{text};
  return {std::istream_iterator<int>{numbers}, std::istream_iterator<int>{}};
}

/// The text of the block `name` that comes after `nth` others of that name.
std::string nth_block(const std::string& document, const std::string& name, int nth) {
  std::size_t from = 0;
  for (int i = 0; i < nth; ++i) from = document.find("```" + name + "\n", from) + 1;
  std::string text = block_of(document.substr(from), name);
  std::erase(text, '\n');
  return text;
}

int class_of_letter(char letter) {
  if (letter <= '9') return letter - '0';
  return letter <= 'Z' ? letter - 'A' + 10 : letter - 'a' + 36;
}

class VolumeByDocument {
 public:
  VolumeByDocument(const std::string& document, Bytes& bytes)
      : bytes_{bytes},
        materials_{bytes},
        exceptions_{bytes.number()},
        classes_{nth_block(document, "volume-classes", bytes.next())},
        ends_{numbers_of(block_of(document, "volume-ends"))},
        gap_starts_{starts_of_sizes(numbers_of(block_of(document, "gap-sizes")))},
        coder_{bytes},
        voxels_(kChunkVolume, -1) {}

  std::vector<int> read() {
    if (exceptions_ > 0) read_group();
    for (int wave = 0; wave < 94; ++wave) {
      for (const int odd : {0, 1}) read_batch(wave, odd);
    }
    if (exceptions_ > 0 || next_ < gaps_.size()) fail("bad number");
    for (std::size_t i = 0; i < 16; ++i) {
      if (coder_.end(i) != 0) fail("bad ending");
    }
    return voxels_;
  }

 private:
  struct WaitingVoxel {
    int voxel;
    int context;
    std::vector<int> candidates;
  };

  [[nodiscard]] int& voxel(int x, int y, int z) {
    return voxels_[static_cast<std::size_t>((y * 32 + z) * 32 + x)];
  }

  /// "The order of voxels": what is at (x, y, z) for who predicts (., y0, z0).
  int around(int x, int y, int z, int y0, int z0) {
    x = std::clamp(x, 0, 31);
    if (y < 0) {
      y = y0;
      z = z0 - 1;
    }
    if (y == y0 && z < 0) --y;
    z = std::clamp(z, 0, 31);
    if (y < 0) return materials_.ids[0];
    return voxel(x, y, z);
  }

  void read_batch(int wave, int odd) {
    std::vector<WaitingVoxel> coded;
    for (int y = 0; y < 32; ++y) {
      const int z = wave - 2 * y;
      if (z < 0 || z > 31) continue;
      for (int x = odd; x < 32; x += 2) predict(x, y, z, coded);
    }
    std::vector<int> escapes;
    for (std::size_t k = 0; k < coded.size(); ++k) {
      const WaitingVoxel& each = coded[k];
      const auto at =
          static_cast<std::size_t>(3 * class_of_letter(classes_[static_cast<std::size_t>(each.context)]));
      const std::array<int, 5> starts{0, ends_[at], ends_[at + 1], ends_[at + 2], 256};
      const auto symbol = static_cast<std::size_t>(coder_.read(starts, static_cast<int>(k % 16)));
      if (symbol == 3) {
        escapes.push_back(each.voxel);
        continue;
      }
      if (symbol >= each.candidates.size()) fail("bad number");
      voxels_[static_cast<std::size_t>(each.voxel)] = each.candidates[symbol];
    }
    for (std::size_t k = 0; k < escapes.size(); ++k) {
      voxels_[static_cast<std::size_t>(escapes[k])] = materials_.read(coder_, static_cast<int>(k % 16));
    }
  }

  void predict(int x, int y, int z, std::vector<WaitingVoxel>& coded) {
    const auto at = [&](int dx, int dy, int dz) { return around(x + dx, y + dy, z + dz, y, z); };
    const int N = at(0, 0, -1);
    const int B = at(0, -1, 0);
    const int D = at(0, -1, -1);
    const int S = at(0, -1, 1);
    const int same = N == B;
    const int upright = N == D;
    const int level = B == D;
    const int level_south = B == S;
    const int west_n = at(-1, 0, -1) == N;
    const int east_n = at(1, 0, -1) == N;
    const int west_b = at(-1, -1, 0) == B;
    const int east_b = at(1, -1, 0) == B;
    const int base = level ? N : B;
    const int other = level ? B : N;
    const int surroundings = upright + 2 * level_south + 4 * west_n + 8 * east_n + 16 * west_b + 32 * east_b;
    std::vector<int> list;
    bool steady = false;
    int context = 0;
    if (x % 2 == 0) {
      steady = same && surroundings == 63;
      context = same ? surroundings
                     : 64 + level + 2 * upright + 4 * level_south + 8 * (S == N) + 16 * (west_n & east_n) +
                           32 * (west_b & east_b);
    } else {
      const int W = voxel(x - 1, y, z);
      const int E = x == 31 ? W : voxel(x + 1, y, z);
      if (W == E && W == base && W == other) {
        steady = surroundings == 63;
        context = 128 + surroundings;
        list = {W};
      } else if (W == E) {
        context =
            192 + (base == W) + 2 * (other == W) + 4 * same + 8 * upright + 16 * level + 32 * level_south;
        list = {W};
      } else {
        const bool east_first = base == E || (base != W && other == E);
        const int one = east_first ? E : W;
        const int two = east_first ? W : E;
        context = 256 + (base == one) + 2 * (other == one) + 4 * (base == two) + 8 * (other == two) +
                  16 * upright + 32 * level + 64 * level_south;
        list = {one, two};
      }
    }
    for (const int id : {base, other, at(1, 0, -1), at(-1, 0, -1), at(1, -1, 0), at(-1, -1, 0), S, D}) {
      list.push_back(id);
    }
    std::vector<int> candidates;
    for (const int id : list) {
      const bool is_new = std::find(candidates.begin(), candidates.end(), id) == candidates.end();
      if (is_new && candidates.size() < 3) candidates.push_back(id);
    }
    voxel(x, y, z) = candidates[0];
    if (!steady) {
      coded.push_back({(y * 32 + z) * 32 + x, context, candidates});
    } else if (next_ < gaps_.size() && steady_since_++ == gaps_[next_]) {
      voxel(x, y, z) = exception_materials_[next_++];
      steady_since_ = 0;
      if (next_ == gaps_.size() && exceptions_ > 0) read_group();
    }
  }

  void read_group() {
    const int size = std::min(exceptions_, 16);
    exceptions_ -= size;
    gaps_ = read_digits(bytes_, coder_, gap_starts_, size);
    exception_materials_.clear();
    for (int k = 0; k < size; ++k) exception_materials_.push_back(materials_.read(coder_, k));
    next_ = 0;
  }

  Bytes& bytes_;
  Materials materials_;
  int exceptions_;
  std::string classes_;
  std::vector<int> ends_;
  std::vector<int> gap_starts_;
  Coder coder_;
  std::vector<int> voxels_;
  std::vector<int> gaps_;
  std::vector<int> exception_materials_;
  std::size_t next_ = 0;
  int steady_since_ = 0;
};

std::vector<int> read_runs(Bytes& bytes) {
  const Materials materials{bytes};
  int left = bytes.number();
  const bool single = left == kChunkVolume;
  std::vector<int> sizes;
  for (int i = 0; i < 16 && !single; ++i) sizes.push_back(bytes.next());
  const std::vector<int> starts = single ? std::vector<int>{} : starts_of_sizes(sizes);
  Coder coder{bytes};
  std::vector<int> voxels;
  while (left > 0) {
    const int size = std::min(left, 16);
    left -= size;
    const auto more = single ? std::vector<int>(16, 0) : read_digits(bytes, coder, starts, size);
    for (int k = 0; k < size; ++k) {
      voxels.insert(voxels.end(), static_cast<std::size_t>(more[static_cast<std::size_t>(k)] + 1),
                    materials.read(coder, k));
    }
  }
  if (voxels.size() != kChunkVolume) fail("bad number");
  for (std::size_t i = 0; i < 16; ++i) {
    if (coder.end(i) != 0) fail("bad ending");
  }
  return voxels;
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

std::vector<int> voxels_by_document(const std::string& document, std::span<const std::byte> payload) {
  Bytes bytes{payload};
  if (bytes.next() != 4) fail("not a payload of version 4");
  std::vector<int> voxels;
  switch (bytes.next()) {
    case 1:
      voxels = VolumeByDocument{document, bytes}.read();
      break;
    case 2:
      for (int i = 0; i < kChunkVolume; ++i) {
        const int low = bytes.next();
        voxels.push_back(low + 256 * bytes.next());
      }
      break;
    case 3:
      voxels = read_runs(bytes);
      break;
    default:
      fail("unknown encoding");
  }
  if (!bytes.at_end()) fail("too long");
  return voxels;
}

}  // namespace talus::testing
