// A log of edits that answers when a test says so.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "edits/edit_taker.h"
#include "session_runner_bench.h"

namespace talus::server::session_runner_test {

/// Keeps what it is asked, and answers when the test says so.
struct WaitingTaker final : EditTaker {
  MailboxPtr mailbox;
  std::vector<EditRequest> edits;

  void attach(const MailboxPtr& of, AttachRequest) override { mailbox = of; }
  void edit(const MailboxPtr&, EditRequest request) override { edits.push_back(std::move(request)); }
  void input_ended(ClientId) override {}
  void forget(ClientId) override {}
  [[nodiscard]] bool settles() const override { return false; }
  [[nodiscard]] bool knows(edits::EditorId, const std::string&) const override { return false; }
};

/// An edit of one voxel with `guards` guards.
inline protocol::Frame guarded_edit(std::uint32_t id, std::size_t guards) {
  return protocol::make_frame([&](auto& builder) {
    const std::vector<wire::VoxelWrite> guarded(guards, wire::VoxelWrite{{1, 2, 3}, 1});
    const std::vector<wire::VoxelWrite> writes{{{1, 2, 3}, 1}};
    const auto list = builder.CreateVectorOfStructs(writes);
    return wire::CreateEdit(builder, id, list, id, builder.CreateVectorOfStructs(guarded));
  });
}

}  // namespace talus::server::session_runner_test
