#include "vox_reader.h"

#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace vox_reader {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error{what};
}

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_{bytes} {}
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  std::string_view take(std::size_t count) {
    require(count <= rest_.size(), "the file ends inside a chunk");
    const auto taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  int byte() { return static_cast<unsigned char>(take(1)[0]); }
  std::int32_t number() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(byte()) << (8 * i);
    return static_cast<std::int32_t>(value);
  }
  std::size_t count() {
    const std::int32_t value = number();
    require(value >= 0, "a negative count");
    return static_cast<std::size_t>(value);
  }
  std::map<std::string, std::string> dictionary() {
    std::map<std::string, std::string> entries;
    for (std::size_t left = count(); left > 0; --left) {
      const std::string key{take(count())};
      entries[key] = take(count());
    }
    return entries;
  }

 private:
  std::string_view rest_;
};

struct Model {
  std::array<int, 3> size{};
  std::vector<std::array<int, 4>> voxels;
};

struct Transform {
  int child = 0;
  std::array<int, 3> translation{};
};

struct File {
  std::vector<Model> models;
  std::map<int, Transform> transforms;
  std::map<int, std::vector<int>> groups;
  std::map<int, int> shapes;
  std::array<std::uint32_t, 256> palette{};
  std::map<int, std::map<std::string, std::string>> materials;
  std::set<std::string> kinds;
};

void read_size(Bytes& content, File& file) {
  Model model;
  for (int& side : model.size) {
    side = content.number();
    require(side >= 1 && side <= 256, "SIZE: a side outside 1 to 256");
  }
  require(file.models.empty() || !file.models.back().voxels.empty(), "SIZE without XYZI");
  file.models.push_back(model);
}

void read_voxels(Bytes& content, File& file) {
  require(!file.models.empty() && file.models.back().voxels.empty(), "XYZI without SIZE");
  Model& model = file.models.back();
  for (std::size_t left = content.count(); left > 0; --left) {
    std::array<int, 4> voxel{};
    for (int& item : voxel) item = content.byte();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      require(voxel[axis] < model.size[axis], "XYZI: a voxel outside SIZE");
    }
    require(voxel[3] > 0, "XYZI: palette index 0");
    model.voxels.push_back(voxel);
  }
}

void read_palette(Bytes& content, File& file) {
  // The file's first colour is that of index 1; its last is not used.
  for (std::size_t i = 0; i < 256; ++i) {
    const auto rgba = static_cast<std::uint32_t>(content.number());
    if (i < 255) file.palette[i + 1] = rgba;
  }
}

void read_material(Bytes& content, File& file) {
  const int index = content.number();
  require(index >= 1 && index <= 256, "MATL: a palette index outside 1 to 256");
  const auto properties = content.dictionary();
  const std::set<std::string> types{"_diffuse", "_metal", "_glass", "_emit", "_blend", "_media", "_cloud"};
  const auto type = properties.find("_type");
  require(type != properties.end() && types.contains(type->second), "MATL: no type, or an unknown one");
  for (const auto& [key, value] : properties) {
    if (key == "_type") continue;
    std::size_t end = 0;
    const double number = std::stod(value, &end);
    require(end == value.size() && number >= 0, "MATL: " + key + " is not a number");
  }
  require(file.materials.emplace(index, properties).second, "MATL: a palette index twice");
}

void read_transform(Bytes& content, File& file) {
  const int node = content.number();
  content.dictionary();
  Transform transform;
  transform.child = content.number();
  require(content.number() == -1, "nTRN: the reserved id is not -1");
  content.number();  // layer
  require(content.number() == 1, "nTRN: not one frame");
  const auto frame = content.dictionary();
  require(!frame.contains("_r"), "nTRN: a rotation, which this reader does not know");
  if (const auto entry = frame.find("_t"); entry != frame.end()) {
    std::istringstream numbers{entry->second};
    for (int& item : transform.translation) require(static_cast<bool>(numbers >> item), "nTRN: a bad _t");
  }
  require(file.transforms.emplace(node, transform).second, "nTRN: a node id twice");
}

void read_group(Bytes& content, File& file) {
  const int node = content.number();
  content.dictionary();
  std::vector<int> children;
  for (std::size_t left = content.count(); left > 0; --left) children.push_back(content.number());
  require(file.groups.emplace(node, children).second, "nGRP: a node id twice");
}

void read_shape(Bytes& content, File& file) {
  const int node = content.number();
  content.dictionary();
  require(content.number() == 1, "nSHP: not one model");
  const int model = content.number();
  content.dictionary();
  require(file.shapes.emplace(node, model).second, "nSHP: a node id twice");
}

void read_chunk(Bytes& chunks, File& file) {
  const std::string kind{chunks.take(4)};
  Bytes content{std::string_view{}};
  const std::size_t content_bytes = chunks.count();
  require(chunks.count() == 0, kind + ": has children");
  content = Bytes{chunks.take(content_bytes)};
  if (kind == "SIZE") read_size(content, file);
  if (kind == "XYZI") read_voxels(content, file);
  if (kind == "RGBA") read_palette(content, file);
  if (kind == "MATL") read_material(content, file);
  if (kind == "nTRN") read_transform(content, file);
  if (kind == "nGRP") read_group(content, file);
  if (kind == "nSHP") read_shape(content, file);
  require(content.empty(), kind + ": bytes left over, or an unexpected chunk");
  file.kinds.insert(kind);
}

// Puts what hangs under a node where the translations above it say.
void place(const File& file, int node, std::array<int, 3> at, std::set<int>& placed, Scene& scene) {
  if (const auto transform = file.transforms.find(node); transform != file.transforms.end()) {
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += transform->second.translation[axis];
    place(file, transform->second.child, at, placed, scene);
    return;
  }
  if (const auto group = file.groups.find(node); group != file.groups.end()) {
    for (const int child : group->second) place(file, child, at, placed, scene);
    return;
  }
  const auto shape = file.shapes.find(node);
  require(shape != file.shapes.end(), "a node that is not there");
  require(shape->second >= 0 && static_cast<std::size_t>(shape->second) < file.models.size(),
          "nSHP: a model that is not there");
  placed.insert(shape->second);
  const Model& model = file.models[static_cast<std::size_t>(shape->second)];
  for (const auto& voxel : model.voxels) {
    std::array<int, 3> where{};
    for (std::size_t axis = 0; axis < 3; ++axis) where[axis] = at[axis] - model.size[axis] / 2 + voxel[axis];
    require(scene.voxels.emplace(where, voxel[3]).second, "two voxels in one place");
  }
}

}  // namespace

Scene read(const std::string& bytes) {
  Bytes all{bytes};
  require(all.take(4) == "VOX ", "the file does not begin with 'VOX '");
  const int version = all.number();
  require(version == 150 || version == 200, "neither version 150 nor 200");
  require(all.take(4) == "MAIN", "no MAIN");
  require(all.number() == 0, "MAIN: has content");
  Bytes chunks{all.take(all.count())};
  require(all.empty(), "bytes after MAIN");

  File file;
  while (!chunks.empty()) read_chunk(chunks, file);
  for (const char* kind : {"SIZE", "XYZI", "nTRN", "nGRP", "nSHP", "RGBA"}) {
    require(file.kinds.contains(kind), std::string{"no "} + kind);
  }
  Scene scene;
  scene.models = file.models.size();
  scene.palette = file.palette;
  scene.materials = file.materials;
  std::set<int> placed;
  place(file, 0, {}, placed, scene);
  require(placed.size() == file.models.size(), "a model outside the scene");
  return scene;
}

}  // namespace vox_reader
