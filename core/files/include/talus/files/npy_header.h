// Headers of NumPy array files, versions 1 to 3:
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::files {

struct NpyHeader {
  std::string type;  // as NumPy writes it: "<f4", "|u1"
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  std::size_t data_at = 0;  // where the items begin
};

[[nodiscard]] bool is_npy(std::span<const std::byte> file);

/// Reads a header of any length, spacing and quotes. The error is one line: "is an .npy of records; ...".
/// REQUIRES: is_npy(file).
[[nodiscard]] tl::expected<NpyHeader, std::string> read_npy_header(std::span<const std::byte> file);

}  // namespace talus::files
