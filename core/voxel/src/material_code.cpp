#include "material_code.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "header.h"

namespace talus::codec {

void to_sizes(std::span<const std::uint32_t> counts, std::span<std::uint16_t> sizes) {
  const std::uint64_t total = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  int left = kProbabilityTotal;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    sizes[i] =
        static_cast<std::uint16_t>(counts[i] == 0 ? 0 : std::max<std::uint64_t>(1, counts[i] * 256 / total));
    left -= sizes[i];
  }
  // Bytes left by rounding go to the most frequent material; a deficit is taken from the largest intervals.
  while (left != 0) {
    auto largest = std::max_element(sizes.begin(), sizes.end());
    if (left > 0) {
      *largest = static_cast<std::uint16_t>(*largest + left);
      left = 0;
    } else {
      --*largest;
      ++left;
    }
  }
}

void MaterialCode::finish(std::vector<std::byte>& out) {
  std::array<std::uint16_t, kMaxMaterials> order;
  std::iota(order.begin(), order.begin() + size_, std::uint16_t{0});
  std::sort(order.begin() + 1, order.begin() + size_,
            [this](std::uint16_t a, std::uint16_t b) { return materials_[a] < materials_[b]; });
  std::array<MaterialId, kMaxMaterials> materials;
  std::array<std::uint32_t, kMaxMaterials> counts;
  std::array<std::uint16_t, kMaxMaterials> sizes;
  for (std::size_t i = 0; i < size_; ++i) {
    materials[i] = materials_[order[i]];
    counts[i] = std::max(1U, counts_[order[i]]);
  }
  to_sizes({counts.data(), size_}, {sizes.data(), size_});
  std::uint32_t start = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    intervals_[order[i]] = start | std::uint32_t{sizes[i]} << 16U;
    start += sizes[i];
  }
  put_materials({materials.data(), size_}, out);
  for (std::size_t i = 0; i < size_; ++i) out.push_back(static_cast<std::byte>(sizes[i] - 1));
}

tl::expected<MaterialId, DecodeError> take_material_code(std::span<const std::byte>& bytes,
                                                         SlotTable& slots) {
  const auto materials = take_materials(bytes, MaterialCode::kMaxMaterials);
  if (!materials) return tl::unexpected{materials.error()};
  const auto second = materials->begin() + 1;
  const bool repeats = std::find(second, materials->end(), materials->front()) != materials->end();
  if (repeats || std::adjacent_find(second, materials->end(), std::greater_equal{}) != materials->end()) {
    return tl::unexpected{DecodeError::bad_materials};
  }
  if (bytes.size() < materials->size()) return tl::unexpected{DecodeError::truncated};
  std::size_t start = 0;
  for (std::size_t i = 0; i < materials->size(); ++i) {
    const std::size_t size = std::to_integer<std::size_t>(bytes[i]) + 1;
    if (start + size > slots.slot.size()) return tl::unexpected{DecodeError::bad_number};
    slots.value[i] = to_integer((*materials)[i]);
    std::fill_n(slots.slot.begin() + static_cast<std::ptrdiff_t>(start), size,
                static_cast<std::uint32_t>(i | start << 8U | size << 16U));
    start += size;
  }
  if (start != slots.slot.size()) return tl::unexpected{DecodeError::bad_number};
  bytes = bytes.subspan(materials->size());
  return materials->front();
}

}  // namespace talus::codec
