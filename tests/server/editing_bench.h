// A session that edits, for tests: what it brings to its taker is kept, and answered by the test.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "player/session/session.h"
#include "session_bench.h"

namespace talus::server {

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
  [[nodiscard]] bool reveals() const override { return has_secrets; }
  bool has_secrets = false;
  [[nodiscard]] bool knows(edits::EditorId editor, const std::string& subject) const override {
    return editor == known && subject.empty();
  }
  [[nodiscard]] tl::expected<void, EditError> room_for_editor() const override {
    if (full) return tl::unexpected{*full};
    return {};
  }
  edits::EditorId known{7, 7};
  std::optional<EditError> full;
};

inline Access editors() {
  Access access;
  access.without_token = "read,edit";
  return access;
}

inline Access gateways() {
  Access access;
  access.without_token = "read,edit,gateway";  // no setting gives it; Rights::parse does
  return access;
}

struct EditingBench {
  ScriptedTaker taker;
  SessionBench bench;

  explicit EditingBench(const RateLimits& rates = {}, const Access& access = editors(), EditRules rules = {},
                        AddressBucketsPtr address = {}, std::uint64_t memory_bytes = 0)
      : bench{{.rates = rates,
               .address = std::move(address),
               .memory_bytes = memory_bytes,
               .access = access,
               .edits = &taker,
               .rules = std::move(rules)}} {}

  void attached(std::uint64_t last_sequence = 0) {
    bench.attach();
    bench.mailbox->put(AttachAnswer{EditorSession{{1, 2}, 3, last_sequence, false, 9}});
    bench.take_mail();
    REQUIRE(kinds(bench.output()) == Kinds{wire::Body::Attached});
  }
  /// The answer to `id`, as values.
  SessionFrame answered(EditAnswer answer) {
    bench.mailbox->put(std::move(answer));
    bench.take_mail();
    return bench.output().at(0);
  }
};

}  // namespace talus::server
