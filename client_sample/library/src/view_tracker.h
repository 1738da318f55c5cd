// Which chunks of the current View have been delivered.
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include <talus/client/view.h>
#include <talus/voxel/coords.h>

namespace talus::client {

class ViewTracker {
 public:
  /// Puts `view` in place of the one before; returns the delivered chunks that it no longer covers.
  [[nodiscard]] std::vector<ChunkKey> replace(const View& view);

  [[nodiscard]] const std::optional<View>& view() const { return view_; }
  [[nodiscard]] const ViewShape& shape() const { return shape_; }

  void delivered(const ChunkKey& key) { delivered_.insert(key); }
  [[nodiscard]] bool was_delivered(const ChunkKey& key) const { return delivered_.contains(key); }

 private:
  std::optional<View> view_;
  ViewShape shape_;
  std::unordered_set<ChunkKey> delivered_;
};

/// A and B ask for the same chunks in the same order.
[[nodiscard]] bool same_view(const View& a, const View& b);

}  // namespace talus::client
