// Edits of a session, as far as the session decides: rights, order, bounds, rates, and what each answer
// becomes.
#include "session/session.h"

#include <array>
#include <limits>

#include <talus/voxel/codec.h>

#include "access/signed_token.h"
#include "scratch_directory.h"
#include "session/edit_check.h"
#include "session_bench.h"

namespace talus::server {
namespace {

using namespace std::chrono_literals;
using wire::Body;
using wire::ErrorCode;
using State = Session::State;

struct ScriptedTaker final : EditTaker {
  std::vector<AttachRequest> attaches;
  std::vector<EditRequest> edits;
  std::vector<ClientId> ended_input;
  std::vector<ClientId> forgotten;

  void attach(const MailboxPtr&, AttachRequest request) override { attaches.push_back(std::move(request)); }
  void edit(const MailboxPtr&, EditRequest request) override { edits.push_back(std::move(request)); }
  void input_ended(ClientId client) override { ended_input.push_back(client); }
  void forget(ClientId client) override { forgotten.push_back(client); }
  [[nodiscard]] bool settles() const override { return slides; }
  bool slides = false;
  [[nodiscard]] bool knows(edits::EditorId editor, const std::string& subject) const override {
    return editor == known && subject.empty();
  }
  [[nodiscard]] std::optional<EditRefusal> refuses_editors() const override { return full; }
  edits::EditorId known{7, 7};
  std::optional<EditRefusal> full;
};

Access editors() {
  Access access;
  access.without_token = "read,edit";
  return access;
}

Access gateways() {
  Access access;
  access.without_token = "read,edit,gateway";  // no setting gives it; Rights::parse does
  return access;
}

struct Bench {
  ScriptedTaker taker;
  SessionBench bench;

  explicit Bench(const RateLimits& rates = {}, const Access& access = editors(), EditRules rules = {},
                 AddressBucketsPtr address = {})
      : bench{{.rates = rates,
               .address = std::move(address),
               .access = access,
               .edits = &taker,
               .protocol = protocol::kEditsProtocol,
               .rules = std::move(rules)}} {}

  void attached(std::uint64_t last_sequence = 0) {
    bench.attach();
    bench.mailbox->put(AttachAnswer{EditorSession{{1, 2}, 3, last_sequence, false, 9}});
    bench.take_mail();
    REQUIRE(kinds(bench.output()) == Kinds{Body::Attached});
  }
  /// The answer to `id`, as values.
  Said answered(EditAnswer answer) {
    bench.mailbox->put(std::move(answer));
    bench.take_mail();
    return bench.output().at(0);
  }
};

RateLimits voxels(Rate session, Rate address = {}) {
  RateLimits limits;
  limits.session.voxels = session;
  limits.address.voxels = address;
  return limits;
}

Rejection refusal(std::vector<wire::Fill> fills) {
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(wire::CreateEdit(builder, 1, 0, 1, 0, builder.CreateVectorOfStructs(fills)));
  const auto checked = check_edit(*flatbuffers::GetRoot<wire::Edit>(builder.GetBufferPointer()));
  REQUIRE_FALSE(checked);
  return checked.error();
}

}  // namespace

TEST_CASE("an Edit before Attached is refused by its id, and the session stays") {
  Bench shared;
  shared.bench.write_voxel(4, 1);
  const auto said = shared.bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == ErrorCode::expired);
  CHECK(said[0].id == 4);
  CHECK(shared.bench.session.state() == State::joined);
  CHECK(shared.taker.edits.empty());
}

TEST_CASE("an Edit goes to the log as its editor, and is answered by its id") {
  Bench shared;
  shared.attached();
  shared.bench.write_voxel(4, 17, {-1, 2, 3}, 5);
  REQUIRE(shared.taker.edits.size() == 1);
  const EditRequest& request = shared.taker.edits[0];
  CHECK(request.id == 4);
  CHECK(request.editor == edits::EditorId{1, 2});
  CHECK(request.epoch == 3);
  CHECK(request.sequence == 17);
  CHECK(request.edit.writes == std::vector{edits::VoxelWrite{{-1, 2, 3}, MaterialId{5}}});
  CHECK(shared.bench.output().empty());

  const Said said = shared.answered({4, edits::EditResult{17, 10, 1, {}}});
  CHECK(said.kind == Body::EditResult);
  CHECK(said.id == 4);
  CHECK(said.revision == 10);
}

TEST_CASE("while an edit is not answered the mailbox says that its owner is about to be woken") {
  Bench shared;
  shared.attached();
  const Mailbox& mailbox = *shared.bench.mailbox;
  CHECK_FALSE(mailbox.expects_answer());
  shared.bench.write_voxel(4, 17, {-1, 2, 3}, 5);
  shared.bench.write_voxel(5, 18, {-1, 2, 3}, 6);
  CHECK(mailbox.expects_answer());
  (void)shared.answered({4, edits::EditResult{17, 10, 1, {}}});
  CHECK(mailbox.expects_answer());
  (void)shared.answered({5, tl::unexpected{EditRefusal{ErrorCode::conflict, "guard 0 does not hold", {}}}});
  CHECK_FALSE(mailbox.expects_answer());
  shared.bench.write_voxel(6, 19, {-1, 2, 3}, 5);
  shared.bench.session.abandon();
  CHECK_FALSE(mailbox.expects_answer());
}

TEST_CASE("an edit that does not happen is an Error about its request") {
  Bench shared;
  shared.attached();
  shared.bench.write_voxel(4, 1);
  const Said said = shared.answered({4, tl::unexpected{EditRefusal{ErrorCode::conflict, "guard 0", 0ms}}});
  CHECK(said.code == ErrorCode::conflict);
  CHECK(said.id == 4);
  CHECK(said.about == wire::ErrorAbout::request);
}

TEST_CASE("an edit's id is taken until it is answered") {
  Bench shared;
  shared.attached();
  shared.bench.write_voxel(4, 1);
  shared.bench.get_chunk(4, chunk_at(0));
  CHECK(shared.bench.output().at(0).code == ErrorCode::duplicate_id);
  CHECK(shared.answered({4, edits::EditResult{1, 1, 1, {}}}).kind == Body::EditResult);
  shared.bench.write_voxel(4, 2);
  CHECK(shared.taker.edits.size() == 2);
}

TEST_CASE("no more edits than there are kept results go unanswered") {
  Bench shared;
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
    Bench shared;
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
    SessionBench bench{{.access = editors(), .edits = &taker, .protocol = 2}};
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
  SessionBench bench{{.access = editors(), .edits = &taker, .protocol = 2}};
  bench.attach();
  bench.mailbox->put(AttachAnswer{tl::unexpected{EditRefusal{ErrorCode::overloaded, "later", 1s}}});
  bench.take_mail();
  bench.session.abandon();
  CHECK(taker.forgotten == std::vector{ClientId{1}});
}

TEST_CASE("voxels over the rate are refused with a time, and the edit does not happen") {
  Bench shared{voxels({10, 20})};
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

TEST_CASE("chunks that nobody edited before cost their address, each once") {
  RateLimits limits;
  limits.address.new_chunks = {1, 3 * kNewChunkTokens};  // three saved up, and one an hour
  Bench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
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
  Bench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
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
  CHECK(shared.answered({1, tl::unexpected{EditRefusal{ErrorCode::conflict, "guard 0", 0ms}}}).code ==
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
  Bench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.taker.slides = true;
  shared.attached();
  shared.bench.write_voxel(1, 1, {0, 40, 0});  // at the corner of four columns, and 64 rows
  CHECK(shared.taker.edits.size() == 1);
  shared.bench.write_voxel(2, 2, {320, 40, 0});
  CHECK(shared.taker.edits.size() == 1);
}

TEST_CASE("an edit in a protected box is forbidden and costs nothing else, and its session stays") {
  RateLimits limits;
  limits.address.voxels = {1, 1};
  limits.address.new_chunks = {1, kNewChunkTokens};
  Bench shared{limits,
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

TEST_CASE("an address makes so many editors an hour, and whoever is one already goes on") {
  RateLimits limits;
  limits.address.editors = {1, 2 * kEditorTokens};  // two saved up, and one an hour
  Bench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  const auto attach = [&](edits::EditorId editor) {
    shared.taker.attaches.clear();
    shared.bench.attach(editor);
    const auto said = shared.bench.output();
    if (shared.taker.attaches.empty()) return said.at(0).text;
    // Another session comes; this one is as it was.
    shared.bench.mailbox->put(
        AttachAnswer{tl::unexpected{EditRefusal{ErrorCode::overloaded, "not now", 1ms}}});
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

TEST_CASE("where the world has room for no editor an Attach takes nothing of what the address may make") {
  RateLimits limits;
  limits.address.editors = {1, kEditorTokens};  // one saved up, and one an hour
  Bench shared{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  shared.taker.full = EditRefusal{ErrorCode::overloaded, "full", 2min};
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

  Bench known{limits, editors(), {}, std::make_shared<AddressBuckets>(limits.address)};
  known.taker.full = EditRefusal{ErrorCode::overloaded, "full", 2min};
  known.bench.attach({7, 7});
  CHECK(known.taker.attaches.size() == 1);
}

TEST_CASE("where a gateway is required, players are told so at Attach and at Edit") {
  Bench shared{{}, editors(), {{}, true}};
  shared.bench.attach();
  shared.bench.write_voxel(4, 1);
  const auto said = shared.bench.output();
  REQUIRE(said.size() == 2);
  for (const Said& each : said) {
    CHECK(each.code == ErrorCode::forbidden);
    CHECK_THAT(each.text, Catch::Contains("edits.gateway"));
  }
  CHECK(shared.taker.attaches.empty());
}

TEST_CASE("only a gateway names for whom it edits, in so many bytes") {
  Bench player;
  player.attached();
  player.bench.write_voxel(4, 1, {}, 1, "alice");
  const auto said = player.bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == ErrorCode::forbidden);
  CHECK_THAT(said[0].text, Catch::Contains("gateway"));
  CHECK(player.taker.edits.empty());

  Bench gateway{{}, gateways(), {{}, true}};
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
  Bench gateway{{}, gateways(), {{}, true}};
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
    SessionBench bench{
        {.access = access, .greet = false, .edits = &taker, .protocol = protocol::kEditsProtocol}};
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

TEST_CASE("a gateway has rates of its own, in place of those of a player and of its address") {
  RateLimits rates = voxels({10, 20}, {10, 20});
  rates.session.requests = {1, 2};
  rates.gateway_requests = {100, 40};
  rates.gateway_voxels = {100, 25};
  Bench gateway{rates, gateways()};
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

TEST_CASE("who ignores that his edits are over the rate is thrown out, and who waits is not") {
  const bool waits = GENERATE(true, false);
  Bench shared{voxels({65'536, 65'536})};
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
    for (const Said& each : shared.bench.output()) {
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
  const auto checked = check_edit(*flatbuffers::GetRoot<wire::Edit>(builder.GetBufferPointer()));
  REQUIRE(checked);
  CHECK(checked->voxels == 65'536);
  CHECK(checked->prepared_bytes >= 65'536 * (sizeof(Override) + sizeof(std::uint16_t)));
  // Of those that wait behind it only what they say: one is prepared at a time.
  Bench shared;
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

TEST_CASE("what slides counts to the rate, and takes memory while the edit waits") {
  Bench shared{voxels({10, 20})};
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

TEST_CASE("Attach needs the right, version 2, a store, and its turn") {
  SECTION("the right") {
    ScriptedTaker taker;
    SessionBench bench{{.edits = &taker, .protocol = 2}};
    bench.attach();
    const auto said = bench.output();
    CHECK(said.at(0).code == ErrorCode::forbidden);
    CHECK(said.at(0).about == wire::ErrorAbout::attach);
  }
  SECTION("version 2") {
    ScriptedTaker taker;
    SessionBench bench{{.access = editors(), .edits = &taker}};
    bench.write_voxel(1, 1);
    CHECK(bench.output().at(0).code == ErrorCode::unsupported);
    bench.attach();
    CHECK(bench.output().at(0).code == ErrorCode::unsupported);
    CHECK(bench.session.state() == State::joined);
  }
  SECTION("a store") {
    SessionBench bench{{.access = editors(), .protocol = 2}};
    bench.attach();
    bench.write_voxel(1, 1);
    const auto said = bench.output();
    REQUIRE(said.size() == 2);
    CHECK(said[0].code == ErrorCode::unsupported);
    CHECK(said[1].code == ErrorCode::unsupported);
    CHECK(bench.session.state() == State::joined);
  }
  SECTION("its turn") {
    Bench shared;
    shared.bench.attach();
    shared.bench.attach();
    CHECK(shared.bench.output().at(0).code == ErrorCode::unexpected);
    CHECK(shared.taker.attaches.size() == 1);
  }
}

TEST_CASE("fills are counted before anything is made of them") {
  constexpr auto kLow = std::numeric_limits<std::int64_t>::min();
  constexpr auto kHigh = std::numeric_limits<std::int64_t>::max();
  CHECK(refusal({{{kLow, kLow, kLow}, {kHigh, kHigh, kHigh}, 1, 0, 1}}).code == ErrorCode::too_large);
  CHECK(refusal({{{0, 0, 0}, {65'536, 0, 0}, 1, 0, 1}}).code == ErrorCode::too_large);
  CHECK(refusal({{{0, 0, 0}, {0, 0, 0}, 1, 0, 4}}).code == ErrorCode::malformed);
  CHECK(refusal({}).code == ErrorCode::out_of_range);
  CHECK(refusal(std::vector<wire::Fill>(3, {{0, 0, 0}, {31, 31, 31}, 1, 0, 1})).code == ErrorCode::too_large);
}

TEST_CASE("a paste is a chunk, or the connection ends") {
  Bench shared;
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

}  // namespace talus::server
