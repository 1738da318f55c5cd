#include "height_map_file.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/pictures/png.h>
#include <talus/tools/image.h>

namespace talus::tools {
namespace {

files::NpyType type_of(const std::vector<std::uint16_t>&) {
  return files::NpyType::uint16;
}
files::NpyType type_of(const std::vector<std::int32_t>&) {
  return files::NpyType::int32;
}
files::NpyType type_of(const std::vector<float>&) {
  return files::NpyType::float32;
}
files::NpyType type_of(const std::vector<std::uint8_t>&) {
  return files::NpyType::uint8;
}
files::NpyType type_of(const std::vector<double>&) {
  return files::NpyType::float64;
}

template <class Sample>
Expected<void> write_npy(const std::filesystem::path& target, const terrain::HeightMap& map,
                         const std::vector<Sample>& samples) {
  auto file = files::NpyFile::create(target, type_of(samples));
  if (!file) return tl::make_unexpected(file.error());
  if (auto written = file->write(0, std::span<const Sample>{samples}); !written) return outcome_of(written);
  const std::array shape{static_cast<std::size_t>(map.depth), static_cast<std::size_t>(map.width)};
  if (auto finished = file->finish(shape); !finished) return outcome_of(finished);
  return outcome_of(file->commit());
}

}  // namespace

Expected<void> check_height_map_name(const std::filesystem::path& target, const terrain::HeightMap& map) {
  if (target.extension() == ".npy") return {};
  if (target.extension() != ".png") {
    return wrong_use("--output: '" + target.string() + "' ends in neither .png nor .npy");
  }
  if (std::holds_alternative<std::vector<std::uint16_t>>(map.samples)) return {};
  return wrong_use("--output: a .png holds 16 bits a sample, and the input's have another size; give a .npy");
}

Expected<void> write_height_map(const std::filesystem::path& target, const terrain::HeightMap& map) {
  if (auto fits = check_height_map_name(target, map); !fits) return fits;
  if (target.extension() == ".npy") {
    return std::visit([&](const auto& samples) { return write_npy(target, map, samples); }, map.samples);
  }
  auto file = PngFile::create(target);
  if (!file) return tl::make_unexpected(file.error());
  const auto& samples = std::get<std::vector<std::uint16_t>>(map.samples);
  return file->write(pictures::PngImage{.width = map.width, .height = map.depth, .grey = samples});
}

}  // namespace talus::tools
