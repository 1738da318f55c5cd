// What a client sends again, and as what, whatever the connection does.
#include "open_edits.h"

#include <catch2/catch.hpp>

namespace talus::client {
namespace {

constexpr edits::EditorId kEditor{1, 2};

/// `sequence` of what is sent, in order.
std::vector<std::uint64_t> send_all(OpenEdits& edits, std::vector<std::uint32_t>* ids = nullptr) {
  std::vector<std::uint64_t> sent;
  while (edits.has_next()) {
    const std::uint32_t id = edits.send_next();
    CHECK((id & OpenEdits::kIdBit) != 0);
    sent.push_back(edits.in_flight(id)->sequence);
    if (ids != nullptr) ids->push_back(id);
  }
  return sent;
}

void add(OpenEdits& edits, int count) {
  for (int i = 0; i < count; ++i) edits.add({});
}

}  // namespace

TEST_CASE("nothing is sent before there is an editor, and then as many as may be unanswered") {
  OpenEdits edits;
  CHECK_FALSE(edits.must_attach());
  add(edits, 5);
  CHECK(edits.must_attach());
  CHECK_FALSE(edits.has_next());
  edits.attach_sent();
  CHECK_FALSE(edits.must_attach());
  CHECK(edits.attached(kEditor, false, 7, 0, 3).empty());
  std::vector<std::uint32_t> ids;
  CHECK(send_all(edits, &ids) == std::vector<std::uint64_t>{8, 9, 10});
  (void)edits.take(ids[1]);
  CHECK(send_all(edits) == std::vector<std::uint64_t>{11});
}

TEST_CASE("after a new connection edits go again with their sequences, before others") {
  OpenEdits edits;
  add(edits, 3);
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 0, 64);
  std::vector<std::uint32_t> ids;
  (void)send_all(edits, &ids);
  (void)edits.take(ids[0]);
  edits.connection_ended();
  add(edits, 1);
  CHECK(edits.must_attach());
  edits.attach_sent();
  CHECK(edits.attached(kEditor, true, 2, 0, 64).empty());
  CHECK(send_all(edits) == std::vector<std::uint64_t>{2, 3, 4});
}

TEST_CASE("sent edits end as unknown, unsent edits as not applied") {
  OpenEdits edits;
  add(edits, 3);
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 0, 2);
  std::vector<std::uint32_t> ids;
  (void)send_all(edits, &ids);
  edits.send_as_new(ids[0]);
  const auto [sent, unsent] = edits.take_all();
  REQUIRE(sent.size() == 1);
  CHECK(sent.front().sequence == 2);
  CHECK(sent.front().sent_before);
  CHECK(unsent.size() == 2);
  CHECK(edits.empty());
}

TEST_CASE("edits of a forgotten editor end as unknown") {
  OpenEdits edits;
  add(edits, 2);
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 0, 1);
  (void)send_all(edits);
  edits.connection_ended();
  edits.attach_sent();
  const auto lost = edits.attached({3, 4}, false, 0, 0, 64);
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].sequence == 1);
  CHECK(send_all(edits) == std::vector<std::uint64_t>{1});  // the one that was never sent
}

TEST_CASE("an edit that was refused for now goes again as it is, before others") {
  OpenEdits edits;
  add(edits, 2);
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 0, 64);
  std::vector<std::uint32_t> ids;
  (void)send_all(edits, &ids);
  add(edits, 1);
  edits.put_back(ids[1]);
  edits.put_back(ids[0]);
  CHECK(send_all(edits) == std::vector<std::uint64_t>{1, 2, 3});
}

TEST_CASE("edits that certainly were not applied are sent as new ones, in order, before unsent edits") {
  OpenEdits edits;
  std::string order;
  for (const char* const name : {"a", "b", "c"}) {
    edits.add({{}, [&order, name](const Result<EditDone>&) { order += name; }, 0});
  }
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 0, 2);
  std::vector<std::uint32_t> ids;
  CHECK(send_all(edits, &ids) == std::vector<std::uint64_t>{1, 2});
  edits.send_as_new(ids[1]);
  edits.send_as_new(ids[0]);
  ids.clear();
  CHECK(send_all(edits, &ids) == std::vector<std::uint64_t>{3, 4});
  for (const std::uint32_t id : ids) edits.take(id).handler(EditDone{});
  ids.clear();
  CHECK(send_all(edits, &ids) == std::vector<std::uint64_t>{5});
  edits.take(ids[0]).handler(EditDone{});
  CHECK(order == "abc");
}

TEST_CASE("a client attaches again when the old editor's edits are answered, and not before") {
  OpenEdits edits;
  add(edits, 2);
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 0, 64);
  std::vector<std::uint32_t> ids;
  (void)send_all(edits, &ids);
  edits.put_back(ids[0]);
  edits.editor_expired();
  CHECK_FALSE(edits.must_attach());
  edits.put_back(ids[1]);
  edits.editor_expired();
  REQUIRE(edits.must_attach());
  edits.attach_sent();
  CHECK(edits.attached(kEditor, true, 0, 0, 64).empty());
  CHECK(send_all(edits) == std::vector<std::uint64_t>{1, 2});
}

TEST_CASE("another store knows nothing of this editor") {
  OpenEdits edits;
  add(edits, 1);
  edits.attach_sent();
  (void)edits.attached(kEditor, false, 0, 41, 64);
  (void)send_all(edits);
  edits.connection_ended();
  CHECK(edits.forget_editor().size() == 1);
  CHECK(edits.editor() == edits::EditorId{});
  CHECK(edits.seen_revision() == 0);
  CHECK(edits.empty());
}

}  // namespace talus::client
