// Edits of a session, as far as the session decides: rights, order, bounds, and what each answer becomes.
// What they cost is session_edit_rates_test.cpp's.
#include "player/session/session.h"

#include <array>
#include <limits>

#include <talus/voxel/codec.h>

#include "config/access/signed_token.h"
#include "editing_bench.h"
#include "edits/admission/wire_edit.h"
#include "player/session/wire_error.h"
#include "scratch_directory.h"
#include "session_bench.h"

namespace talus::server {
namespace {

using namespace std::chrono_literals;
using wire::Body;
using wire::ErrorCode;
using State = Session::State;

EditError refusal(std::vector<wire::Fill> fills) {
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(wire::CreateEdit(builder, 1, 0, 1, 0, builder.CreateVectorOfStructs(fills)));
  const auto checked = read_edit(*flatbuffers::GetRoot<wire::Edit>(builder.GetBufferPointer()));
  REQUIRE_FALSE(checked);
  return checked.error();
}

}  // namespace

TEST_CASE("an Edit before Attached is refused by its id, and the session stays") {
  EditingBench shared;
  shared.bench.write_voxel(4, 1);
  const auto said = shared.bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == ErrorCode::expired);
  CHECK(said[0].id == 4);
  CHECK(shared.bench.session.state() == State::joined);
  CHECK(shared.taker.edits.empty());
}

TEST_CASE("an Edit goes to the log as its editor, and is answered by its id") {
  EditingBench shared;
  shared.attached();
  shared.bench.write_voxel(4, 17, {-1, 2, 3}, 5);
  REQUIRE(shared.taker.edits.size() == 1);
  const EditRequest& request = shared.taker.edits[0];
  CHECK(request.id == 4);
  CHECK(request.editor == edits::EditorId{1, 2});
  CHECK(request.epoch == 3);
  CHECK(request.sequence == 17);
  CHECK(request.edit.writes == std::vector{edits::VoxelWrite{{-1, 2, 3}, MaterialId{5}}});
  CHECK(request.extent.voxels == 1);
  CHECK(request.extent.chunks == std::vector{ChunkCoord{-1, 0, 0}});
  CHECK(shared.bench.output().empty());

  const SessionFrame said = shared.answered({4, edits::EditResult{17, 10, 1, {}}});
  CHECK(said.kind == Body::EditResult);
  CHECK(said.id == 4);
  CHECK(said.revision == 10);
}

TEST_CASE("while an edit is not answered the mailbox says that its owner is about to be woken") {
  EditingBench shared;
  shared.attached();
  const Mailbox& mailbox = *shared.bench.mailbox;
  CHECK_FALSE(mailbox.expects_answer());
  shared.bench.write_voxel(4, 17, {-1, 2, 3}, 5);
  shared.bench.write_voxel(5, 18, {-1, 2, 3}, 6);
  CHECK(mailbox.expects_answer());
  (void)shared.answered({4, edits::EditResult{17, 10, 1, {}}});
  CHECK(mailbox.expects_answer());
  (void)shared.answered({5, tl::unexpected{EditError{EditErrorCode::conflict, "guard 0 does not hold"}}});
  CHECK_FALSE(mailbox.expects_answer());
  shared.bench.write_voxel(6, 19, {-1, 2, 3}, 5);
  shared.bench.session.abandon();
  CHECK_FALSE(mailbox.expects_answer());
}

TEST_CASE("an edit that does not happen is an Error about its request") {
  EditingBench shared;
  shared.attached();
  shared.bench.write_voxel(4, 1);
  const SessionFrame said =
      shared.answered({4, tl::unexpected{EditError{EditErrorCode::conflict, "guard 0"}}});
  CHECK(said.code == ErrorCode::conflict);
  CHECK(said.id == 4);
  CHECK(said.about == wire::ErrorAbout::request);
}

TEST_CASE("paths, addresses and advice for the operator go to the log, not to players") {
  for (const EditErrorCode code :
       {EditErrorCode::unwritable, EditErrorCode::unreadable, EditErrorCode::cut_off}) {
    EditingBench shared;
    shared.attached();
    shared.bench.write_voxel(4, 1);
    const SessionFrame said = shared.answered(
        {4, tl::unexpected{EditError{code, "edits /var/lib/talus: IO error; restore a backup"}}});
    CHECK(said.kind == Body::Error);
    CHECK_THAT(said.text, !Catch::Contains("/var") && !Catch::Contains("backup"));
    CHECK_FALSE(said.text.empty());
  }
}

TEST_CASE("if memory is short the flow that holds most gives way to an edit") {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;
  EditingBench shared{{}, editors(), {}, {}, 256 * kMebibyte};
  shared.attached();
  MemoryBudget& memory = shared.bench.memory;
  bool gave_way = false;
  std::array<MemoryReservation, 2> greedy{{{memory, MemoryUse::sessions}, {memory, MemoryUse::sessions}}};
  for (MemoryReservation& each : greedy) {
    each.share(FlowId{77}, [&] { gave_way = true; });
    each.hold(100 * kMebibyte);
  }
  REQUIRE_FALSE(memory.takes_work());
  shared.bench.write_voxel(4, 1);
  CHECK(gave_way);
  CHECK(shared.taker.edits.size() == 1);
}

TEST_CASE("an edit's id is taken until it is answered") {
  EditingBench shared;
  shared.attached();
  shared.bench.write_voxel(4, 1);
  shared.bench.get_chunk(4, chunk_at(0));
  CHECK(shared.bench.output().at(0).code == ErrorCode::duplicate_id);
  CHECK(shared.answered({4, edits::EditResult{1, 1, 1, {}}}).kind == Body::EditResult);
  shared.bench.write_voxel(4, 2);
  CHECK(shared.taker.edits.size() == 2);
}

TEST_CASE("no more edits than there are kept results go unanswered") {
  EditingBench shared;
  shared.attached();
  for (std::uint32_t id = 1; id <= edits::kKeptResults + 1; ++id) shared.bench.write_voxel(id, id);
  CHECK(shared.taker.edits.size() == edits::kKeptResults);
  const auto said = shared.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::too_many_requests);
  CHECK(said[0].id == edits::kKeptResults + 1);
}

TEST_CASE("a session that leaves or finishes waits for the answers of its edits") {
  for (const bool leaves : {true, false}) {
    EditingBench shared;
    shared.attached();
    shared.bench.write_voxel(4, 1);
    if (leaves) {
      shared.bench.session.go_away("ending", 1ms);
    } else {
      shared.bench.session.input_ended();
    }
    (void)shared.bench.output();
    CHECK(shared.bench.session.state() != State::closed);
    CHECK(shared.taker.ended_input.size() == (leaves ? 0 : 1));
    CHECK(shared.answered({4, edits::EditResult{1, 1, 1, {}}}).kind == Body::EditResult);
    CHECK(shared.bench.session.state() == State::closed);
  }
}

TEST_CASE("a session that ends forgets its edits, and so does the taker") {
  ScriptedTaker taker;
  {
    SessionBench bench{{.access = editors(), .edits = &taker}};
    bench.attach();
    bench.mailbox->put(AttachAnswer{EditorSession{{1, 2}, 3, 0, false, 9}});
    bench.take_mail();
    bench.write_voxel(4, 1);
    bench.session.abandon();
    CHECK(taker.forgotten == std::vector{ClientId{1}});
    bench.mailbox->put(EditAnswer{4, edits::EditResult{1, 1, 1, {}}});
    bench.take_mail();
  }
  CHECK(taker.forgotten.size() == 1);
}

TEST_CASE("the taker forgets a session whose Attach was refused") {
  ScriptedTaker taker;
  SessionBench bench{{.access = editors(), .edits = &taker}};
  bench.attach();
  bench.mailbox->put(AttachAnswer{tl::unexpected{EditError{EditErrorCode::busy, "later"}}});
  bench.take_mail();
  bench.session.abandon();
  CHECK(taker.forgotten == std::vector{ClientId{1}});
}

TEST_CASE("an edit in a protected box is forbidden and costs nothing else, and its session stays") {
  RateLimits limits;
  limits.address.voxels = {1, 1};
  limits.address.new_chunks = {1, kNewChunkTokens};
  EditingBench shared{limits,
                      editors(),
                      {*Boxes::parse("-16,-16:16,16"), false},
                      std::make_shared<AddressBuckets>(limits.address)};
  shared.attached();
  shared.bench.write_voxel(4, 1, {3, 4, 5});
  shared.bench.write_voxel(5, 2, {17, 4, 5});
  const auto said = shared.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::forbidden);
  CHECK(said[0].id == 4);
  CHECK_THAT(said[0].text, Catch::Contains("-16,-16:16,16"));
  REQUIRE(shared.taker.edits.size() == 1);
  CHECK(shared.taker.edits[0].sequence == 2);
}

TEST_CASE("if a gateway is required, Attach and Edit of players are refused with that reason") {
  EditingBench shared{{}, editors(), {{}, true}};
  shared.bench.attach();
  shared.bench.write_voxel(4, 1);
  const auto said = shared.bench.output();
  REQUIRE(said.size() == 2);
  for (const SessionFrame& each : said) {
    CHECK(each.code == ErrorCode::forbidden);
    CHECK_THAT(each.text, Catch::Contains("edits.gateway"));
  }
  CHECK(shared.taker.attaches.empty());
}

TEST_CASE("only a gateway may name a subject, of a limited size") {
  EditingBench player;
  player.attached();
  player.bench.write_voxel(4, 1, {}, 1, "alice");
  const auto said = player.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::forbidden);
  CHECK_THAT(said[0].text, Catch::Contains("gateway"));
  CHECK(player.taker.edits.empty());

  EditingBench gateway{{}, gateways(), {{}, true}};
  gateway.attached();
  gateway.bench.write_voxel(4, 1, {}, 1, "alice");
  gateway.bench.write_voxel(5, 2);
  gateway.bench.write_voxel(6, 3, {}, 1, std::string(edits::kMaxSubjectBytes + 1, 'x'));
  REQUIRE(gateway.taker.edits.size() == 2);
  CHECK(gateway.taker.edits[0].subject == "alice");
  CHECK(gateway.taker.edits[1].subject.empty());
  const auto refused = gateway.bench.output();
  REQUIRE(refused.size() == 1);
  CHECK(refused[0].code == ErrorCode::too_large);
  CHECK(gateway.bench.session.state() == State::joined);
}

TEST_CASE("a gateway names players whose names can be printed, and an odd name costs it that edit alone") {
  using namespace std::string_view_literals;
  EditingBench gateway{{}, gateways(), {{}, true}};
  gateway.attached();
  std::uint32_t id = 10;
  for (const std::string_view odd : {"\0"sv, "a\0b"sv, "line\nbreak"sv, "\x1b[2J"sv, "\x7f"sv, "\xc2\x9b"sv,
                                     "\xff\xfe"sv, "cut \xc3"sv, "\xc0\x80"sv, "\xed\xa0\x80"sv}) {
    ++id;
    gateway.bench.write_voxel(id, id, {}, 1, std::string{odd});
    const auto said = gateway.bench.output();
    REQUIRE(said.size() == 1);
    CHECK(said[0].code == ErrorCode::out_of_range);
    CHECK_THAT(said[0].text, Catch::Contains("Edit.subject has control characters"));
  }
  CHECK(gateway.taker.edits.empty());
  const std::string longest(edits::kMaxSubjectBytes, 'x');
  for (const std::string& good : {std::string{"J\u00f6rg \u2603"}, std::string{" "}, longest}) {
    ++id;
    gateway.bench.write_voxel(id, id, {}, 1, good);
  }
  CHECK(gateway.bench.output().empty());
  CHECK(gateway.taker.edits.size() == 3);
}

TEST_CASE("a token whose subject cannot be printed does not let edit") {
  const ScratchDirectory scratch;
  const std::string key = "0123456789abcdef0123456789abcdef";
  Access access;
  access.signing_key_file = scratch.write("key", key);
  ScriptedTaker taker;
  for (const auto& [name, lets] :
       {std::pair{"J\u00f6rg", true}, std::pair{"a\x1b[2Jb", false}, std::pair{"a\nb", false}}) {
    SessionBench bench{{.access = access, .greet = false, .edits = &taker}};
    bench.hello(*make_signed_token(Secret{key}, {name, {Right::read, Right::edit}, bench.clock.wall() + 1h},
                                   bench.clock.wall()));
    (void)bench.output();
    taker.attaches.clear();
    bench.attach();
    CHECK(taker.attaches.empty() != lets);
    if (lets) continue;
    const auto said = bench.output();
    REQUIRE(said.size() == 1);
    CHECK(said[0].code == ErrorCode::forbidden);
    CHECK_THAT(said[0].text, Catch::Contains("the token's subject has control characters"));
  }
}

TEST_CASE("Attach needs the right, a store, and its turn") {
  SECTION("the right") {
    ScriptedTaker taker;
    SessionBench bench{{.edits = &taker}};
    bench.attach();
    const auto said = bench.output();
    CHECK(said.at(0).code == ErrorCode::forbidden);
    CHECK(said.at(0).about == wire::ErrorAbout::attach);
  }
  SECTION("a store") {
    SessionBench bench{{.access = editors()}};
    bench.attach();
    bench.write_voxel(1, 1);
    const auto said = bench.output();
    REQUIRE(said.size() == 2);
    CHECK(said[0].code == ErrorCode::unsupported);
    CHECK(said[1].code == ErrorCode::unsupported);
    CHECK(bench.session.state() == State::joined);
  }
  SECTION("its turn") {
    EditingBench shared;
    shared.bench.attach();
    shared.bench.attach();
    CHECK(shared.bench.output().at(0).code == ErrorCode::unexpected);
    CHECK(shared.taker.attaches.size() == 1);
  }
}

TEST_CASE("fills are counted before anything is made of them") {
  constexpr auto kLow = std::numeric_limits<std::int64_t>::min();
  constexpr auto kHigh = std::numeric_limits<std::int64_t>::max();
  CHECK(refusal({{{kLow, kLow, kLow}, {kHigh, kHigh, kHigh}, 1, 0, 1}}).code == EditErrorCode::too_large);
  CHECK(refusal({{{0, 0, 0}, {65'536, 0, 0}, 1, 0, 1}}).code == EditErrorCode::too_large);
  CHECK(refusal({{{0, 0, 0}, {0, 0, 0}, 1, 0, 4}}).message == "fill 0: unknown flags 4; 1 and 2 are known");
  CHECK(refusal({}).message == "the edit names no voxels; give writes, fills or a paste");
  CHECK(refusal({{{5, 0, 0}, {4, 0, 0}, 1, 0, 1}}).message ==
        "fill 0: its first x is 5, its last 4; the first must not be greater");
  CHECK(refusal(std::vector<wire::Fill>(3, {{0, 0, 0}, {31, 31, 31}, 1, 0, 1})).code ==
        EditErrorCode::too_large);
}

TEST_CASE("an edit with flags of a later version is refused, and the connection stays") {
  EditingBench shared;
  shared.attached();
  shared.bench.receive([](auto& builder) {
    const std::vector<wire::Fill> fills{{{0, 0, 0}, {0, 0, 0}, 1, 0, 4}};
    return wire::CreateEdit(builder, 5, 0, 1, 0, builder.CreateVectorOfStructs(fills));
  });
  CHECK(shared.bench.output().at(0).code == ErrorCode::out_of_range);
  CHECK(shared.bench.session.state() == State::joined);
}

TEST_CASE("a paste is a chunk, or the connection ends") {
  EditingBench shared;
  shared.attached();
  const auto paste = [&](std::uint32_t id, const std::vector<std::uint8_t>& payload) {
    shared.bench.receive([&](auto& builder) {
      const wire::Voxel origin{0, 0, 0};
      const auto made = wire::CreatePaste(builder, &origin, builder.CreateVector(payload), false);
      return wire::CreateEdit(builder, id, 0, 1, 0, 0, made);
    });
  };
  std::vector<std::byte> payload;
  encode(Chunk::uniform(MaterialId{3}), payload);
  std::vector<std::uint8_t> bytes;
  for (const std::byte byte : payload) bytes.push_back(std::to_integer<std::uint8_t>(byte));
  paste(5, bytes);
  REQUIRE(shared.taker.edits.size() == 1);
  CHECK(shared.taker.edits[0].edit.paste->voxels == Chunk::uniform(MaterialId{3}));
  paste(6, {9, 9, 9});
  CHECK(shared.bench.output().at(0).code == ErrorCode::malformed);
  CHECK(shared.bench.session.state() == State::closed);
}

TEST_CASE("each edit error has its code and its time to retry on the wire") {
  const auto is = [](EditErrorCode code, ErrorCode on_wire, std::chrono::milliseconds retry_after) {
    const WireError error = wire_error(code);
    return error.code == on_wire && error.retry_after == retry_after;
  };
  using enum EditErrorCode;
  for (const EditErrorCode code : {out_of_range, index_full}) CHECK(is(code, ErrorCode::out_of_range, 0ms));
  for (const EditErrorCode code : {ground, unreadable}) CHECK(is(code, ErrorCode::internal, 1s));
  for (const EditErrorCode code : {half_closed, busy, unwritable, behind, overtaken}) {
    CHECK(is(code, ErrorCode::overloaded, 1s));
  }
  CHECK(is(cut_off, ErrorCode::overloaded, 2s));
  CHECK(is(editors_full, ErrorCode::overloaded, 2min));
  CHECK(is(conflict, ErrorCode::conflict, 0ms));
  CHECK(is(not_applied, ErrorCode::not_applied, 0ms));
  CHECK(is(expired, ErrorCode::expired, 0ms));
  CHECK(is(invalid, ErrorCode::internal, 0ms));
}

}  // namespace talus::server
