// Which chunks are made here next, which of them are compared, and edits that wait for them.
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "make_queue.h"
#include "peer.h"
#include "pending_edits.h"
#include "proofs.h"

namespace talus::client {
namespace {

using testing::key_at;

std::vector<ChunkKey> chunks_of(const View& view) {
  std::vector<ChunkKey> keys;
  ViewShape{view}.for_each([&](const ChunkKey& key) { keys.push_back(key); });
  return keys;
}

std::vector<Proofs::Proof> proofs_of(int from, int count) {
  std::vector<Proofs::Proof> list;
  for (int i = from; i < from + count; ++i) list.push_back({key_at(i, 0, 0), {}});
  return list;
}

}  // namespace

TEST_CASE("chunks are made nearest first, each once, with those of their patch that are little farther") {
  View view;
  view.centre = {16, 16, 16};
  view.direction = {1, 0, 0};
  view.horizontal_radius = 6;
  view.vertical_radius = 6;
  view.rings = {{Lod::of(1), 14}};
  const auto wanted = chunks_of(view);
  MakeQueue queue{view, wanted};
  const ViewOrder order{{0, 0, 0}, view.direction};
  std::set<ChunkKey> made;
  std::uint64_t nearest_before = 0;
  while (!queue.empty()) {
    const auto batch = queue.next();
    REQUIRE_FALSE(batch.empty());
    CHECK(order.rank(batch[0]) >= nearest_before);
    nearest_before = order.rank(batch[0]);
    for (const ChunkKey& key : batch) {
      CHECK(made.insert(key).second);
      CHECK(key.lod == batch[0].lod);
      CHECK((key.coord.x >> 2) == (batch[0].coord.x >> 2));
      CHECK((key.coord.z >> 2) == (batch[0].coord.z >> 2));
      CHECK(ViewOrder::ring_of(order.rank(key)) <=
            ViewOrder::ring_of(nearest_before) + (MakeQueue::kFarther << key.lod.value()));
    }
  }
  CHECK(made == std::set<ChunkKey>{wanted.begin(), wanted.end()});
  CHECK(MakeQueue{view, wanted}.next().front() == key_at(0, 0, 0));
  CHECK(queue.next().empty());
}

TEST_CASE(
    "sixteen proofs come from the 1st, 4th, 9th and 16th batch, and four of one batch for each 4,000 chunks "
    "after") {
  Proofs proofs{7};
  std::vector<int> batches;
  std::set<ChunkKey> chosen;
  for (int batch = 1; batch <= 20; ++batch) {
    const auto some = proofs.made(10, proofs_of(batch * 10, 10), false);
    if (!some.empty()) batches.push_back(batch);
    for (const auto& proof : some) chosen.insert(proof.key);
  }
  CHECK(batches == std::vector<int>{1, 4, 9, 16});
  CHECK(chosen.size() == kFirstProofs);
  std::size_t more = 0;
  for (int batch = 0; batch < 100; ++batch) {
    const std::size_t chosen_here = proofs.made(100, proofs_of(batch * 10, 6), false).size();
    CHECK((chosen_here == 0 || chosen_here == kProofsTogether));
    more += chosen_here;
  }
  CHECK(more == 2 * kProofsTogether);
  proofs.begin();
  CHECK(proofs.made(5, {}, false).empty());
  CHECK(proofs.made(5, proofs_of(0, 3), false).size() == 3);
}

TEST_CASE("where few batches are made, proofs come from all their chunks, each once") {
  Proofs proofs{7};
  const auto chosen = proofs.made(30, proofs_of(0, 30), false);
  const auto rest = proofs.made(100, proofs_of(30, 100), true);
  CHECK(chosen.size() + rest.size() == kFirstProofs);
  std::set<ChunkKey> all;
  for (const auto& proof : chosen) all.insert(proof.key);
  for (const auto& proof : rest) all.insert(proof.key);
  CHECK(all.size() == kFirstProofs);
  CHECK(std::any_of(rest.begin(), rest.end(), [](const auto& proof) { return proof.key.coord.x < 30; }));
  CHECK(proofs.made(1, proofs_of(200, 1), true).empty());
  proofs.repeat();
  CHECK(proofs.made(1, proofs_of(200, 1), true).size() == 1);
}

TEST_CASE("edits wait in order, and a chunk with too many of them does not wait") {
  PendingEdits edits;
  const ChunkKey key = key_at(0, 0, 0);
  CHECK(edits.add(key, 0, 3, {{1, MaterialId{2}}}));
  CHECK(edits.add(key, 2, 3, {{1, MaterialId{9}}}));  // not newer
  CHECK(edits.add(key, 3, 5, {{1, MaterialId{4}}}));
  REQUIRE(edits.find(key) != nullptr);
  CHECK(edits.find(key)->revision == 5);
  CHECK(edits.find(key)->voxels.size() == 2);
  CHECK(edits.add(key, 0, 6, {{7, MaterialId{4}}}));  // has all
  CHECK(edits.find(key)->voxels.size() == 1);
  CHECK_FALSE(edits.add(key, 8, 9, {}));
  CHECK(edits.empty());
  CHECK_FALSE(edits.add(key, 1, 2, {}));
  const std::vector<Override> many(40'000);
  CHECK(edits.add(key, 0, 1, many));
  CHECK_FALSE(edits.add(key, 1, 2, many));
  CHECK(edits.empty());
}

}  // namespace talus::client
