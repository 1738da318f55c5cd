// MagicaVoxel's .vox files: 8 bytes, then chunks of id, bytes of content, bytes of children, and content.
// MAIN has all other chunks as children; SIZE and XYZI come in pairs, one per model. The models are returned
// as MagicaVoxel shows them: nTRN, nGRP and nSHP turn them, and IMAP orders the palette.
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/world_files/world_files.h>

#include "vox_scene.h"

namespace talus::world_files {
namespace {

constexpr std::size_t kFileHeader = 8;
constexpr std::size_t kPartHeader = 12;
using Refusal = std::optional<std::string>;

class VoxReader {
 public:
  VoxReader(std::span<const std::byte> bytes, const ModelBounds& bounds) : bytes_{bytes}, bounds_{bounds} {}

  Refusal read() {
    if (bytes_.size() < kFileHeader || text(0, 4) != "VOX ") return "is not a .vox file of MagicaVoxel";
    for (std::size_t at = kFileHeader; at < bytes_.size();) {
      if (bytes_.size() - at < kPartHeader) return cut(at);
      const std::string_view id = text(at, 4);
      const std::size_t content = number(at + 4);
      const std::size_t begin = at + kPartHeader;
      if (content > bytes_.size() - begin) return cut(at);
      Refusal refused;
      if (id == "SIZE") refused = read_size(begin, content);
      if (id == "XYZI") refused = read_voxels(begin, content);
      if (id == "TDCZ") refused = model() + " has voxels as Teardown compresses them; save it by MagicaVoxel";
      if (id == "IMAP") refused = read_order(begin, content);
      if (!scene_.add(id, bytes_.subspan(begin, content))) {
        refused = "has a scene graph that cannot be read: the " + std::string{id} + " at byte " +
                  std::to_string(at) + " ends early, or has a rotation that is not one";
      }
      if (refused) return refused;
      at = begin + content;
    }
    if (stored_.empty()) return "has no model";
    return show();
  }

  std::vector<terrain::VoxelModel> models;

 private:
  // Along x, y and z; z is up, and y points away from the viewer.
  using Triple = std::array<std::uint32_t, 3>;
  struct Stored {
    Triple size{};
    std::vector<std::array<std::uint8_t, 4>> voxels;  // x, y, z and colour
  };

  [[nodiscard]] std::string_view text(std::size_t at, std::size_t count) const {
    return {reinterpret_cast<const char*>(bytes_.data()) + at, count};
  }
  [[nodiscard]] std::uint32_t number(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes_[at + i]) << 8 * i;
    return value;
  }
  static std::string cut(std::size_t at) { return "ends within the part at byte " + std::to_string(at); }
  static std::string name(std::size_t model) { return "model " + std::to_string(model + 1); }
  [[nodiscard]] std::string model() const { return name(stored_.size()); }

  Refusal read_size(std::size_t at, std::size_t content) {
    if (size_ || content < 12) return model() + " has a SIZE that no voxels follow, or a short one";
    size_ = {number(at), number(at + 4), number(at + 8)};
    return std::nullopt;
  }

  Refusal read_voxels(std::size_t at, std::size_t content) {
    if (!size_ || content < 4)
      return model() + " has voxels without a SIZE before them, or an XYZI that is too short";
    const auto [width, depth, height] = *size_;
    const std::size_t count = number(at);
    if (count > (content - 4) / 4 || count > std::size_t{width} * depth * height) {
      return model() + " has " + std::to_string(count) + " voxels, more than its size or the file holds";
    }
    Stored& stored = stored_.emplace_back(Stored{*size_, {}});
    stored.voxels.resize(count);
    if (count > 0) std::memcpy(stored.voxels.data(), bytes_.data() + at + 4, 4 * count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& voxel = stored.voxels[i];
      if (voxel[0] >= width || voxel[1] >= depth || voxel[2] >= height || voxel[3] == 0) {
        return name(stored_.size() - 1) + ": voxel " + std::to_string(i + 1) +
               " is outside its size or has colour 0";
      }
    }
    size_.reset();
    return std::nullopt;
  }

  // MagicaVoxel's palette shows colour order[i] at number i + 1.
  Refusal read_order(std::size_t at, std::size_t content) {
    if (content < number_of_.size()) return "has an IMAP that is too short";
    for (std::size_t i = 0; i + 1 < number_of_.size(); ++i) {
      number_of_[std::to_integer<std::size_t>(bytes_[at + i])] = static_cast<std::uint8_t>(i + 1);
    }
    return std::nullopt;
  }

  // Empty and hidden models are passed over, unless there are no others.
  Refusal show() {
    scene_.finish();
    for (std::size_t i = 0; i < stored_.size(); ++i) {
      const auto pose = scene_.pose_of(i);
      if (!pose) return name(i) + " is in a scene graph that is a cycle, or too large";
      if (stored_[i].voxels.empty() || pose->hidden) continue;
      if (models.size() == static_cast<std::size_t>(bounds_.models)) {
        return "has more than " + std::to_string(bounds_.models) +
               (bounds_.models == 1 ? " model" : " models");
      }
      if (auto refused = show(i, pose->rotation)) return refused;
    }
    return models.empty() ? show(0, {}) : std::nullopt;
  }

  Refusal show(std::size_t i, const VoxRotation& rotation) {
    const auto& [from, reversed] = rotation;
    const Triple& stored = stored_[i].size;
    const Triple size{stored[from[0]], stored[from[1]], stored[from[2]]};
    if (auto refused = wrong_size(i, size)) return refused;
    const auto [width, depth, height] = size;
    terrain::VoxelModel made{static_cast<int>(width), static_cast<int>(height), static_cast<int>(depth), {}};
    made.voxels.reserve(stored_[i].voxels.size());
    for (const auto& voxel : stored_[i].voxels) {
      Triple at{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at[axis] = reversed[axis] ? size[axis] - 1 - voxel[from[axis]] : voxel[from[axis]];
      }
      made.voxels.push_back({static_cast<std::uint8_t>(at[0]), static_cast<std::uint8_t>(at[2]),
                             static_cast<std::uint8_t>(depth - 1 - at[1]), number_of_[voxel[3]]});
    }
    models.push_back(std::move(made));
    return std::nullopt;
  }

  [[nodiscard]] Refusal wrong_size(std::size_t i, const Triple& size) const {
    const std::array<int, 3> most{bounds_.width, bounds_.width, bounds_.height};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (size[axis] >= 1 && size[axis] <= static_cast<std::uint32_t>(most[axis])) continue;
      return name(i) + " has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " voxels, " +
             std::to_string(size[2]) + " high; at most " + std::to_string(most[0]) + " x " +
             std::to_string(most[1]) + ", " + std::to_string(most[2]) + " high";
    }
    return std::nullopt;
  }

  static std::array<std::uint8_t, 256> file_order() {
    std::array<std::uint8_t, 256> numbers{};
    for (std::size_t colour = 0; colour < numbers.size(); ++colour) {
      numbers[colour] = static_cast<std::uint8_t>(colour);
    }
    return numbers;
  }

  std::span<const std::byte> bytes_;
  const ModelBounds bounds_;
  std::optional<Triple> size_;
  std::vector<Stored> stored_;
  std::array<std::uint8_t, 256> number_of_ = file_order();  // in the editor's palette, by colour in the file
  VoxScene scene_;
};

}  // namespace

tl::expected<std::vector<terrain::VoxelModel>, std::string> decode_vox(std::span<const std::byte> bytes,
                                                                       const ModelBounds& bounds) {
  VoxReader reader{bytes, bounds};
  if (auto refused = reader.read()) return tl::unexpected{*std::move(refused)};
  return std::move(reader.models);
}

}  // namespace talus::world_files
