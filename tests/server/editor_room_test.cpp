// What editors may take of memory: as it is counted, and how a log keeps it.
#include "edits/admission/log_admission.h"

#include <malloc.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include <catch2/catch.hpp>

#include <talus/edits/editors.h>

#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
using Kind = edits::EntryResult::Kind;

/// What malloc has given away. The same always under a sanitizer, which has its own.
std::size_t allocated() {
  return mallinfo2().uordblks;
}

}  // namespace

TEST_CASE("an editor takes no more memory than is counted for it") {
  constexpr std::size_t kEditors = 500;
  const std::string subject(edits::kMaxSubjectBytes, 's');
  edits::Editors all;
  std::unordered_set<edits::EditorId> dirty;
  const std::size_t before = allocated();
  for (std::uint64_t low = 1; low <= kEditors; ++low) {
    edits::Editor attached;
    attached.epoch = 1;
    attached.subject = subject;
    all.put({low, 1}, {std::move(attached), true});
    dirty.insert({low, 1});
  }
  CHECK(allocated() - before <= kEditors * EditState::kNewEditorBytes);
  // As batches of several edits of one editor leave them, one after the other.
  for (std::uint64_t low = 1; low <= kEditors; ++low) {
    for (std::uint64_t sequence = 0; sequence < 100;) {
      edits::EditorChange change;
      change.editor.subject = subject;
      for (std::uint64_t more = 1 + sequence % 3; more > 0; --more) {
        change.editor.keep({.sequence = ++sequence, .revision = sequence, .changed = 1, .conflict = {}});
      }
      all.put({low, 1}, std::move(change));
    }
    REQUIRE(all.find({low, 1})->results.capacity() <= edits::kKeptResults);
  }
  CHECK(all.find({1, 1})->results.size() == edits::kKeptResults);
  CHECK(allocated() - before <= kEditors * EditState::kUsedEditorBytes);
}

TEST_CASE("if editors use all their memory, new ones are refused until the oldest have been idle for a day") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  EditStore store{scratch / "edits"};
  store.state_settings.editor_bytes = EditState::kUsedEditorBytes + EditState::kNewEditorBytes;
  REQUIRE(store.open() == "");
  const auto attach = [](std::uint64_t id, std::uint64_t epoch, std::string_view subject = "s") {
    return edits::AttachEntry{{id, 1}, epoch, std::string{subject}};
  };
  CHECK(admit_editor(store.state(), SystemClock{}).has_value());
  REQUIRE(store.apply(attach(1, 1))->kind == Kind::attached);
  CHECK(store.state().editor_bytes() == EditState::kNewEditorBytes);
  REQUIRE(store.apply(edits::EditEntry{{1, 1}, 1, 1, {}, {}})->kind == Kind::done);
  CHECK(store.state().editor_bytes() == EditState::kUsedEditorBytes);
  REQUIRE(store.apply(attach(2, 1))->kind == Kind::attached);
  const auto refused = store.log().append(attach(3, 1), [](const auto&) {});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().code == EditErrorCode::editors_full);
  CHECK_FALSE(admit_editor(store.state(), SystemClock{}).has_value());  // what a session asks before
  CHECK(store.apply(attach(2, 2))->kind == Kind::attached);             // who is known
  CHECK(store.apply(edits::EditEntry{{2, 1}, 2, 1, {}, {}})->kind == Kind::done);
  CHECK(store.apply(attach(4, 1, edits::kOperatorSubject))->kind == Kind::attached);
  CHECK(store.state().bytes() >= 2 * EditState::kUsedEditorBytes + EditState::kNewEditorBytes);

  // Else nobody would ever come in: applying an Attach is what forgets them.
  struct Tomorrow final : Clock {
    SystemClock now_clock;
    [[nodiscard]] time_point now() const override { return now_clock.now(); }
    [[nodiscard]] std::chrono::sys_seconds wall() const override {
      return now_clock.wall() + std::chrono::hours{25};
    }
    [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override { return now_clock.thread_cpu(); }
  };
  LogEntry newcomer = attach(5, 1);
  CHECK(admit_to_log(newcomer, store.state(), Tomorrow{}).has_value());
  CHECK(admit_editor(store.state(), Tomorrow{}).has_value());
  CHECK_FALSE(admit_to_log(newcomer, store.state(), SystemClock{}).has_value());
}

}  // namespace talus::server
