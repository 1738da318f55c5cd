#include "generation/handover.h"

#include <algorithm>
#include <exception>

namespace talus::server {
namespace {

// About fifteen chunks: no player sees it, and most wakings are saved.
constexpr std::chrono::microseconds kSoon{500};

}  // namespace

void Handover::add(const std::vector<ChunkClientPtr>& waiters, ChunkKey key, const ChunkAnswer& answer) {
  for (const ChunkClientPtr& waiter : waiters) parcel_of(waiter).push_back({key, answer});
  if (Clock::now() - handed_over_ >= kSoon) flush();
}

void Handover::flush() {
  for (auto& [client, chunks] : parcels_) {
    const std::size_t count = chunks.size();
    // One client's trouble must not keep the answers from the others, nor end the thread.
    try {
      client->chunks_ready(std::move(chunks));
    } catch (const std::exception& error) {
      log_->error("{} chunks could not be handed over: {}", count, error.what());
    }
  }
  parcels_.clear();
  handed_over_ = Clock::now();
}

std::vector<ReadyChunk>& Handover::parcel_of(const ChunkClientPtr& client) {
  const auto found = std::find_if(parcels_.begin(), parcels_.end(),
                                  [&](const auto& parcel) { return parcel.first == client; });
  if (found != parcels_.end()) return found->second;
  return parcels_.emplace_back(client, std::vector<ReadyChunk>{}).second;
}

}  // namespace talus::server
