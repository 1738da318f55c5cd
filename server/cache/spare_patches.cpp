#include "cache/spare_patches.h"

#include <utility>

namespace talus::server {

SparePatches::SparePatches(std::size_t most) : most_{most} {
  spare_.reserve(most);  // so that giving back never fails
}

std::unique_ptr<terrain::Stacks> SparePatches::take() {
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

StacksPtr SparePatches::share(std::unique_ptr<terrain::Stacks> stacks) {
  return std::shared_ptr<terrain::Stacks>{
      stacks.release(), [this](terrain::Stacks* done) { give_back(std::unique_ptr<terrain::Stacks>{done}); }};
}

void SparePatches::give_back(std::unique_ptr<terrain::Stacks> stacks) {
  const std::lock_guard lock{mutex_};
  if (spare_.size() < most_) spare_.push_back(std::move(stacks));
}

}  // namespace talus::server
