#include <talus/edits/voxel_set.h>

namespace talus::edits {

void VoxelSet::count() {
  size_ = 0;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    before_[row] = static_cast<std::uint16_t>(size_);
    size_ += static_cast<std::size_t>(std::popcount(rows_[row]));
  }
}

}  // namespace talus::edits
