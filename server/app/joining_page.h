// What the operators' port says while the server has no store yet, but takes one from a peer or waits for the
// cluster: that may take minutes, in which nobody should take it for dead, and none be sent here.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "admin/operators_page.h"
#include "cluster/checkpoint/aside_store.h"

namespace talus::server {

struct JoinProgress {
  std::atomic<std::uint64_t> done{0};   // bytes of the peer's checkpoint
  std::atomic<std::uint64_t> total{0};  // 0: none comes yet

  /// The server has a store that it must not use. Any thread.
  void put_aside(const std::optional<AsideStore>& store);
  [[nodiscard]] std::optional<AsideStore> aside() const;

 private:
  mutable std::mutex mutex_;
  std::optional<AsideStore> aside_;
};

[[nodiscard]] OperatorAnswers joining_answers(std::shared_ptr<const JoinProgress> progress);

}  // namespace talus::server
