#include "proofs.h"

#include <algorithm>

namespace talus::client {

std::vector<Proofs::Proof> Proofs::made(std::size_t chunks, std::vector<Proof> mixed, bool last) {
  uncounted_ += chunks;
  due_ += uncounted_ / kInterval * kProofsTogether;
  uncounted_ %= kInterval;
  std::vector<Proof> chosen;
  const auto choose = [&](std::vector<Proof>& from, std::size_t& due, std::size_t most) {
    for (; due > 0 && most > 0 && !from.empty(); --due, --most) {
      std::swap(from[below(from.size())], from.back());
      chosen.push_back(from.back());
      from.pop_back();
    }
  };
  if (!mixed.empty()) ++batches_;
  std::size_t root = 0;
  while (root * root < batches_) ++root;
  if (root * root == batches_) choose(mixed, first_, kProofsTogether);
  choose(mixed, due_, due_);
  for (const Proof& proof : mixed) {
    ++sampled_;
    if (sample_.size() < kMaxSample) {
      sample_.push_back(proof);
    } else if (const std::size_t place = below(sampled_); place < kMaxSample) {
      sample_[place] = proof;
    }
  }
  if (last) {
    choose(sample_, first_, first_);
    choose(sample_, due_, due_);
  }
  return chosen;
}

}  // namespace talus::client
