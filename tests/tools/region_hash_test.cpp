#include "region_hash.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

namespace {

ContentHash hash_of(const terrain::Region& region, const HashOptions& options = {}) {
  ProgressBar progress{"hash", "chunk columns"};
  return hash_region(terrain::default_world(), region, options, progress);
}

}  // namespace

TEST_CASE("A region's hash does not depend on threads or patches") {
  for (const int level : {0, 4}) {
    const terrain::Region region{-70, 45, 200, 150, Lod::of(level)};
    const ContentHash expected = hash_of(region, {.threads = 1, .patch_chunks = 1});
    CHECK(hash_of(region, {.threads = 4, .patch_chunks = 1}) == expected);
    CHECK(hash_of(region, {.threads = 1, .patch_chunks = 4}) == expected);
    CHECK(hash_of(region, {.threads = 3, .patch_chunks = 3}) == expected);
    CHECK(hash_of(region, {.threads = 2, .patch_chunks = 64}) == expected);
  }
}

TEST_CASE("A region's hash covers whole chunks, so columns of one chunk name the same region") {
  CHECK(hash_of({0, 0, 1, 1, Lod{}}) == hash_of({0, 0, 32, 32, Lod{}}));
  CHECK(hash_of({31, 5, 1, 20, Lod{}}) == hash_of({0, 0, 32, 32, Lod{}}));
}

TEST_CASE("Other places and levels have other hashes") {
  const ContentHash here = hash_of({0, 0, 32, 32, Lod{}});
  CHECK(hash_of({32, 0, 32, 32, Lod{}}) != here);
  CHECK(hash_of({-32, 0, 32, 32, Lod{}}) != here);
  CHECK(hash_of({0, 32, 32, 32, Lod{}}) != here);
  CHECK(hash_of({0, 0, 33, 32, Lod{}}) != here);
  CHECK(hash_of({0, 0, 32, 32, Lod::of(1)}) != here);
}
