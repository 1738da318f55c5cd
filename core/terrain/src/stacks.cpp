#include <talus/terrain/stacks.h>

namespace talus::terrain {

MaterialId Stacks::shown(const World& world, std::size_t plane, int x, int z) const {
  const World::ShownBy* const by = world.shown_by(materials[plane]);
  return by == nullptr ? materials[plane] : by->by_look[looks[by->looks].at(x, z)];
}

std::size_t Stacks::bytes() const {
  const auto bytes_of = [](const Field& field) { return field.values.capacity() * sizeof(std::int32_t); };
  std::size_t bytes = sizeof(Stacks) + materials.size() * sizeof(MaterialId) +
                      (tops.size() + surveys.size()) * sizeof(Field) + bytes_of(caves.floor) +
                      bytes_of(caves.roof);
  for (const Field& plane : tops) bytes += bytes_of(plane);
  for (const Field& survey : surveys) bytes += bytes_of(survey);
  bytes += objects.capacity() * sizeof(PlacedObject);
  for (const LookField& look : looks) bytes += sizeof look + look.values.capacity();
  return bytes;
}

}  // namespace talus::terrain
