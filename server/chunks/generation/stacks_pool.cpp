#include "chunks/generation/stacks_pool.h"

#include <utility>

namespace talus::server {

StacksPool::StacksPool(std::size_t max_spare) : max_spare_{max_spare} {
  spare_.reserve(max_spare);  // so that giving back never fails
}

std::unique_ptr<terrain::Stacks> StacksPool::take() {
  {
    const std::lock_guard lock{mutex_};
    if (!spare_.empty()) {
      auto stacks = std::move(spare_.back());
      spare_.pop_back();
      return stacks;
    }
  }
  return std::make_unique<terrain::Stacks>();
}

StacksPtr StacksPool::share(std::unique_ptr<terrain::Stacks> stacks) {
  return std::shared_ptr<terrain::Stacks>{
      stacks.release(), [this](terrain::Stacks* done) { give_back(std::unique_ptr<terrain::Stacks>{done}); }};
}

void StacksPool::give_back(std::unique_ptr<terrain::Stacks> stacks) {
  const std::lock_guard lock{mutex_};
  if (spare_.size() < max_spare_) spare_.push_back(std::move(stacks));
}

}  // namespace talus::server
