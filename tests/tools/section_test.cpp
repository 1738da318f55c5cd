#include "section.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

namespace {

Image section_of(const terrain::Region& line, const SectionOptions& options = {}) {
  ProgressBar progress{"section", "columns"};
  auto image = render_section(terrain::default_world(), line, options, progress);
  REQUIRE(image);
  return std::move(*image);
}

}  // namespace

TEST_CASE("A section's scale enlarges voxels and nothing else") {
  const terrain::Region line{-40, 7, 80, 1, Lod{}};
  const Image plain = section_of(line);
  const Image large = section_of(line, {.scale = 3});
  REQUIRE(large.width == plain.width * 3);
  REQUIRE(large.height == plain.height * 3);
  // The lowest row is rock in both; the sky's gradient may differ.
  for (int x = 0; x < large.width; ++x) {
    CHECK(large.at(x, large.height - 1) == plain.at(x / 3, plain.height - 1));
  }
}

TEST_CASE("Sections along x and z through one column show the same column") {
  const Image along_x = section_of({100, 200, 1, 1, Lod{}});
  const Image along_z = section_of({100, 200, 1, 1, Lod{}}, {.threads = 2});
  CHECK(along_x.rgb == along_z.rgb);
  const Image southward = section_of({100, 190, 1, 20, Lod{}});
  const Image eastward = section_of({90, 200, 20, 1, Lod{}});
  for (int up = 1; up <= 8; ++up) {
    CHECK(southward.at(10, southward.height - up) == eastward.at(10, eastward.height - up));
  }
}
