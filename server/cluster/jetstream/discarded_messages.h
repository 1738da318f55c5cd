// Batches used libnats messages for disposal. libnats frees each on a thread that sleeps in between; a batch
// wakes it only once.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "cluster/jetstream/nats_handles.h"

namespace talus::server::jetstream {

/// Used by one thread at a time.
class DiscardedMessages {
 public:
  static constexpr std::size_t kMaxMessages = 64;
  static constexpr std::size_t kMaxBytes = std::size_t{256} << 10U;  // of message data

  void add(NatsMessage message) {
    bytes_ += static_cast<std::size_t>(natsMsg_GetDataLength(message.get()));
    messages_.push_back(std::move(message));
    if (messages_.size() < kMaxMessages && bytes_ < kMaxBytes) return;
    messages_.clear();
    bytes_ = 0;
  }
  [[nodiscard]] std::size_t size() const { return messages_.size(); }

 private:
  std::vector<NatsMessage> messages_;
  std::size_t bytes_ = 0;
};

}  // namespace talus::server::jetstream
