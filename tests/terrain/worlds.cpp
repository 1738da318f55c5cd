#include "worlds.h"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "made_height_map.h"

namespace talus::test {
namespace {

terrain::World parsed(const std::string& text, const std::string& name) {
  auto world = terrain::World::parse(text, name, made_height_maps());
  if (!world) throw std::runtime_error(world.error().message);
  return *std::move(world);
}

std::string text_of_file(const std::string& name) {
  const std::string path = std::string{TALUS_SOURCE_DIR} + "/" + name;
  std::ifstream file{path};
  if (!file) throw std::runtime_error("cannot open " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

std::string sample_world_text(const std::string& name) {
  return text_of_file("core/worlds/" + name + ".toml");
}

std::string sample_world_without(const std::string& name, const std::vector<std::string>& tables) {
  std::string text = sample_world_text(name);
  for (const std::string& table : tables) {
    for (;;) {
      const std::size_t begin = text.find("\n" + table + "\n");
      if (begin == std::string::npos) break;
      text.erase(begin, text.find("\n\n", begin + 1) - begin);
    }
  }
  return text;
}

std::string regions_world_text() {
  const std::string document = text_of_file("docs/WORLDS.md");
  const std::string begins = "```toml\n";
  const std::size_t begin = document.find(begins) + begins.size();
  return document.substr(begin, document.find("```", begin) - begin);
}

const terrain::World& sample_world(const std::string& name) {
  static std::map<std::string, terrain::World> worlds;
  const auto found = worlds.find(name);
  if (found != worlds.end()) return found->second;
  return worlds.emplace(name, parsed(sample_world_text(name), name + ".toml")).first->second;
}

std::string small_world_text(std::uint64_t seed) {
  return "seed = " + std::to_string(static_cast<std::int64_t>(seed)) + R"(
resolution = 40
strata_wavelength = 1.5
sea_level = 0.3
[surface]
wavelength = 2.0
octaves = 5
gain = 1.0
exponent = 2
amplitude = 2.5
[[stratified]]
name = "basalt"
colour = "#444444"
depth = 2.0
thickness = 0.5
roughness = 0.4
[[stratified]]
name = "chalk"
colour = "#eeeeee"
depth = 1.2
thickness = 0.1
roughness = 1.5
[[stratified]]
name = "clay"
colour = "#aa5533"
depth = 0.9
thickness = 0.3
roughness = 0.0
[[stratified]]
name = "limestone"
colour = "#ccccaa"
depth = 0.2
thickness = 0.2
roughness = 0.9
[[eroded]]
name = "gravel"
colour = "#888888"
weight = 2
thickness = 0.20
angle_of_repose = 38
max_slope = 50
[[eroded]]
name = "sand"
colour = "#ddcc88"
weight = 1
thickness = 0.15
angle_of_repose = 30
max_slope = 35
[[eroded]]
name = "soil"
colour = "#66aa44"
weight = 1
thickness = 0.05
angle_of_repose = 20
max_slope = 60
)";
}

std::string underground_text() {
  return R"([folds]
amplitude = 0.6
wavelength = 1.6
octaves = 2
strike = 30
stretch = 4
[[faults]]
strike = 20
spacing = 0.9
throw = 0.5
waviness = 0.1
[[faults]]
strike = 115
spacing = 1.7
throw = 0.4
[[veins]]
name = "coal"
colour = "#101014"
shape = "vein"
low = 0.1
high = 2.4
size = 0.9
thickness = 0.06
abundance = 0.9
[[veins]]
name = "gold"
colour = "#ffd020"
shape = "pocket"
low = 0
high = 1.6
size = 0.3
abundance = 0.4
[[veins]]
name = "opal"
colour = "#20e080"
shape = "pocket"
low = 0.2
high = 2.5
size = 0.12
abundance = 0.2
)";
}

terrain::World small_world(std::uint64_t seed) {
  return parsed(small_world_text(seed), "small.toml");
}

std::string small_caves_text(std::uint64_t seed, int erosion_steps) {
  const std::string method =
      erosion_steps == 0 ? ""
                         : "method = \"erosion\"\nerosion_steps = " + std::to_string(erosion_steps) + "\n";
  return method + small_world_text(seed) + R"([caves]
low = 0.1
high = 1.3
climb_wavelength = 3.0
wavelength = 1.5
width = 0.2
height = 0.25
chamber_wavelength = 1.2
chamber_threshold = 0.25
chamber_height = 0.6
roof = 0.05
span = 0.4
)";
}

terrain::World small_caves(std::uint64_t seed, int erosion_steps) {
  return parsed(small_caves_text(seed, erosion_steps), "caves.toml");
}

std::string small_world_text(std::uint64_t seed, const std::string& surface) {
  const std::string noise = "wavelength = 2.0\noctaves = 5\ngain = 1.0\nexponent = 2\n";
  const std::string map = "[surface.height_map]\nfile = \"made.png\"\nx = -1.3\nz = 0.7\nspacing = 0.21\n";
  std::string text = "[surface]\namplitude = 2.5\n";
  if (surface == "ridged") {
    text += "kind = \"ridged\"\nfeedback = 3\n" + noise;
  } else if (surface == "warped") {
    text += "kind = \"warped\"\nwarp = 0.8\nwarp_wavelength = 2.4\n" + noise;
  } else if (surface == "blend") {
    text += "kind = \"height_map\"\n" + noise + map + "outside = \"blend\"\nmargin = 1.5\n";
  } else {
    text += "kind = \"height_map\"\n" + map + "spacing_z = 0.17\noutside = \"" + surface + "\"\n";
  }
  const std::string whole = small_world_text(seed);
  return whole.substr(0, whole.find("[surface]")) + text + whole.substr(whole.find("[[stratified]]"));
}

terrain::World small_world(std::uint64_t seed, const std::string& surface) {
  return parsed(small_world_text(seed, surface), surface + ".toml");
}

}  // namespace talus::test
