// The log's entries, applied exactly once: random attaches and edits of several editors against a model that
// keeps everything for ever; and the same log in any batches.
#include <algorithm>
#include <variant>

#include <rapidcheck.h>
#include <talus/edits/batch.h>
#include <catch2/catch.hpp>

#include "log_model.h"

namespace talus::edits {
namespace {

using namespace testing;
using Kind = EntryResult::Kind;

std::uint64_t between(std::uint64_t first, std::uint64_t last) {
  return *rc::gen::inRange<std::uint64_t>(first, last + 1);
}

Entry any_entry(const LogModel& log) {
  const EditorId id{between(1, 4), 5};
  const LogModel::Editor editor = log.editor(id);
  if (between(0, 5) == 0) {
    // Mostly the next epoch, mostly of the same subject.
    const std::uint64_t epoch = between(0, 5) == 0 ? between(0, 5) : editor.epoch + 1;
    return AttachEntry{id, epoch, between(0, 9) == 0 ? "another" : "somebody"};
  }
  EditEntry entry{id, editor.epoch, editor.last + between(1, 3), any_edit(log.model()), {}};
  if (between(0, 3) == 0) entry.sequence = between(0, editor.last);  // sent again
  if (between(0, 9) == 0) entry.epoch = between(0, 5);
  entry.base = base_of(entry.edit);
  if (between(0, 1) == 0) entry.touched = *touched_voxels(entry.edit);
  if (between(0, 19) == 0) entry.base.clear();
  return entry;
}

}  // namespace

TEST_CASE("random entries of several editors do what the model says, each edit at most once") {
  CHECK(rc::check([] {
    Store store;
    LogModel model;
    std::vector<Entry> log;
    std::vector<EntryResult> results;
    for (std::uint64_t batches = between(1, 6); batches > 0; --batches) {
      Batch batch{store.state, store.editors, store.head, static_cast<std::int64_t>(model.position())};
      for (std::uint64_t entries = between(1, 10); entries > 0; --entries) {
        const Entry entry = any_entry(model);
        const EntryResult& applied =
            std::visit([&](const auto& each) -> const EntryResult& { return batch.apply(each); }, entry);
        RC_ASSERT(model.follow(entry, applied) == "");
        log.push_back(entry);
      }
      for (EntryResult& each : store.commit(batch)) results.push_back(std::move(each));
      RC_ASSERT(store.state.overrides(Lod{}) == model.model().overrides());
    }
    // All of it again, cut otherwise: the same.
    Store other;
    std::vector<EntryResult> others;
    for (std::size_t at = 0; at < log.size();) {
      const std::size_t end = std::min(log.size(), at + between(1, 20));
      const std::vector<Entry> part(log.begin() + static_cast<std::ptrdiff_t>(at),
                                    log.begin() + static_cast<std::ptrdiff_t>(end));
      for (EntryResult& each : other.apply(part, 1'000)) others.push_back(std::move(each));
      at = end;
    }
    RC_ASSERT(std::equal(results.begin(), results.end(), others.begin(), others.end(), same));
    RC_ASSERT(other.head.position == store.head.position);
    RC_ASSERT(other.head.revision == store.head.revision);
    RC_ASSERT(other.head.hash == store.head.hash);
    RC_ASSERT(other.state.chunks == store.state.chunks);
  }));
}

TEST_CASE("a batch that is dropped leaves nothing, and its entries may come again") {
  Store store;
  store.apply({AttachEntry{{1, 1}, 1, ""}}, 5);
  Edit edit;
  edit.writes.push_back({{0, 0, 0}, MaterialId{9}});
  const EditEntry entry{{1, 1}, 1, 1, edit, base_of(edit)};
  {
    Batch dropped{store.state, store.editors, store.head, 6};
    CHECK(dropped.apply(entry).kind == Kind::done);
    CHECK(dropped.apply(entry).kind == Kind::repeat);
  }
  CHECK(store.head.position == 1);
  const auto applied = store.apply({entry}, 7);
  CHECK(applied.front().kind == Kind::done);
  CHECK(applied.front().position == 2);
  CHECK(applied.front().revision == 1);
}

TEST_CASE("results of the newest edits are kept, and edits before them may have been applied") {
  constexpr std::uint64_t kLast = 2 * kKeptResults;
  for (const std::uint64_t in_batch : {std::uint64_t{0}, std::uint64_t{10}, std::uint64_t{kKeptResults}}) {
    CAPTURE(in_batch);  // results that the batch makes, the others are the state's
    Store store;
    store.apply({AttachEntry{{1, 1}, 1, ""}}, 5);
    for (std::uint64_t sequence = 2; sequence <= kLast - 2 * in_batch; sequence += 2) {
      store.apply({EditEntry{{1, 1}, 1, sequence, {}, {}}}, 5);
    }
    Batch batch{store.state, store.editors, store.head, 5};
    for (std::uint64_t sequence = kLast - 2 * in_batch + 2; sequence <= kLast; sequence += 2) {
      batch.apply(EditEntry{{1, 1}, 1, sequence, {}, {}});
    }
    const auto apply = [&](std::uint64_t sequence) {
      const EntryResult& result = batch.apply(EditEntry{{1, 1}, 1, sequence, {}, {}});
      return std::pair{result.kind, result.is_unknown};
    };
    CHECK(apply(1) == std::pair{Kind::not_applied, true});
    CHECK(apply(2) == std::pair{Kind::repeat, false});
    CHECK(apply(3) == std::pair{Kind::not_applied, false});
    CHECK(apply(kLast + 2) == std::pair{Kind::done, false});
    CHECK(apply(2) == std::pair{Kind::not_applied, true});
    CHECK(apply(4) == std::pair{Kind::repeat, false});
    CHECK(apply(5) == std::pair{Kind::not_applied, false});
  }
}

TEST_CASE("the set of kept results does not depend on how a log is cut into batches") {
  const EditorId id{1, 2};
  const auto edit = [&](std::uint64_t epoch, std::uint64_t sequence) {
    EditEntry entry{id, epoch, sequence, {}, {}};
    entry.edit.writes.push_back({{3, 4, static_cast<std::int64_t>(sequence % 7)}, MaterialId{9}});
    entry.base = base_of(entry.edit);
    return Entry{entry};
  };
  std::vector<Entry> log{AttachEntry{id, 1, "a"}};
  std::uint64_t sequence = 0;
  for (int round = 0; round < 6; ++round) {
    // Fewer than are kept, as many, and more; then each of them again, and what came before them.
    for (const std::uint64_t last = sequence + kKeptResults / 2 + 20 * static_cast<std::uint64_t>(round);
         sequence < last;) {
      log.push_back(edit(1, ++sequence));
    }
    for (std::uint64_t back = 0; back < std::min<std::uint64_t>(sequence, 2 * kKeptResults); ++back) {
      log.push_back(edit(1, sequence - back));
    }
  }
  Store one_by_one;
  std::vector<EntryResult> expected;
  for (const Entry& entry : log) expected.push_back(one_by_one.apply({entry}, 5).at(0));
  CHECK(std::ranges::count(expected, Kind::repeat, &EntryResult::kind) > 300);
  CHECK(std::ranges::count(expected, Kind::not_applied, &EntryResult::kind) > 100);
  for (const std::size_t batch : {2U, 3U, 7U, 50U, 64U, 65U, 129U, 400U}) {
    CAPTURE(batch);
    Store store;
    std::vector<EntryResult> applied;
    for (std::size_t first = 0; first < log.size(); first += batch) {
      const auto begin = log.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = begin + static_cast<std::ptrdiff_t>(std::min(batch, log.size() - first));
      for (EntryResult& each : store.apply({begin, end}, 5)) applied.push_back(std::move(each));
    }
    CHECK(std::ranges::equal(applied, expected, same));
    CHECK(store.editors.all() == one_by_one.editors.all());
  }
}

TEST_CASE("an editor that was idle for a day is forgotten at the next attach, by the log's time") {
  Store store;
  store.apply({AttachEntry{{1, 1}, 1, ""}, AttachEntry{{2, 2}, 1, ""}}, 1'000);
  store.apply({EditEntry{{2, 2}, 1, 1, {}, {}}}, 2'000);
  store.apply({AttachEntry{{3, 3}, 1, ""}}, 1'000 + kEditorIdleMs - 1);
  CHECK(store.editors.size() == 3);
  // A clock that goes back forgets nobody.
  store.apply({AttachEntry{{4, 4}, 1, ""}}, 0);
  CHECK(store.editors.size() == 4);
  store.apply({AttachEntry{{5, 5}, 1, ""}}, 1'000 + kEditorIdleMs);
  CHECK(store.editors.find({1, 1}) == nullptr);
  CHECK(store.editors.find({2, 2}) != nullptr);
  const auto applied = store.apply({EditEntry{{1, 1}, 1, 1, {}, {}}, AttachEntry{{1, 1}, 1, "new"}}, 0);
  CHECK(applied[0].kind == Kind::expired);
  CHECK(applied[1].kind == Kind::attached);
}

TEST_CASE("a subject has a maximum size") {
  Store store;
  CHECK(store.apply({AttachEntry{{1, 1}, 1, std::string(kMaxSubjectBytes + 1, 's')}}, 0).front().kind ==
        Kind::invalid);
  CHECK(store.apply({AttachEntry{{1, 1}, 1, std::string(kMaxSubjectBytes, 's')}}, 0).front().kind ==
        Kind::attached);
}

namespace {

/// All editors that there may be; those whose number is a multiple of `used` have edited.
Store full_store(std::uint64_t used) {
  Store store;
  for (std::uint64_t first = 1; first <= kMaxEditors; first += 4'096) {
    std::vector<Entry> entries;
    for (std::uint64_t i = first; i < first + 4'096; ++i) {
      entries.emplace_back(AttachEntry{{i, 0}, 1, ""});
      if (i % used == 0) entries.emplace_back(EditEntry{{i, 0}, 1, 1, {}, {}});
    }
    for (const EntryResult& each : store.apply(entries, static_cast<std::int64_t>(first))) {
      REQUIRE((each.kind == Kind::attached || each.kind == Kind::done));
    }
  }
  return store;
}

}  // namespace

TEST_CASE("the number of editors is limited, and a new one replaces an idle one") {
  Store store = full_store(1);
  const Entry another = AttachEntry{{1, 9}, 1, ""};
  CHECK(store.apply({another}, 100'000).front().kind == Kind::editors_full);
  // Who undoes what others did has places of his own.
  for (std::uint64_t i = 1; i <= kOperatorEditors; ++i) {
    const Entry undoes = AttachEntry{{i, 8}, 1, std::string{kOperatorSubject}};
    CHECK(store.apply({undoes}, 100'000).front().kind == Kind::attached);
  }
  const Entry one_more = AttachEntry{{0, 8}, 1, std::string{kOperatorSubject}};
  CHECK(store.apply({one_more}, 100'000).front().forgotten);  // an operator who never edited
  const Entry again = AttachEntry{{kMaxEditors, 0}, 2, ""};
  CHECK(store.apply({again}, 100'000).front().kind == Kind::attached);
  CHECK(store.apply({another}, 70'000 + kEditorIdleMs).front().kind == Kind::attached);
  CHECK(store.editors.size() == 2 + kOperatorEditors);
}

TEST_CASE("too many editors evict the ones that never edited, however a log is cut into batches") {
  const Store full = full_store(2);
  std::vector<Entry> entries;
  for (std::uint64_t i = 1; i <= 40; ++i) {
    entries.emplace_back(AttachEntry{{i % 23 + 1, 9}, i / 23 + 1, ""});
    if (i % 5 == 0) entries.emplace_back(EditEntry{{i % 23 + 1, 9}, i / 23 + 1, i, {}, {}});
    if (i % 7 == 0) entries.emplace_back(AttachEntry{{2 * i + 1, 0}, 2, ""});  // uses that one again
  }
  std::vector<EntryResult> first;
  std::optional<Store> result;
  for (const std::size_t size : {entries.size(), std::size_t{1}, std::size_t{3}, std::size_t{7}}) {
    Store store = full;
    std::vector<EntryResult> all;
    for (std::size_t at = 0; at < entries.size(); at += size) {
      const auto from = entries.begin() + static_cast<std::ptrdiff_t>(at);
      const auto count = static_cast<std::ptrdiff_t>(std::min(size, entries.size() - at));
      for (EntryResult& each : store.apply({from, from + count}, 100'000)) all.push_back(std::move(each));
      CHECK(store.editors.size() == kMaxEditors);
    }
    if (first.empty()) {
      first = all;
      result = store;
    }
    REQUIRE(all.size() == first.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      CHECK(all[i].kind == first[i].kind);
      CHECK(all[i].forgotten == first[i].forgotten);
    }
    CHECK(store.editors.all() == result->editors.all());
  }
  CHECK(first[0].forgotten == EditorId{1, 0});
  CHECK(first[1].forgotten == EditorId{3, 0});
  for (std::uint64_t i = 2; i <= kMaxEditors; i += 2) REQUIRE(result->editors.find({i, 0}) != nullptr);
}

TEST_CASE("if none edited, editors of the same batch are evicted last") {
  Store store;
  for (std::uint64_t first = 1; first <= kMaxEditors; first += 4'096) {
    std::vector<Entry> entries;
    for (std::uint64_t i = first; i < first + 4'096; ++i) entries.emplace_back(AttachEntry{{i, 0}, 1, ""});
    store.apply(entries, 5);
  }
  std::vector<Entry> entries;
  for (std::uint64_t i = 1; i <= kMaxEditors + 2; ++i) entries.emplace_back(AttachEntry{{i, 1}, 1, ""});
  const auto applied = store.apply(entries, 6);
  CHECK(applied[kMaxEditors - 1].forgotten == EditorId{kMaxEditors, 0});
  CHECK(applied[kMaxEditors].forgotten == EditorId{1, 1});
  CHECK(store.editors.find({2, 1}) == nullptr);
  CHECK(store.editors.size() == kMaxEditors);
}

}  // namespace talus::edits
