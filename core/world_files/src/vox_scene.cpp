#include "vox_scene.h"

#include <algorithm>
#include <charconv>

namespace talus::world_files {
namespace {

/// Reads numbers, strings and dictionaries; beyond the end they are 0 or empty.
class SceneContent {
 public:
  explicit SceneContent(std::span<const std::byte> rest) : rest_{rest} {}

  [[nodiscard]] bool ok() const { return ok_; }

  std::uint32_t number() {
    std::uint32_t value = 0;
    const auto bytes = take(4);
    for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::to_integer<std::uint32_t>(bytes[i]) << 8 * i;
    return value;
  }
  std::string_view string() {
    const auto bytes = take(number());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  /// Returns the value of `key`; empty if it is missing.
  std::string_view dictionary(std::string_view key) {
    std::string_view value;
    for (std::uint32_t pairs = number(); pairs > 0 && ok_; --pairs) {
      const bool found = string() == key;
      const std::string_view text = string();
      if (found) value = text;
    }
    return value;
  }

 private:
  std::span<const std::byte> take(std::size_t count) {
    if (count > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const auto bytes = rest_.first(count);
    rest_ = rest_.subspan(count);
    return bytes;
  }

  std::span<const std::byte> rest_;
  bool ok_ = true;
};

/// Parses a matrix: two bits for the column of the first row's entry, two for the second's, and three signs.
std::optional<VoxRotation> parse_rotation(std::string_view text) {
  if (text.empty()) return VoxRotation{};
  std::uint8_t bits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bits);
  const int first = bits & 3;
  const int second = bits >> 2 & 3;
  if (error != std::errc{} || end != text.data() + text.size() || first > 2 || second > 2 ||
      first == second) {
    return std::nullopt;
  }
  return VoxRotation{{static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
                      static_cast<std::uint8_t>(3 - first - second)},
                     {(bits & 16) != 0, (bits & 32) != 0, (bits & 64) != 0}};
}

/// Returns the rotation that applies `inner`, then `outer`.
VoxRotation product(const VoxRotation& outer, const VoxRotation& inner) {
  VoxRotation both;
  for (std::size_t i = 0; i < 3; ++i) {
    both.from[i] = inner.from[outer.from[i]];
    both.reversed[i] = outer.reversed[i] != inner.reversed[outer.from[i]];
  }
  return both;
}

/// Returns the first entry whose key is at least `key`. REQUIRES: `entries` is sorted.
template <class Value>
auto lower(const std::vector<std::pair<std::uint32_t, Value>>& entries, std::uint32_t key) {
  return std::lower_bound(entries.begin(), entries.end(), key,
                          [](const auto& entry, std::uint32_t wanted) { return entry.first < wanted; });
}

template <class Value>
const Value* find(const std::vector<std::pair<std::uint32_t, Value>>& entries, std::uint32_t key) {
  const auto found = lower(entries, key);
  return found != entries.end() && found->first == key ? &found->second : nullptr;
}

}  // namespace

bool VoxScene::add(std::string_view id, std::span<const std::byte> content) {
  if (id != "nTRN" && id != "nGRP" && id != "nSHP" && id != "LAYR") return true;
  SceneContent in{content};
  const Node node = in.number();
  const bool hidden = in.dictionary("_hidden") == "1";
  if (id == "LAYR") {
    if (hidden) hidden_layers_.emplace_back(node, true);
    return in.ok();
  }
  if (id == "nTRN") {
    parents_.emplace_back(in.number(), node);
    (void)in.number();  // reserved
    const Layer layer = in.number();
    (void)in.number();                                          // number of frames
    const auto rotation = parse_rotation(in.dictionary("_r"));  // of the first frame
    if (!rotation) return false;
    transforms_.emplace_back(node, Transform{*rotation, layer, hidden});
    return in.ok();
  }
  for (std::uint32_t count = in.number(); count > 0 && in.ok(); --count) {
    if (id == "nGRP") {
      parents_.emplace_back(in.number(), node);
    } else {
      shapes_.emplace_back(in.number(), node);
      (void)in.dictionary({});
    }
  }
  return in.ok();
}

void VoxScene::finish() {
  const auto sort = [](auto& entries) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  };
  sort(transforms_);
  sort(parents_);
  sort(shapes_);
  sort(hidden_layers_);
}

std::optional<VoxPose> VoxScene::pose_of(std::size_t model) {
  VoxPose pose;
  for (auto shape = lower(shapes_, static_cast<std::uint32_t>(model));
       shape != shapes_.end() && shape->first == model; ++shape) {
    const auto shown = pose_of_shape(shape->second);
    if (!shown || !shown->hidden) return shown;
    pose.hidden = true;
  }
  return pose;
}

std::optional<VoxPose> VoxScene::pose_of_shape(Node node) {
  constexpr std::size_t kMaxSteps = std::size_t{1} << 20;
  VoxPose pose;
  const Node* at = &node;
  for (; at != nullptr; at = find(parents_, *at)) {
    if (++steps_ > kMaxSteps) return std::nullopt;
    const Transform* transform = find(transforms_, *at);
    if (transform == nullptr) continue;
    pose.rotation = product(transform->rotation, pose.rotation);
    if (transform->hidden || find(hidden_layers_, transform->layer) != nullptr) pose.hidden = true;
  }
  return pose;
}

}  // namespace talus::world_files
