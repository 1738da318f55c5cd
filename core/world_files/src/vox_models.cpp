// MagicaVoxel's .vox files: 8 bytes, then chunks of id, bytes of content, bytes of children, and content.
// MAIN has all other chunks as children; SIZE and XYZI come in pairs, one per model.
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include <talus/world_files/world_files.h>

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
      if (refused) return refused;
      at = begin + content;
    }
    if (models.empty()) return "has no model";
    return std::nullopt;
  }

  std::vector<terrain::VoxelModel> models;

 private:
  [[nodiscard]] std::string_view text(std::size_t at, std::size_t count) const {
    return {reinterpret_cast<const char*>(bytes_.data()) + at, count};
  }
  [[nodiscard]] std::uint32_t number(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes_[at + i]) << 8 * i;
    return value;
  }
  static std::string cut(std::size_t at) { return "ends within the part at byte " + std::to_string(at); }
  [[nodiscard]] std::string model() const { return "model " + std::to_string(models.size() + 1); }

  Refusal read_size(std::size_t at, std::size_t content) {
    if (size_ || content < 12) return model() + " has a SIZE that no voxels follow, or a short one";
    size_ = {number(at), number(at + 4), number(at + 8)};
    const std::array<int, 3> most{bounds_.width, bounds_.width, bounds_.height};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t side = (*size_)[axis];
      if (side >= 1 && side <= static_cast<std::uint32_t>(most[axis])) continue;
      return model() + " has " + std::to_string((*size_)[0]) + " x " + std::to_string((*size_)[1]) +
             " voxels, " + std::to_string((*size_)[2]) + " high; at most " + std::to_string(most[0]) + " x " +
             std::to_string(most[1]) + ", " + std::to_string(most[2]) + " high";
    }
    return std::nullopt;
  }

  Refusal read_voxels(std::size_t at, std::size_t content) {
    if (!size_ || content < 4)
      return model() + " has voxels without a SIZE before them, or an XYZI that is too short";
    if (models.size() == static_cast<std::size_t>(bounds_.models)) {
      return "has more than " + std::to_string(bounds_.models) + (bounds_.models == 1 ? " model" : " models");
    }
    const auto [width, depth, height] = *size_;
    const std::size_t count = number(at);
    if (count > (content - 4) / 4 || count > std::size_t{width} * depth * height) {
      return model() + " has " + std::to_string(count) + " voxels, more than its size or the file holds";
    }
    terrain::VoxelModel made{static_cast<int>(width), static_cast<int>(height), static_cast<int>(depth), {}};
    made.voxels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<std::uint8_t, 4> voxel{};  // x, y, z and colour; z is up, and y points away from the viewer
      std::memcpy(voxel.data(), bytes_.data() + at + 4 + 4 * i, voxel.size());
      if (voxel[0] >= width || voxel[1] >= depth || voxel[2] >= height || voxel[3] == 0) {
        return model() + ": voxel " + std::to_string(i + 1) + " is outside its size or has colour 0";
      }
      made.voxels.push_back({voxel[0], voxel[2], static_cast<std::uint8_t>(depth - 1 - voxel[1]), voxel[3]});
    }
    models.push_back(std::move(made));
    size_.reset();
    return std::nullopt;
  }

  std::span<const std::byte> bytes_;
  const ModelBounds bounds_;
  std::optional<std::array<std::uint32_t, 3>> size_;
};

}  // namespace

tl::expected<std::vector<terrain::VoxelModel>, std::string> decode_vox(std::span<const std::byte> bytes,
                                                                       const ModelBounds& bounds) {
  VoxReader reader{bytes, bounds};
  if (auto refused = reader.read()) return tl::unexpected{*std::move(refused)};
  return std::move(reader.models);
}

}  // namespace talus::world_files
