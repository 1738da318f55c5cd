// What the operators' port says while the server has no store yet, but takes one from a peer or waits for the
// cluster: that may take minutes, in which nobody should take it for dead, and none be sent here.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "admin/operators_page.h"

namespace talus::server {

struct JoinProgress {
  std::atomic<std::uint64_t> done{0};   // bytes of the peer's checkpoint
  std::atomic<std::uint64_t> total{0};  // 0: none comes yet
};

[[nodiscard]] OperatorAnswers joining_answers(std::shared_ptr<const JoinProgress> progress);

}  // namespace talus::server
