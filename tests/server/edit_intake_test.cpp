// What the intake makes of sessions' edits, in the test's own thread: bases looked up, order kept, refusals.
#include "edits/edit_intake.h"

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "chunks/client_ids.h"
#include "runtime/manual_clock.h"
#include "scripted_source.h"

namespace talus::server {
namespace {

constexpr MaterialId kStone{2};
constexpr MaterialId kGlass{3};
constexpr edits::EditorId kEditor{1, 2};

EncodedChunkPtr of(MaterialId material) {
  return encode_shared(Chunk::uniform(material));
}

/// As EditAdmission hands it on.
EditRequest measured(EditRequest request) {
  request.extent = extent_of(request.edit, true);
  return request;
}

struct HeldLog final : EditLog {
  struct Entry {
    LogEntry entry;
    Callback done;
  };
  std::vector<Entry> entries;
  std::optional<EditError> failure;
  std::size_t answered = 0;  // entries from the front

  tl::expected<void, EditError> append(LogEntry entry, Callback done) override {
    if (failure) return tl::unexpected{*failure};
    entries.push_back({std::move(entry), std::move(done)});
    return {};
  }
  void answer_one() {
    edits::EntryResult applied;
    applied.kind = edits::EntryResult::Kind::done;
    entries.at(answered++).done(&applied);
  }
  [[nodiscard]] const edits::EditEntry& edit(std::size_t index) const {
    return std::get<edits::EditEntry>(entries.at(index).entry);
  }
};

struct Bench {
  ScriptedSource source;
  HeldLog log;
  std::map<edits::EditorId, edits::Editor> editors;
  ManualClock clock;
  Metrics metrics;
  bool full = false;  // of editors
  EditIntake intake{{source, log,
                     [this](edits::EditorId id) {
                       const auto at = editors.find(id);
                       return at == editors.end() ? std::nullopt : std::optional{at->second};
                     },
                     clock, metrics,
                     [this]() -> tl::expected<void, EditError> {
                       if (!full) return {};
                       return tl::unexpected{EditError{EditErrorCode::editors_full, "full"}};
                     }},
                    {{0, 100}, {kAir, kStone, kGlass}},
                    make_logger("off", "text")};
  MailboxPtr session = std::make_shared<Mailbox>(ClientId{1}, [] {});

  void edit(std::uint32_t id, std::vector<VoxelPos> voxels, MaterialId material = kGlass) {
    EditRequest request{id, kEditor, 3, id, {}};
    for (const VoxelPos voxel : voxels) request.edit.writes.push_back({voxel, material});
    intake.edit(session, measured(std::move(request)));
    intake.do_what_waits();
  }
  void look_ups_answered(MaterialId material) {
    while (!source.waiting.empty()) {
      const ChunkKey key = source.waiting.begin()->first;
      source.mail(key, of(material));
      source.last_mailbox->wake();
    }
    intake.do_what_waits();
  }
  template <typename Letter>
  Letter only_mail() {
    auto mail = session->take();
    REQUIRE(mail.size() == 1);
    return std::get<Letter>(std::move(mail[0]));
  }
};

}  // namespace

TEST_CASE("a full editor table is reported before an Attach, and counts as a refusal") {
  Bench bench;
  CHECK(bench.intake.room_for_editor());
  bench.full = true;
  const auto room = bench.intake.room_for_editor();
  REQUIRE_FALSE(room);
  CHECK(room.error().code == EditErrorCode::editors_full);
  CHECK(room.error().message == "full");
  CHECK(bench.metrics.edits_refused[EditErrorCode::editors_full].total() == 1);
}

TEST_CASE("an edit is logged with the base of what it touches, looked up in the session's turns") {
  Bench bench;
  bench.edit(1, {{0, 0, 0}, {33, 5, 0}});
  CHECK(bench.log.entries.empty());
  CHECK(bench.source.wanted_soon.size() == 2);
  CHECK(bench.source.last_mailbox->flow() == bench.session->flow());
  CHECK(bench.source.last_mailbox->owner() == client_id(ClientKind::look_ups, 1));
  bench.look_ups_answered(kStone);
  REQUIRE(bench.log.entries.size() == 1);
  const edits::EditEntry& entry = bench.log.edit(0);
  CHECK(entry.editor == kEditor);
  CHECK(entry.epoch == 3);
  CHECK(entry.sequence == 1);
  CHECK(entry.base == edits::BaseVoxels{{{0, 0, 0}, {{0, kStone}}}, {{1, 0, 0}, {{5 * 1024 + 1, kStone}}}});
  REQUIRE(entry.touched.size() == 2);
  CHECK(entry.touched[1].chunk == ChunkCoord{1, 0, 0});
  CHECK(entry.touched[1].voxels == std::vector<std::uint16_t>{5 * 1024 + 1});

  bench.edit(2, {{1, 0, 0}});  // a chunk that is kept decoded
  CHECK(bench.log.entries.size() == 2);
}

TEST_CASE("in a world with secrets an entry has what is hidden at its voxels and beside them") {
  constexpr MaterialId kOre{9};
  ScriptedSource source;
  HeldLog log;
  ManualClock clock;
  Metrics metrics;
  EditIntake::Rules rules{{0, 100}, {kAir, kStone, kGlass}};
  rules.see_through = {kAir};
  // Voxel 31 of every chunk, and one that is far from the edit.
  rules.hidden = [&](ChunkCoord, const Chunk& shown) {
    return shown.at({}) == kStone ? std::vector<Override>{{31, kOre}, {9'000, kOre}}
                                  : std::vector<Override>{};
  };
  EditIntake intake{{source, log, [](edits::EditorId) { return std::nullopt; }, clock, metrics},
                    rules,
                    make_logger("off", "text")};
  const MailboxPtr session = std::make_shared<Mailbox>(ClientId{1}, [] {});
  EditRequest request{1, kEditor, 3, 1, {}};
  request.edit.writes.push_back({{32, 0, 0}, kAir});
  intake.edit(session, measured(std::move(request)));
  intake.do_what_waits();
  // Its own chunk, and those beside it.
  REQUIRE(source.waiting.size() == 4);
  while (!source.waiting.empty()) {
    const ChunkKey key = source.waiting.begin()->first;
    source.mail(key, of(kStone));
    source.last_mailbox->wake();
  }
  intake.do_what_waits();
  REQUIRE(log.entries.size() == 1);
  const edits::EditEntry& entry = log.edit(0);
  CHECK(entry.base == edits::BaseVoxels{{{1, 0, 0}, {{0, kStone}}}});
  CHECK(entry.secrets.hidden == edits::BaseVoxels{{{0, 0, 0}, {{31, kOre}}}});
  CHECK(entry.secrets.base == edits::BaseVoxels{{{0, 0, 0}, {{31, kStone}}}});
  CHECK(entry.secrets.see_through == std::vector<MaterialId>{kAir});

  // Far apart, its voxels lie in 64 chunks, but with those beside them in more.
  EditRequest wide{2, kEditor, 3, 2, {}};
  for (std::int64_t x = 0; x < 64; ++x) wide.edit.writes.push_back({{x * 64, 0, 0}, kAir});
  intake.edit(session, measured(std::move(wide)));
  intake.do_what_waits();
  CHECK(log.entries.size() == 1);
  CHECK(metrics.edits_refused[EditErrorCode::out_of_range].total() == 1);
}

TEST_CASE("ground that is kept decoded is counted, and goes when it may have less") {
  Bench bench;
  bench.edit(1, {{0, 0, 0}});
  bench.look_ups_answered(kStone);
  CHECK(bench.intake.base_bytes() > 0);
  bench.edit(2, {{1, 0, 0}});
  CHECK(bench.source.submitted == 1);
  bench.intake.limit_bases(0);
  bench.intake.do_what_waits();
  CHECK(bench.intake.base_bytes() == 0);
  bench.edit(3, {{2, 0, 0}});
  CHECK(bench.source.submitted == 2);
  bench.look_ups_answered(kStone);
  CHECK(bench.log.entries.size() == 3);
  CHECK(bench.intake.base_bytes() == 0);
  bench.intake.limit_bases(SIZE_MAX);
  bench.edit(4, {{3, 0, 0}});
  bench.look_ups_answered(kStone);
  CHECK(bench.intake.base_bytes() > 0);
}

TEST_CASE("ground that comes while the log has no room is counted at once") {
  Bench bench;
  bench.source.in_memory[{{5, 0, 0}, Lod{}}] = of(kStone);
  bench.edit(1, {{160, 0, 0}});
  bench.edit(2, {{0, 0, 0}});
  bench.session = std::make_shared<Mailbox>(ClientId{2}, [] {});
  for (std::uint32_t id = 2; id <= EditIntake::kLogEntries; ++id) bench.edit(id, {{160, 0, 0}});
  REQUIRE(bench.log.entries.size() == EditIntake::kLogEntries);
  const std::size_t before = bench.intake.base_bytes();
  bench.look_ups_answered(kStone);
  CHECK(bench.log.entries.size() == EditIntake::kLogEntries);
  CHECK(bench.intake.base_bytes() > before);
}

TEST_CASE("edits of a session keep their order, and edits of other sessions do not wait for them") {
  Bench bench;
  bench.source.in_memory[{{5, 0, 0}, Lod{}}] = of(kStone);
  bench.edit(1, {{0, 0, 0}});
  bench.edit(2, {{160, 0, 0}});  // in memory
  CHECK(bench.log.entries.empty());
  const MailboxPtr other = std::make_shared<Mailbox>(ClientId{2}, [] {});
  EditRequest request{7, {5, 6}, 1, 1, {}};
  request.edit.writes = {{{161, 0, 0}, kGlass}};
  bench.intake.edit(other, measured(std::move(request)));
  bench.intake.do_what_waits();
  REQUIRE(bench.log.entries.size() == 1);
  CHECK(bench.log.edit(0).editor == edits::EditorId{5, 6});
  bench.look_ups_answered(kStone);
  REQUIRE(bench.log.entries.size() == 3);
  CHECK(bench.log.edit(1).sequence == 1);
  CHECK(bench.log.edit(2).sequence == 2);
}

TEST_CASE("look-ups that the generators refuse are tried again") {
  Bench bench;
  bench.source.queue_places = 1;
  bench.edit(1, {{0, 0, 0}, {33, 0, 0}, {65, 0, 0}});
  for (int round = 0; round < 3; ++round) {
    CHECK(bench.log.entries.empty());
    bench.look_ups_answered(kStone);
  }
  CHECK(bench.log.entries.size() == 1);
}

TEST_CASE("an edit that may not be is refused, and the next goes on") {
  Bench bench;
  bench.source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  bench.edit(1, {{0, 0, 0}}, MaterialId{9});
  const auto refused = bench.only_mail<EditAnswer>();
  CHECK(refused.id == 1);
  CHECK(refused.answer.error().code == EditErrorCode::out_of_range);
  bench.edit(2, {{0, 5'000, 0}});
  CHECK(bench.only_mail<EditAnswer>().answer.error().code == EditErrorCode::out_of_range);
  bench.edit(3, {{0, 0, 0}});
  CHECK(bench.log.entries.size() == 1);
  bench.log.failure = EditError{EditErrorCode::unwritable, "the disk is full"};
  bench.edit(4, {{0, 0, 0}});
  const auto full = bench.only_mail<EditAnswer>();
  CHECK(full.answer.error().code == EditErrorCode::unwritable);
  CHECK(full.answer.error().message == "the disk is full");
  // No time makes room in a full index.
  bench.log.failure = EditError{EditErrorCode::index_full, "its limit of 512 bytes"};
  bench.edit(5, {{0, 0, 0}});
  const auto never = bench.only_mail<EditAnswer>();
  CHECK(never.answer.error().code == EditErrorCode::index_full);
  CHECK(never.answer.error().message == "its limit of 512 bytes");
  CHECK(bench.metrics.edits_refused[EditErrorCode::out_of_range].total() == 2);
  CHECK(bench.metrics.edits_refused[EditErrorCode::unwritable].total() == 1);
  CHECK(bench.metrics.edits_refused[EditErrorCode::index_full].total() == 1);
}

TEST_CASE("a failed look-up fails its edit alone") {
  Bench bench;
  bench.edit(1, {{0, 0, 0}});
  bench.source.fail({{0, 0, 0}, Lod{}});
  bench.source.last_mailbox->wake();
  bench.intake.do_what_waits();
  CHECK(bench.only_mail<EditAnswer>().answer.error().code == EditErrorCode::ground);
  bench.edit(2, {{0, 0, 0}});
  bench.look_ups_answered(kStone);
  CHECK(bench.log.entries.size() == 1);
}

TEST_CASE("an edit of which one look-up failed needs the others no more") {
  Bench bench;
  bench.edit(1, {{0, 0, 0}, {33, 0, 0}});
  bench.source.fail({{0, 0, 0}, Lod{}});
  bench.source.last_mailbox->wake();
  bench.intake.do_what_waits();
  CHECK(bench.source.waiting.empty());
}

TEST_CASE("nothing more of a closed session is looked up or logged") {
  Bench bench;
  bench.edit(1, {{0, 0, 0}});
  CHECK(bench.source.waiting.size() == 1);
  bench.intake.forget(ClientId{1});
  bench.intake.do_what_waits();
  CHECK(bench.source.waiting.empty());
  CHECK(bench.log.entries.empty());
}

TEST_CASE("for a session whose client sends no more no ground is generated, and its other edits go on") {
  Bench bench;
  bench.source.in_memory[{{5, 0, 0}, Lod{}}] = of(kStone);
  bench.edit(1, {{0, 0, 0}, {33, 0, 0}});
  bench.edit(2, {{160, 0, 0}});  // in memory
  bench.edit(3, {{65, 0, 0}});
  CHECK(bench.source.waiting.size() == 2);
  bench.intake.input_ended(ClientId{1});
  bench.intake.do_what_waits();
  CHECK(bench.source.waiting.empty());
  CHECK(bench.source.submitted == 2);
  REQUIRE(bench.log.entries.size() == 1);
  CHECK(bench.log.edit(0).sequence == 2);
  const auto mail = bench.session->take();
  REQUIRE(mail.size() == 2);
  for (std::size_t i = 0; i < mail.size(); ++i) {
    const auto& answer = std::get<EditAnswer>(mail[i]);
    CHECK(answer.id == 1 + 2 * i);
    CHECK(answer.answer.error().code == EditErrorCode::half_closed);
  }
  CHECK(bench.metrics.edits_refused[EditErrorCode::half_closed].total() == 2);
  CHECK(bench.intake.waiting() == 0);
}

TEST_CASE("a session receives the log's answer to its edit") {
  Bench bench;
  bench.source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  using Kind = edits::EntryResult::Kind;
  const auto told = [&](edits::EntryResult applied) {
    bench.edit(1, {{0, 0, 0}});
    bench.clock.advance(std::chrono::milliseconds{3});
    bench.log.entries.back().done(&applied);
    return bench.only_mail<EditAnswer>().answer;
  };
  edits::EntryResult applied;
  applied.kind = Kind::done;
  applied.result = {1, 11, 1, {}};
  CHECK(told(applied).value() == applied.result);
  CHECK(bench.metrics.edit_latency.read().sum_seconds == Approx(0.003));
  applied.kind = Kind::repeat;
  CHECK(told(applied).value() == applied.result);
  applied.result.conflict = 2;
  CHECK(told(applied).error().code == EditErrorCode::conflict);
  applied.kind = Kind::expired;
  CHECK(told(applied).error().code == EditErrorCode::expired);
  applied.kind = Kind::not_applied;
  CHECK(told(applied).error().code == EditErrorCode::not_applied);
  applied.is_unknown = true;
  CHECK(told(applied).error().code == EditErrorCode::out_of_range);
  bench.edit(1, {{0, 0, 0}});
  bench.log.entries.back().done(tl::unexpected{EditError{EditErrorCode::unwritable, "the disk is full"}});
  CHECK(bench.only_mail<EditAnswer>().answer.error().code == EditErrorCode::unwritable);
}

TEST_CASE("Attach goes on as the editor that is known to the same subject, else as a new one") {
  Bench bench;
  bench.editors[kEditor] = {.epoch = 4, .last_sequence = 17, .used_ms = 0, .subject = "ann", .results = {}};
  std::uint64_t client = 0;
  const auto attach = [&](AttachRequest request) {
    bench.session = std::make_shared<Mailbox>(ClientId{++client}, [] {});
    bench.intake.attach(bench.session, std::move(request));
    bench.intake.do_what_waits();
    return std::get<edits::AttachEntry>(bench.log.entries.back().entry);
  };
  const auto again = attach({kEditor, "ann", 0});
  CHECK(again.editor == kEditor);
  CHECK(again.epoch == 5);
  const auto stolen = attach({kEditor, "eve", 0});
  CHECK(stolen.editor != kEditor);
  CHECK(stolen.epoch == 1);
  CHECK(stolen.subject == "eve");
  CHECK(attach({{}, "", 0}).editor != edits::EditorId{});
  // Whatever a session calls itself, it stays the editor that it is, and is told that the other is unknown.
  const auto named = attach({{77, 77}, "ann", 0, kEditor});
  CHECK(named.editor == kEditor);
  CHECK(named.epoch == 5);
  bench.editors[kEditor].epoch = 5;
  edits::EntryResult as_before;
  as_before.kind = edits::EntryResult::Kind::attached;
  bench.log.entries.back().done(&as_before);
  bench.intake.do_what_waits();
  const auto told = bench.only_mail<AttachAnswer>().answer.value();
  CHECK(told.editor == kEditor);
  CHECK_FALSE(told.known);
  CHECK(told.last_sequence == 17);
  CHECK(attach({{77, 77}, "eve", 0, kEditor}).editor != kEditor);
  bench.editors[kEditor].epoch = 4;

  edits::EntryResult applied;
  applied.kind = edits::EntryResult::Kind::attached;
  applied.revision = 12;
  bench.editors[kEditor].epoch = 5;
  attach({kEditor, "ann", 0});
  bench.editors[kEditor].epoch = 6;
  bench.log.entries.back().done(&applied);
  bench.editors[kEditor].epoch = 7;  // another attaches before this one is told
  bench.intake.do_what_waits();
  const auto answer = bench.only_mail<AttachAnswer>().answer.value();
  CHECK(answer.editor == kEditor);
  CHECK(answer.epoch == 6);
  CHECK(answer.last_sequence == 17);
  CHECK(answer.known);
  CHECK(answer.revision == 12);
}

TEST_CASE("a client that has seen newer revisions waits, and one of two simultaneous Attaches is retried") {
  Bench bench;
  bench.intake.attach(bench.session, {{}, "", 11});
  bench.intake.do_what_waits();
  edits::EntryResult applied;
  applied.kind = edits::EntryResult::Kind::attached;
  applied.revision = 10;
  bench.log.entries[0].done(&applied);
  bench.intake.do_what_waits();
  CHECK(bench.only_mail<AttachAnswer>().answer.error().code == EditErrorCode::behind);
  // What other servers did before is there by the time that the log has the Attach.
  bench.intake.attach(bench.session, {{}, "", 11});
  bench.intake.do_what_waits();
  applied.revision = 11;
  bench.log.entries[1].done(&applied);
  bench.intake.do_what_waits();
  CHECK(bench.only_mail<AttachAnswer>().answer.has_value());

  bench.intake.attach(bench.session, {{}, "", 10});
  bench.intake.do_what_waits();
  applied.kind = edits::EntryResult::Kind::superseded;
  bench.log.entries[2].done(&applied);
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 4);
}

TEST_CASE("an Attach of an editor that this server does not know yet waits for it") {
  Bench bench;
  const edits::EditorId elsewhere{77, 77};
  bench.intake.attach(bench.session, {elsewhere, "ann", 0});
  bench.intake.do_what_waits();
  const auto first = std::get<edits::AttachEntry>(bench.log.entries.back().entry);
  CHECK(first.editor != elsewhere);
  // Before that entry the log had the editor.
  edits::Editor& editor = bench.editors[elsewhere];
  editor.epoch = 3;
  editor.last_sequence = 8;
  editor.subject = "ann";
  edits::EntryResult applied;
  applied.kind = edits::EntryResult::Kind::attached;
  bench.log.entries.back().done(&applied);
  bench.intake.do_what_waits();
  REQUIRE(bench.log.entries.size() == 2);
  const auto second = std::get<edits::AttachEntry>(bench.log.entries.back().entry);
  CHECK(second.editor == elsewhere);
  CHECK(second.epoch == 4);
  bench.editors[elsewhere].epoch = 4;
  bench.log.entries.back().done(&applied);
  bench.intake.do_what_waits();
  const auto told = bench.only_mail<AttachAnswer>().answer.value();
  CHECK(told.editor == elsewhere);
  CHECK(told.known);
  CHECK(told.last_sequence == 8);
}

TEST_CASE("few edits wait in the log, and a newcomer goes before sessions that have sent many") {
  Bench bench;
  bench.source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  const auto send = [&](const MailboxPtr& from, std::uint32_t id) {
    EditRequest request{id, {static_cast<std::uint64_t>(from->owner()), 1}, 1, id, {}};
    request.edit.writes = {{{1, 0, 0}, kGlass}};
    bench.intake.edit(from, measured(std::move(request)));
  };
  std::vector<MailboxPtr> flood;
  for (std::uint64_t id = 100; id < 200; ++id) {
    flood.push_back(std::make_shared<Mailbox>(ClientId{id}, [] {}));
    for (std::uint32_t edit = 1; edit <= 64; ++edit) send(flood.back(), edit);
  }
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == EditIntake::kLogEntries);
  CHECK(bench.intake.waiting() == 6'400 - EditIntake::kLogEntries);
  // The first waits for no room. Of the next ones one of each of the hundred goes before, and not all that
  // they have sent.
  for (std::uint32_t id = 1; id <= 3; ++id) {
    const std::size_t before = bench.log.entries.size();
    send(bench.session, id);
    bench.intake.do_what_waits();
    const auto own = [&] {
      return bench.log.entries.size() > before &&
             bench.log.edit(bench.log.entries.size() - 1).editor.low == 1;
    };
    CHECK(own() == (id == 1));
    while (!own()) {
      bench.log.answer_one();
      bench.intake.do_what_waits();
      REQUIRE(bench.log.entries.size() <= before + 102);
    }
  }
  // Those who flood have equal shares of what is left.
  while (bench.log.answered < bench.log.entries.size()) {
    bench.log.answer_one();
    bench.intake.do_what_waits();
  }
  CHECK(bench.log.entries.size() == 6'403);
  CHECK(bench.intake.waiting() == 0);
  std::map<std::uint64_t, int> of_session;
  for (std::size_t i = 0; i < 3'200; ++i) ++of_session[bench.log.edit(i).editor.low];
  for (const MailboxPtr& each : flood) {
    CHECK(of_session[static_cast<std::uint64_t>(each->owner())] == Approx(32).margin(3));
  }
}

TEST_CASE("many small edits do not keep a large one from the log, nor do edits of many chunks a small one") {
  Bench bench;
  for (std::int32_t x = 0; x < 64; ++x) bench.source.in_memory[{{x, 0, 0}, Lod{}}] = of(kStone);
  const std::int32_t chunks = GENERATE(1, 64);
  const auto flow = std::make_shared<FlowUse>(FlowId{9}, FlowName{});
  std::vector<MailboxPtr> crowd;
  for (std::uint64_t id = 100; id < 200; ++id) {
    crowd.push_back(std::make_shared<Mailbox>(
        ClientId{id}, [] {}, flow));
    EditRequest request{1, {id, 1}, 1, 1, {}};
    for (std::int32_t x = 0; x < chunks; ++x) request.edit.guards.push_back({{x * 32, 0, 0}, kStone});
    bench.intake.edit(crowd.back(), measured(std::move(request)));
  }
  EditRequest alone{1, kEditor, 3, 1, {}};
  if (chunks == 1) {
    alone.edit.fills = {{{0, 0, 0}, {15, 15, 15}, kGlass, {}}};
  } else {
    alone.edit.writes = {{{0, 0, 0}, kGlass}};
  }
  bench.intake.edit(bench.session, measured(std::move(alone)));
  bench.intake.do_what_waits();
  std::size_t place = 0;
  while (place < bench.log.entries.size() && bench.log.edit(place).editor != kEditor) ++place;
  CHECK(place <= 2);
}

TEST_CASE("edits made while no session waited are not charged later") {
  Bench bench;
  bench.source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  EditRequest large{1, kEditor, 3, 1, {}};
  large.edit.fills = {{{0, 0, 0}, {31, 31, 31}, kGlass, {}}};
  bench.intake.edit(bench.session, measured(std::move(large)));
  bench.intake.do_what_waits();
  REQUIRE(bench.log.entries.size() == 1);
  const MailboxPtr other = std::make_shared<Mailbox>(ClientId{2}, [] {});
  const auto send = [&](const MailboxPtr& from, std::uint32_t id) {
    EditRequest request{id, {static_cast<std::uint64_t>(from->owner()), 2}, 3, id, {}};
    request.edit.writes = {{{1, 0, 0}, kGlass}};
    bench.intake.edit(from, measured(std::move(request)));
  };
  send(bench.session, 2);
  for (std::uint32_t id = 1; id <= 5; ++id) send(other, id);
  bench.intake.do_what_waits();
  REQUIRE(bench.log.entries.size() == 7);
  CHECK(bench.log.edit(1).editor.low == 2);  // who has none in the log goes first
  CHECK(bench.log.edit(2).editor.low == 1);
}

TEST_CASE("if memory runs out, requests that arrive meanwhile still wait, and are uncounted once") {
  struct ExhaustedLog final : EditLog {
    std::function<void()> meanwhile;
    std::promise<void> logged;
    tl::expected<void, EditError> append(LogEntry, Callback) override {
      if (const auto once = std::exchange(meanwhile, nullptr)) {
        once();
        throw std::bad_alloc{};
      }
      logged.set_value();
      return {};
    }
  };
  ScriptedSource source;
  source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  ExhaustedLog log;
  ManualClock clock;
  Metrics metrics;
  EditIntake intake{{source, log, [](edits::EditorId) { return std::nullopt; }, clock, metrics},
                    {{0, 100}, {kAir, kStone, kGlass}},
                    make_logger("off", "text")};
  const auto send = [&](const MailboxPtr& from) {
    EditRequest request{1, kEditor, 3, 1, {}};
    request.edit.writes = {{{1, 0, 0}, kGlass}};
    intake.edit(from, measured(std::move(request)));
  };
  const MailboxPtr first = std::make_shared<Mailbox>(ClientId{1}, [] {});
  const MailboxPtr second = std::make_shared<Mailbox>(ClientId{2}, [] {});
  log.meanwhile = [&] { std::thread{[&] { send(second); }}.join(); };
  intake.start();
  send(first);
  log.logged.get_future().get();
  intake.stop();
  CHECK(first->has_lost());
  CHECK_FALSE(second->has_lost());
  CHECK(intake.waiting() == 0);
}

TEST_CASE("in the log wait few bytes, but one edit alone may have more") {
  Bench bench;
  bench.source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  bench.source.in_memory[{{1, 0, 0}, Lod{}}] = of(kStone);
  for (std::uint32_t id = 1; id <= 8; ++id) {
    EditRequest request{id, kEditor, 3, id, {}};
    request.edit.fills = {{{0, 0, 0}, {63, 31, 31}, kGlass, {}}};  // 256 KiB of base
    bench.intake.edit(bench.session, measured(std::move(request)));
  }
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 1);
  bench.log.answer_one();
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 2);
}

TEST_CASE("large edits whose ground was looked up wait for room in the log, and small ones go before them") {
  Bench bench;
  std::vector<MailboxPtr> crowd;
  for (std::uint64_t id = 100; id < 140; ++id) {
    const auto flow = std::make_shared<FlowUse>(FlowId{id % 4}, FlowName{});
    crowd.push_back(std::make_shared<Mailbox>(
        ClientId{id}, [] {}, flow));
    EditRequest request{1, {id, 1}, 1, 1, {}};
    const auto x = static_cast<std::int64_t>(id) * 64;
    request.edit.fills = {{{x, 0, 0}, {x + 39, 39, 39}, kGlass, {}}};
    bench.intake.edit(crowd.back(), measured(std::move(request)));
  }
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.empty());
  while (!bench.source.waiting.empty()) {
    const auto [key, look_ups] = *bench.source.waiting.begin();
    bench.source.mail(key, of(kStone));
    look_ups->wake();
  }
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 1);  // of over 256 KiB
  bench.edit(1, {{0, 0, 0}});
  bench.look_ups_answered(kStone);
  REQUIRE(bench.log.entries.size() == 2);
  CHECK(bench.log.edit(1).editor == kEditor);
  // One that is larger needs room, too, and still goes before them.
  EditRequest medium{1, {50, 1}, 1, 1, {}};
  medium.edit.fills = {{{-64, 0, 0}, {-49, 15, 15}, kGlass, {}}};
  bench.intake.edit(std::make_shared<Mailbox>(ClientId{2}, [] {}), measured(std::move(medium)));
  while (bench.log.answered < bench.log.entries.size()) {
    bench.log.answer_one();
    bench.intake.do_what_waits();
    bench.look_ups_answered(kStone);
  }
  std::size_t place = 0;
  while (place < bench.log.entries.size() && bench.log.edit(place).editor.low != 50) ++place;
  CHECK(place <= 6);
  CHECK(bench.log.entries.size() == 42);
}

TEST_CASE("the Attach of a closed session is not retried, and so does not take over an editor") {
  Bench bench;
  bench.editors[kEditor] = {.epoch = 4, .last_sequence = 17, .used_ms = 0, .subject = "ann", .results = {}};
  const MailboxPtr live = std::make_shared<Mailbox>(ClientId{2}, [] {});
  bench.intake.attach(bench.session, {kEditor, "ann", 0});
  bench.intake.do_what_waits();
  bench.intake.attach(live, {kEditor, "ann", 0});
  bench.intake.do_what_waits();
  REQUIRE(bench.log.entries.size() == 2);
  bench.intake.forget(bench.session->owner());
  edits::EntryResult superseded;
  superseded.kind = edits::EntryResult::Kind::superseded;
  edits::EntryResult applied;
  applied.kind = edits::EntryResult::Kind::attached;
  bench.editors[kEditor].epoch = 5;
  bench.log.entries[1].done(&applied);
  bench.log.entries[0].done(&superseded);
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 2);
  CHECK(bench.session->take().empty());
  REQUIRE(live->take().size() == 1);

  // One that waits here when its session goes is not logged at all.
  bench.intake.attach(bench.session, {kEditor, "ann", 0});
  bench.intake.forget(bench.session->owner());
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 2);
  CHECK(bench.intake.waiting() == 0);
}

TEST_CASE("if two sessions attach as one editor, the earlier one does not retry") {
  Bench bench;
  bench.editors[kEditor] = {.epoch = 4, .last_sequence = 17, .used_ms = 0, .subject = "ann", .results = {}};
  const MailboxPtr later = std::make_shared<Mailbox>(ClientId{2}, [] {});
  bench.intake.attach(bench.session, {kEditor, "ann", 0});
  bench.intake.do_what_waits();
  bench.intake.attach(later, {kEditor, "ann", 0});
  bench.intake.do_what_waits();
  edits::EntryResult superseded;
  superseded.kind = edits::EntryResult::Kind::superseded;
  bench.log.entries[0].done(&superseded);
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 2);
  CHECK(bench.only_mail<AttachAnswer>().answer.error().code == EditErrorCode::overtaken);
  bench.log.entries[1].done(&superseded);
  bench.intake.do_what_waits();
  CHECK(bench.log.entries.size() == 3);
}

TEST_CASE("a small edit goes to the log on the thread that brings it, while the intake rests") {
  struct TellingLog final : EditLog {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<std::pair<std::uint64_t, std::thread::id>> sequences;
    tl::expected<void, EditError> append(LogEntry entry, Callback done) override {
      edits::EntryResult applied;
      applied.kind = edits::EntryResult::Kind::done;
      done(&applied);
      const std::lock_guard lock{mutex};
      sequences.emplace_back(std::get<edits::EditEntry>(entry).sequence, std::this_thread::get_id());
      came.notify_one();
      return {};
    }
  } log;
  ScriptedSource source;
  source.in_memory[{{0, 0, 0}, Lod{}}] = of(kStone);
  ManualClock clock;
  Metrics metrics;
  EditIntake intake{{source, log, [](edits::EditorId) { return std::nullopt; }, clock, metrics},
                    {{0, 100}, {kAir, kStone, kGlass}},
                    make_logger("off", "text")};
  intake.start();
  const MailboxPtr session = std::make_shared<Mailbox>(ClientId{1}, [] {});
  const auto edit = [&](std::uint32_t number, VoxelPos voxel) {
    EditRequest request{number, kEditor, 3, number, {}};
    request.edit.writes.push_back({voxel, kGlass});
    intake.edit(session, measured(std::move(request)));
    std::unique_lock lock{log.mutex};
    log.came.wait(lock, [&] { return log.sequences.size() == number; });
    return log.sequences.back().second == std::this_thread::get_id();
  };
  CHECK_FALSE(edit(1, {0, 0, 0}));  // nobody has decoded the chunk
  std::uint32_t number = 2;
  // The intake's thread may not have come to rest yet.
  while (!edit(number, {1, 0, 0}) && number < 1'000'000) ++number;
  CHECK(number < 1'000'000);
  for (std::uint32_t i = 0; i < number; ++i) CHECK(log.sequences[i].first == i + 1);
}

}  // namespace talus::server
