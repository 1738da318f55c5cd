#include "proofs.h"

namespace talus::client {

std::vector<Proofs::Proof> Proofs::made(std::size_t chunks, const std::vector<Proof>& mixed, bool last) {
  uncounted_ += chunks;
  due_ += uncounted_ / kChunksPerProof;
  uncounted_ %= kChunksPerProof;
  std::vector<Proof> chosen;
  std::size_t picked = mixed.size();
  if (due_ > 0 && !mixed.empty()) {
    picked = below(mixed.size());
    chosen.push_back(mixed[picked]);
    --due_;
  }
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    if (i == picked) continue;
    ++sampled_;
    if (sample_.size() < kMaxSample) {
      sample_.push_back(mixed[i]);
    } else if (const std::size_t place = below(sampled_); place < kMaxSample) {
      sample_[place] = mixed[i];
    }
  }
  for (; last && due_ > 0 && !sample_.empty(); --due_) {
    std::swap(sample_[below(sample_.size())], sample_.back());
    chosen.push_back(sample_.back());
    sample_.pop_back();
  }
  return chosen;
}

}  // namespace talus::client
