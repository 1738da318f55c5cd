// Operators' pages of a server that downloads its store from a peer or waits for the cluster. That may take
// minutes, during which it must report itself alive but not ready.
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
  std::atomic<std::uint64_t> total{0};  // 0: not started

  /// Sets the store that the server must not use. Callable from any thread.
  void put_aside(const std::optional<AsideStore>& store);
  [[nodiscard]] std::optional<AsideStore> aside() const;

 private:
  mutable std::mutex mutex_;
  std::optional<AsideStore> aside_;
};

[[nodiscard]] OperatorAnswers joining_answers(std::shared_ptr<const JoinProgress> progress);

}  // namespace talus::server
