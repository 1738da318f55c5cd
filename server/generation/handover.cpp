#include "generation/handover.h"

#include <exception>
#include <utility>

namespace talus::server {
namespace {

// About fifteen chunks: no player sees it, and most wakings are saved.
constexpr std::chrono::microseconds kSoon{500};

}  // namespace

// One client's trouble must not keep the answers from the others, nor end the thread.
template <typename Step>
void Handover::log_failure(std::size_t chunks, Step&& step) {
  try {
    step();
  } catch (const std::exception& error) {
    log_->error("{} chunks could not be handed over: {}", chunks, error.what());
  }
}

void Handover::add(const std::vector<ChunkClientPtr>& waiters, ChunkKey key, const ChunkAnswer& answer) {
  for (const ChunkClientPtr& waiter : waiters) {
    log_failure(1, [&] { parcels_[waiter].push_back({key, answer}); });
  }
  if (!parcels_.empty() && Clock::now() - handed_over_ >= kSoon) flush();
}

void Handover::flush() {
  for (auto& [client, chunks] : parcels_) {
    log_failure(chunks.size(),
                [&, waiter = client.get(), made = &chunks] { waiter->chunks_ready(std::move(*made)); });
  }
  parcels_.clear();
  handed_over_ = Clock::now();
}

}  // namespace talus::server
