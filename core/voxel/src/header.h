// Numbers in front of the coded part: FORMAT.md, "Numbers and lists".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/codec.h>
#include <talus/voxel/material.h>

namespace talus::codec {

inline constexpr std::size_t kMaxBytesOfNumber = 3;

/// Seven bits per byte, lowest first; the high bit is set if another byte follows. `out` has room for
/// kMaxBytesOfNumber. Returns the end of the bytes written.
std::byte* put_number(std::uint16_t number, std::byte* out);
void put_number(std::uint16_t number, std::vector<std::byte>& out);

/// Removes a number from the front of `bytes`.
[[nodiscard]] tl::expected<std::uint16_t, DecodeError> take_number(std::span<const std::byte>& bytes);

void put_materials(std::span<const MaterialId> materials, std::vector<std::byte>& out);

/// Removes a count from 1 to `max_count`, then that many material ids, from the front of `bytes`.
[[nodiscard]] tl::expected<std::vector<MaterialId>, DecodeError> take_materials(
    std::span<const std::byte>& bytes, std::size_t max_count);

/// Removes the materials of layers; adjacent ones must differ.
[[nodiscard]] tl::expected<std::vector<MaterialId>, DecodeError> take_layer_materials(
    std::span<const std::byte>& bytes);

}  // namespace talus::codec
