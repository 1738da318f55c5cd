// The place where a group builds: whose voxels are which, and what is written next.
#include "edit_site.h"

#include <set>

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::load;

namespace {

constexpr MaterialId kBrick{9};

}  // namespace

TEST_CASE("every voxel of a site belongs to one builder and to one chunk") {
  const EditSite site{{-1000.5, 33, 77}, 5, kBrick};
  REQUIRE(site.size() == 5 * EditSite::kFloor);
  std::set<VoxelPos> voxels;
  for (std::size_t index = 0; index < site.size(); ++index) {
    const VoxelPos at = site.voxel(index);
    CHECK(voxels.insert(at).second);
    CHECK(at.y == 29 + EditSite::builder_of(index));
  }
  std::size_t cells = 0;
  for (const EditSite::Part& part : site.parts()) {
    for (const auto& [index, cell] : part.cells) {
      CHECK(chunk_holding(site.voxel(cell), Lod{})->coord == part.chunk);
      CHECK(voxel_index(local_pos(site.voxel(cell))) == index);
    }
    cells += part.cells.size();
  }
  CHECK(site.parts().size() == 2);  // rows 29 to 33
  CHECK(cells == site.size());
}

TEST_CASE("voxels below the ground are dug first, voxels above are built first, and then in turn") {
  EditSite site{{0, 102, 0}, 2, kBrick};
  CHECK(site.voxel(0).y == 99);
  CHECK(site.next(0) == kAir);
  CHECK(site.next(EditSite::kFloor) == kBrick);
  site.cell(0).written = kAir;
  site.cell(0).is_written = true;
  CHECK(site.next(0) == kBrick);
  site.cell(0).written = kBrick;
  CHECK(site.next(0) == kAir);
}

TEST_CASE("a voxel is settled when its last write was answered and its outcome is known") {
  EditSite::Cell cell;
  CHECK_FALSE(cell.settled());
  cell.is_written = cell.open = true;
  CHECK_FALSE(cell.settled());
  cell.open = false;
  CHECK(cell.settled());
  cell.certain = false;
  CHECK_FALSE(cell.settled());
}
