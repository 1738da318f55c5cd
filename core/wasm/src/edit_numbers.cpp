#include "edit_numbers.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::wasm {
namespace {

class Reader {
 public:
  explicit Reader(std::span<const double> numbers) : numbers_{numbers} {}

  std::size_t take_count() { return static_cast<std::size_t>(take(0, static_cast<double>(numbers_.size()))); }
  VoxelPos take_voxel() {
    constexpr double kEnd = 1e15;
    const std::int64_t x = take(-kEnd, kEnd);
    const std::int64_t y = take(-kEnd, kEnd);
    return {x, y, take(-kEnd, kEnd)};
  }
  MaterialId take_material() { return MaterialId{static_cast<std::uint16_t>(take(0, 65535))}; }
  std::optional<MaterialId> take_material_or_none() {
    const std::int64_t id = take(-1, 65535);
    if (id < 0) return std::nullopt;
    return MaterialId{static_cast<std::uint16_t>(id)};
  }
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool done() const { return ok_ && at_ == numbers_.size(); }

 private:
  std::int64_t take(double least, double most) {
    const double number = at_ < numbers_.size() ? numbers_[at_++] : std::nan("");
    ok_ = ok_ && number >= least && number <= most && number == std::floor(number);
    return ok_ ? static_cast<std::int64_t>(number) : 0;
  }

  std::span<const double> numbers_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

edits::VoxelWrite take_write(Reader& reader) {
  const VoxelPos voxel = reader.take_voxel();
  return {voxel, reader.take_material()};
}

edits::Fill take_fill(Reader& reader) {
  edits::Fill fill;
  fill.first = reader.take_voxel();
  fill.last = reader.take_voxel();
  fill.material = reader.take_material_or_none();
  fill.only = reader.take_material_or_none();
  return fill;
}

}  // namespace

std::optional<edits::Edit> edit_of(std::span<const double> numbers) {
  Reader reader{numbers};
  edits::Edit edit;
  const std::size_t guards = reader.take_count();
  const std::size_t writes = reader.take_count();
  const std::size_t fills = reader.take_count();
  for (std::size_t i = 0; i < guards && reader.ok(); ++i) edit.guards.push_back(take_write(reader));
  for (std::size_t i = 0; i < writes && reader.ok(); ++i) edit.writes.push_back(take_write(reader));
  for (std::size_t i = 0; i < fills && reader.ok(); ++i) edit.fills.push_back(take_fill(reader));
  return reader.done() ? std::optional{edit} : std::nullopt;
}

}  // namespace talus::wasm
