// Memory that runs out becomes a status, and tears nothing.
#include <talus_local.h>

#include <string>

#include <catch2/catch.hpp>

#include "failing_allocations.h"
#include "local_world.h"
#include "scratch_directory.h"

namespace {

// A wall over several chunks.
talus_status build(const Workspace& workspace, std::int64_t y) {
  const std::int64_t corners[]{-40, y, 0, 40, y, 0};
  const std::int32_t planks = 256;
  talus_edit edit{};
  edit.size = sizeof edit;
  edit.fill_count = 1;
  edit.fill_corners = corners;
  edit.fill_materials = &planks;
  return talus_apply_edit(workspace.get(), &edit, nullptr);
}

/// Calls `work`, which returns a status, with each of its allocations failing in turn.
template <typename Work>
void fail_each(const Work& work) {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    talus_status status = TALUS_OK;
    {
      const talus::test::FailingAllocations failing{allocations};
      status = work();
      failed = failing.has_failed();
    }
    INFO("the allocation after " << allocations << ": " << status << ", " << talus_local_error());
    // std::stable_sort does without its memory.
    REQUIRE((status == TALUS_OK || (failed && status == TALUS_OUT_OF_MEMORY)));
  }
}

}  // namespace

TEST_CASE("an allocation that fails ends a call and changes nothing") {
  const ScratchDirectory directory;
  const std::string file = (directory / "game.talus").string();
  {
    const LocalWorld world = open_world(kFlat);
    const Workspace workspace = workspace_of(world);
    REQUIRE(build(workspace, 40) == TALUS_OK);
    fail_each([&] { return talus_save_create(world.get(), file.c_str()); });
    // Of an edit that fails, either everything is there or nothing, and the save is whole.
    for (std::int64_t y = 41; y < 44; ++y) {
      const std::uint64_t before = info_of(world).revision;
      fail_each([&] { return build(workspace, y); });
      CHECK(info_of(world).revision == before + 1);
      fail_each([&] { return talus_save_commit(world.get()); });
    }
    const talus_chunk_key key{0, 1, 0, 0};
    fail_each([&] { return talus_generate(workspace.get(), &key, 1, 0, nullptr, nullptr); });
  }
  talus_local_world* again = nullptr;
  REQUIRE(talus_save_open(file.c_str(), 0, &again) == TALUS_OK);  // compares S
  const LocalWorld opened{again};
  CHECK(info_of(opened).revision == 4);
}
