// A list of planes that is refilled for region after region.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// Empties `tops` and `materials` and refills them with fields from `spare`, to which it first moves the
/// fields of earlier regions.
class Planes {
 public:
  Planes(std::vector<MaterialId>& materials, std::vector<Field>& tops, std::vector<Field>& spare)
      : materials_{materials}, tops_{tops}, spare_{spare} {
    for (Field& top : tops_) spare_.push_back(std::move(top));
    tops_.clear();
    materials_.clear();
  }
  /// Keeps at most as many spare fields as the list has: callers may move in fields from other lists.
  ~Planes() {
    if (spare_.size() > tops_.size()) spare_.resize(tops_.size());
  }
  Planes(const Planes&) = delete;
  Planes& operator=(const Planes&) = delete;

  [[nodiscard]] bool empty() const { return tops_.empty(); }
  [[nodiscard]] std::size_t count() const { return tops_.size(); }
  [[nodiscard]] std::vector<Field>& tops() { return tops_; }
  [[nodiscard]] Field& top() { return tops_.back(); }

  /// Adds a plane on top; its size and values are unspecified.
  Field& add(MaterialId material) {
    materials_.push_back(material);
    if (spare_.empty()) return tops_.emplace_back();
    tops_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    return tops_.back();
  }
  /// Keeps the lowest `count` planes, or all if there are fewer.
  void keep(std::size_t count) {
    while (tops_.size() > count) {
      spare_.push_back(std::move(tops_.back()));
      tops_.pop_back();
      materials_.pop_back();
    }
  }

 private:
  std::vector<MaterialId>& materials_;
  std::vector<Field>& tops_;
  std::vector<Field>& spare_;
};

}  // namespace talus::terrain
