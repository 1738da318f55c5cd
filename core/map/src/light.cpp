#include <talus/map/light.h>

#include <talus/pictures/srgb.h>

namespace talus::map {

glm::vec3 to_light(terrain::Colour colour) {
  return {pictures::light_of(colour.red), pictures::light_of(colour.green), pictures::light_of(colour.blue)};
}

terrain::Colour to_colour(glm::vec3 light) {
  return {pictures::channel_of(light.x), pictures::channel_of(light.y), pictures::channel_of(light.z)};
}

std::vector<glm::vec3> material_lights(const terrain::World& world, std::span<const terrain::Material> more) {
  std::vector<glm::vec3> lights;
  for (const terrain::Material& material : world.materials()) lights.push_back(to_light(material.colour));
  for (const terrain::Material& material : more) {
    const std::size_t id = to_integer(material.id);
    if (lights.size() <= id) lights.resize(id + 1);
    lights[id] = to_light(material.colour);
  }
  return lights;
}

}  // namespace talus::map
