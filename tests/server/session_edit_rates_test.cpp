// What a session's edits cost: rates of voxels, of new chunks and of editors, and memory.
#include "player/session/session.h"

#include <array>
#include <limits>

#include <talus/voxel/codec.h>

#include "editing_bench.h"
#include "edits/admission/wire_edit.h"
#include "session_bench.h"

namespace talus::server {
namespace {

using namespace std::chrono_literals;
using wire::Body;
using wire::ErrorCode;
using State = Session::State;

RateLimits voxels(Rate session, Rate address = {}) {
  RateLimits limits;
  limits.session.voxels = session;
  limits.address.voxels = address;
  return limits;
}

}  // namespace

TEST_CASE("voxels over the rate are refused with a time, and the edit does not happen") {
  EditingBench shared{voxels({10, 20})};
  shared.attached();
  for (std::uint32_t id = 1; id <= 21; ++id) shared.bench.write_voxel(id, id);
  CHECK(shared.taker.edits.size() == 20);
  const auto said = shared.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::overloaded);
  CHECK(said[0].id == 21);
  CHECK(said[0].retry_after_ms == 100);
  CHECK(shared.bench.metrics.throttled(RateKind::session_voxels).total() == 1);
  shared.bench.clock.advance(100ms);
  shared.bench.write_voxel(22, 22);
  CHECK(shared.taker.edits.size() == 21);
}

TEST_CASE("chunks never edited before cost their address, each once") {
  RateLimits limits;
  limits.address.new_chunks = {1, 3 * kNewChunkTokens};  // three saved up, and one an hour
  EditingBench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.attached();
  std::uint32_t id = 0;
  const auto edit = [&](std::int64_t chunk) {
    ++id;
    shared.bench.write_voxel(id, id, {chunk * 32, 0, 0});
    const auto said = shared.bench.output();
    return said.empty() ? std::string{"taken"} : said.at(0).text;
  };
  shared.bench.source.revisions[chunk_at(9)] = 4;
  CHECK(edit(1) == "taken");
  CHECK(edit(2) == "taken");
  CHECK(edit(1) == "taken");  // paid, though nothing is applied yet
  CHECK(edit(3) == "taken");
  CHECK(edit(4) == "over rates.address_new_chunks");
  CHECK(edit(9) == "taken");  // edited before
  CHECK(edit(2) == "taken");
  CHECK(shared.taker.edits.size() == 6);
  CHECK(shared.bench.metrics.throttled(RateKind::address_new_chunks).total() == 1);
  shared.bench.clock.advance(1h);
  CHECK(edit(4) == "taken");
  CHECK(edit(5) == "over rates.address_new_chunks");
}

TEST_CASE("guards pay for the ground that they need as writes do, whatever becomes of the edit") {
  RateLimits limits;
  limits.address.new_chunks = {1, 3 * kNewChunkTokens};
  EditingBench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.attached();
  const auto guard = [&](std::uint32_t id, const std::vector<std::int64_t>& chunks) {
    shared.bench.receive([&](auto& builder) {
      std::vector<wire::VoxelWrite> guards;
      for (const std::int64_t chunk : chunks) guards.push_back({{chunk * 32, 0, 0}, 1});
      const auto list = builder.CreateVectorOfStructs(guards);
      return wire::CreateEdit(builder, id, 0, id, list);
    });
  };
  guard(1, {1, 2, 3});
  REQUIRE(shared.taker.edits.size() == 1);
  CHECK(shared.answered({1, tl::unexpected{EditError{EditErrorCode::conflict, "guard 0"}}}).code ==
        ErrorCode::conflict);
  guard(2, {1, 2, 3});
  CHECK(shared.taker.edits.size() == 2);
  guard(3, {4});
  CHECK(shared.taker.edits.size() == 2);
  CHECK(shared.bench.output().at(0).text == "over rates.address_new_chunks");
}

TEST_CASE("an edit pays for the new chunks that loose material may slide into") {
  RateLimits limits;
  limits.address.new_chunks = {1, 12 * kNewChunkTokens};
  EditingBench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.taker.slides = true;
  shared.attached();
  shared.bench.write_voxel(1, 1, {0, 40, 0});  // at the corner of four columns, and 64 rows
  CHECK(shared.taker.edits.size() == 1);
  shared.bench.write_voxel(2, 2, {320, 40, 0});
  CHECK(shared.taker.edits.size() == 1);
}

TEST_CASE("an edit pays for the new chunks that it may reveal ore in") {
  RateLimits limits;
  limits.address.new_chunks = {1, 5 * kNewChunkTokens};
  EditingBench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.taker.has_secrets = true;
  shared.attached();
  shared.bench.write_voxel(1, 1, {0, 40, 31});  // at two faces of its chunk: three to pay
  REQUIRE(shared.taker.edits.size() == 1);
  CHECK(shared.taker.edits[0].extent.beside_chunks == std::vector<ChunkCoord>{{-1, 1, 0}, {0, 1, 1}});
  shared.bench.write_voxel(2, 2, {-5, 40, 5});  // paid
  CHECK(shared.taker.edits.size() == 2);
  shared.bench.write_voxel(3, 3, {320, 40, 31});
  CHECK(shared.taker.edits.size() == 2);
  CHECK(shared.bench.output().at(0).text == "over rates.address_new_chunks");
  shared.bench.write_voxel(4, 4, {325, 40, 5});  // reaches no other
  CHECK(shared.taker.edits.size() == 3);
}

TEST_CASE("an address may create a limited number of editors an hour, and existing ones continue") {
  RateLimits limits;
  limits.address.editors = {1, 2 * kEditorTokens};  // two saved up, and one an hour
  EditingBench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  const auto attach = [&](edits::EditorId editor) {
    shared.taker.attaches.clear();
    shared.bench.attach(editor);
    const auto said = shared.bench.output();
    if (shared.taker.attaches.empty()) return said.at(0).text;
    // Another session comes; this one is as it was.
    shared.bench.mailbox->put(AttachAnswer{tl::unexpected{EditError{EditErrorCode::busy, "not now"}}});
    shared.bench.take_mail();
    (void)shared.bench.output();
    return std::string{"made"};
  };
  CHECK(attach({}) == "made");
  CHECK(attach({1, 2}) == "made");  // unknown, so another is made
  CHECK(attach({}) == "over rates.address_editors");
  CHECK(attach({1, 2}) == "over rates.address_editors");
  CHECK(attach({7, 7}) == "made");  // known, so none is
  CHECK(shared.bench.metrics.throttled(RateKind::address_editors).total() == 2);
}

TEST_CASE("if the editor table is full, an Attach is not charged to its address") {
  RateLimits limits;
  limits.address.editors = {1, kEditorTokens};  // one saved up, and one an hour
  EditingBench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.taker.full = EditError{EditErrorCode::editors_full, "full"};
  for (int tries = 0; tries < 3; ++tries) {
    shared.bench.attach();
    const auto said = shared.bench.output();
    REQUIRE(kinds(said) == Kinds{Body::Error});
    CHECK(said[0].about == wire::ErrorAbout::attach);
    CHECK(said[0].text == "full");
    CHECK(said[0].retry_after_ms == 120'000);
  }
  CHECK(shared.taker.attaches.empty());
  shared.taker.full.reset();
  shared.bench.attach();
  CHECK(shared.bench.output().empty());
  CHECK(shared.taker.attaches.size() == 1);

  EditingBench known{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  known.taker.full = EditError{EditErrorCode::editors_full, "full"};
  known.bench.attach({7, 7});
  CHECK(known.taker.attaches.size() == 1);
}

TEST_CASE("a gateway has rates of its own, which replace the rates of a player and of its address") {
  RateLimits rates = voxels({10, 20}, {10, 20});
  rates.session.requests = {1, 2};
  rates.gateway_requests = {100, 40};
  rates.gateway_voxels = {100, 25};
  EditingBench gateway{rates, gateways()};
  gateway.attached();
  for (std::uint32_t id = 1; id <= 26; ++id) gateway.bench.write_voxel(id, id);
  CHECK(gateway.taker.edits.size() == 25);
  const auto said = gateway.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::overloaded);
  CHECK_THAT(said[0].text, Catch::Contains("gateway_voxels"));
  CHECK(gateway.bench.metrics.throttled(RateKind::gateway_voxels).total() == 1);
  // They stay when rates change for all.
  gateway.bench.session.rates_changed(nullptr);
  gateway.bench.clock.advance(100ms);
  for (std::uint32_t id = 101; id <= 110; ++id) gateway.bench.write_voxel(id, id);
  CHECK(gateway.taker.edits.size() == 35);
}

TEST_CASE("a session that keeps editing over its rate is closed, and one that waits is not") {
  const bool waits = GENERATE(true, false);
  EditingBench shared{voxels({65'536, 65'536})};
  shared.attached();
  const auto fill = [&](std::uint32_t id) {
    shared.bench.receive([&](auto& builder) {
      const std::vector<wire::Fill> fills{{{0, 0, 0}, {31, 31, 31}, 1, 0, 1}};
      return wire::CreateEdit(builder, id, 0, id, 0, builder.CreateVectorOfStructs(fills));
    });
  };
  std::uint32_t id = 0;
  int refusals = 0;
  for (int round = 0; round < 400 && shared.bench.session.state() == State::joined; ++round) {
    for (int i = 0; i < 8; ++i) fill(++id);
    std::uint32_t wait = 0;
    for (const SessionFrame& each : shared.bench.output()) {
      if (each.code != ErrorCode::overloaded) continue;
      ++refusals;
      wait = std::max(wait, each.retry_after_ms);
    }
    for (EditRequest& each : std::exchange(shared.taker.edits, {})) {
      shared.bench.mailbox->put(EditAnswer{each.id, edits::EditResult{each.sequence, 1, 1, {}}});
    }
    shared.bench.take_mail();
    shared.bench.clock.advance(std::chrono::milliseconds{waits ? wait : 20});
  }
  CHECK(refusals > 0);
  CHECK(shared.bench.session.state() == (waits ? State::joined : State::closed));
}

TEST_CASE("an edit that waits takes memory for every voxel that a fill names") {
  flatbuffers::FlatBufferBuilder builder;
  const std::vector<wire::Fill> fills{{{0, 0, 0}, {31, 31, 63}, 1, 0, 1}};
  builder.Finish(wire::CreateEdit(builder, 1, 0, 1, 0, builder.CreateVectorOfStructs(fills)));
  const auto checked = read_edit(*flatbuffers::GetRoot<wire::Edit>(builder.GetBufferPointer()));
  REQUIRE(checked);
  CHECK(checked->extent.voxels == 65'536);
  CHECK(checked->prepared_bytes >= 65'536 * (sizeof(Override) + sizeof(std::uint16_t)));
  const auto with_secrets =
      read_edit(*flatbuffers::GetRoot<wire::Edit>(builder.GetBufferPointer()), false, true);
  CHECK(with_secrets->prepared_bytes >=
        checked->prepared_bytes + 7 * 65'536 * (sizeof(std::uint16_t) + 2 * sizeof(Override)));
  // Of those that wait behind it only what they say: one is prepared at a time.
  EditingBench shared;
  shared.attached();
  for (std::uint32_t id = 1; id <= 8; ++id) {
    shared.bench.receive(
        [&](auto& wire) { return wire::CreateEdit(wire, id, 0, id, 0, wire.CreateVectorOfStructs(fills)); });
  }
  REQUIRE(shared.taker.edits.size() == 8);
  const std::size_t eight = shared.bench.memory.used(MemoryUse::sessions);
  CHECK(eight > checked->prepared_bytes);
  CHECK(eight < 2 * checked->prepared_bytes);
  for (std::uint32_t id = 1; id <= 8; ++id) {
    CHECK(shared.answered({id, edits::EditResult{id, 10, 1, {}}}).kind == Body::EditResult);
  }
  CHECK(shared.bench.memory.used(MemoryUse::sessions) < eight - checked->prepared_bytes / 2);
}

TEST_CASE("sliding voxels count toward the rate, and take memory while the edit waits") {
  EditingBench shared{voxels({10, 20})};
  shared.attached();
  shared.bench.write_voxel(1, 1);
  const std::size_t plain = shared.bench.memory.used(MemoryUse::sessions);
  CHECK(shared.answered({1, edits::EditResult{1, 10, 1, {}}}).kind == Body::EditResult);
  shared.taker.slides = true;
  shared.bench.write_voxel(2, 2);
  CHECK(shared.bench.memory.used(MemoryUse::sessions) > plain + 64 * 256 * 4);
  CHECK(shared.answered({2, edits::EditResult{2, 11, 31, {}}}).kind == Body::EditResult);
  shared.bench.write_voxel(3, 3);  // 20 - 2 - 30: it owes 12
  const auto said = shared.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::overloaded);
  CHECK(said[0].retry_after_ms == 1'300);
}

}  // namespace talus::server
