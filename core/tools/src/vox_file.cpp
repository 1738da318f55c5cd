#include "vox_file.h"

#include <bit>
#include <limits>
#include <string_view>
#include <utility>

#include <talus/files/path_text.h>

namespace talus::tools {
namespace {

constexpr std::int32_t kVersion = 150;
constexpr std::uint64_t kHeaderBytes = 8;        // "VOX ", version
constexpr std::uint64_t kChunkHeaderBytes = 12;  // name, bytes of content, bytes of children

// Content of a chunk: little-endian int32, strings with their length, dictionaries of strings.
class Content {
 public:
  Content& number(std::int32_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::byte>(bits >> shift));
    return *this;
  }
  Content& text(std::string_view text) {
    for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
    return *this;
  }
  Content& string(std::string_view value) {
    return number(static_cast<std::int32_t>(value.size())).text(value);
  }
  Content& dictionary(std::span<const std::pair<std::string_view, std::string>> entries) {
    number(static_cast<std::int32_t>(entries.size()));
    for (const auto& [key, value] : entries) string(key).string(value);
    return *this;
  }
  Content& nothing_in_dictionary() { return number(0); }
  Content& byte(std::uint8_t value) {
    bytes_.push_back(static_cast<std::byte>(value));
    return *this;
  }
  // A chunk without children.
  Content& chunk(std::string_view name, const Content& content) {
    text(name).number(static_cast<std::int32_t>(content.bytes_.size())).number(0);
    bytes_.insert(bytes_.end(), content.bytes_.begin(), content.bytes_.end());
    return *this;
  }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

// A transform node; the parent of every other node must be one.
Content transform(std::int32_t node, std::int32_t child, std::int32_t layer, const std::string& name,
                  const std::string& translation) {
  using Entry = std::pair<std::string_view, std::string>;
  const std::array attributes{Entry{"_name", name}};
  const std::array frame{Entry{"_t", translation}};
  constexpr std::int32_t kReserved = -1;
  constexpr std::int32_t kFrames = 1;
  Content content;
  content.number(node).dictionary(std::span{attributes}.first(name.empty() ? 0 : 1));
  content.number(child).number(kReserved).number(layer).number(kFrames);
  content.dictionary(std::span{frame}.first(translation.empty() ? 0 : 1));
  return content;
}

// Clear water, with the properties of every version that supports materials per palette index: 0.99 has a
// weight of glass, later ones a transparency and two notations of the refractive index.
Content water_material(std::int32_t index) {
  using Entry = std::pair<std::string_view, std::string>;
  const std::array properties{Entry{"_type", "_glass"}, Entry{"_weight", "0.7"}, Entry{"_alpha", "0.7"},
                              Entry{"_trans", "0.7"},   Entry{"_rough", "0.05"}, Entry{"_ior", "0.33"},
                              Entry{"_ri", "1.33"}};
  Content content;
  content.number(index).dictionary(properties);
  return content;
}

std::string to_text(glm::ivec3 vector) {
  return std::to_string(vector.x) + " " + std::to_string(vector.y) + " " + std::to_string(vector.z);
}

}  // namespace

Expected<VoxFile> VoxFile::create(const std::filesystem::path& target) {
  auto file = files::AtomicFile::create(target);
  if (!file) return tl::make_unexpected(file.error());
  VoxFile vox{std::move(*file)};
  vox.bytes_ = kHeaderBytes + kChunkHeaderBytes;  // written last, when the length is known
  return vox;
}

Expected<void> VoxFile::append(std::span<const std::byte> bytes) {
  constexpr std::uint64_t kMax = std::numeric_limits<std::int32_t>::max();
  if (bytes_ + bytes.size() > kMax) {
    return failed(
        files::to_text(file_.target()) +
        ": a .vox file holds at most 2 GiB; ask for a smaller --size or --depth, or a higher --lod");
  }
  if (auto written = file_.write_at(bytes_, bytes); !written) return outcome_of(written);
  bytes_ += bytes.size();
  return {};
}

Expected<void> VoxFile::add(const VoxModel& model) {
  if (model.voxels.empty()) return {};
  Content size;
  size.number(model.size.x).number(model.size.y).number(model.size.z);
  Content xyzi;
  xyzi.reserve(sizeof(std::int32_t) + model.voxels.size() * sizeof(VoxVoxel));
  xyzi.number(static_cast<std::int32_t>(model.voxels.size()));
  for (const VoxVoxel voxel : model.voxels) xyzi.byte(voxel.x).byte(voxel.y).byte(voxel.z).byte(voxel.colour);
  Content chunks;
  chunks.chunk("SIZE", size).chunk("XYZI", xyzi);
  // A translation moves the model's middle, which is rounded down for an odd side.
  placed_.push_back({model.name, model.corner + model.size / 2});
  return append(chunks.bytes());
}

Expected<void> VoxFile::finish(std::span<const terrain::Colour> colours, std::int32_t glass) {
  constexpr std::int32_t kRoot = 0;
  constexpr std::int32_t kGroup = 1;
  constexpr std::int32_t kNoLayer = -1;
  const auto transform_of = [](std::size_t model) { return static_cast<std::int32_t>(2 + 2 * model); };
  Content scene;
  scene.chunk("nTRN", transform(kRoot, kGroup, kNoLayer, "", ""));
  Content group;
  group.number(kGroup).nothing_in_dictionary().number(static_cast<std::int32_t>(placed_.size()));
  for (std::size_t i = 0; i < placed_.size(); ++i) group.number(transform_of(i));
  scene.chunk("nGRP", group);
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const std::int32_t shape = transform_of(i) + 1;
    scene.chunk("nTRN",
                transform(transform_of(i), shape, 0, placed_[i].name, to_text(placed_[i].translation)));
    Content content;
    content.number(shape).nothing_in_dictionary().number(1);
    scene.chunk("nSHP", content.number(static_cast<std::int32_t>(i)).nothing_in_dictionary());
  }
  Content palette;
  for (int i = 0; i < kVoxColours + 1; ++i) {
    const bool used = static_cast<std::size_t>(i) < colours.size();
    const terrain::Colour colour = used ? colours[static_cast<std::size_t>(i)] : terrain::Colour{};
    palette.byte(colour.red).byte(colour.green).byte(colour.blue).byte(used ? 255 : 0);
  }
  scene.chunk("RGBA", palette);
  scene.chunk("MATL", water_material(glass));
  if (auto done = append(scene.bytes()); !done) return done;

  Content header;
  header.text("VOX ").number(kVersion);
  header.text("MAIN").number(0).number(static_cast<std::int32_t>(bytes_ - kHeaderBytes - kChunkHeaderBytes));
  if (auto done = file_.write_at(0, header.bytes()); !done) return outcome_of(done);
  return outcome_of(file_.commit());
}

}  // namespace talus::tools
