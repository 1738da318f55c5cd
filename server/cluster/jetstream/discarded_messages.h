// Messages of libnats that are done with. It frees each on a thread of its own, which sleeps in between: many
// at once wake it once.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "cluster/jetstream/nats_handles.h"

namespace talus::server::jetstream {

/// One thread at a time.
class DiscardedMessages {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr std::size_t kMostBytes = std::size_t{256} << 10U;  // of their data

  void add(NatsMessage message) {
    bytes_ += static_cast<std::size_t>(natsMsg_GetDataLength(message.get()));
    messages_.push_back(std::move(message));
    if (messages_.size() < kMost && bytes_ < kMostBytes) return;
    messages_.clear();
    bytes_ = 0;
  }
  [[nodiscard]] std::size_t size() const { return messages_.size(); }

 private:
  std::vector<NatsMessage> messages_;
  std::size_t bytes_ = 0;
};

}  // namespace talus::server::jetstream
