#include <talus/terrain/stacks.h>

namespace talus::terrain {

std::size_t Stacks::bytes() const {
  const auto bytes_of = [](const Field& field) { return field.values.capacity() * sizeof(std::int32_t); };
  std::size_t bytes = sizeof(Stacks) + materials.size() * sizeof(MaterialId) +
                      (tops.size() + surveys.size()) * sizeof(Field) + bytes_of(caves.floor) +
                      bytes_of(caves.roof);
  for (const Field& plane : tops) bytes += bytes_of(plane);
  for (const Field& survey : surveys) bytes += bytes_of(survey);
  return bytes;
}

}  // namespace talus::terrain
