// NumPy array files, version 1.0: C order, little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include <talus/files/atomic_file.h>

namespace talus::files {

enum class NpyType : std::uint8_t { int32, uint8, uint16, float32, float64 };

[[nodiscard]] std::size_t item_bytes(NpyType type);

/// Fixed length of every header, so that data can be written before the shape is known.
inline constexpr std::size_t kNpyHeaderBytes = 128;

/// Shapes of up to three axes of at most 2^31 items fit.
[[nodiscard]] std::string npy_header(NpyType type, std::span<const std::size_t> shape);

/// An array that is written in pieces, in any order, from any thread; unwritten items are zero.
class NpyFile {
 public:
  [[nodiscard]] static tl::expected<NpyFile, FileError> create(const std::filesystem::path& target,
                                                               NpyType type,
                                                               FileLayer& layer = system_files());

  [[nodiscard]] tl::expected<void, FileError> write(std::size_t first_item,
                                                    std::span<const std::int32_t> items) const;
  [[nodiscard]] tl::expected<void, FileError> write(std::size_t first_item,
                                                    std::span<const std::uint8_t> items) const;
  [[nodiscard]] tl::expected<void, FileError> write(std::size_t first_item,
                                                    std::span<const std::uint16_t> items) const;
  [[nodiscard]] tl::expected<void, FileError> write(std::size_t first_item,
                                                    std::span<const float> items) const;
  [[nodiscard]] tl::expected<void, FileError> write(std::size_t first_item,
                                                    std::span<const double> items) const;

  /// Writes the header and sets the file's length; items beyond the shape are cut off.
  [[nodiscard]] tl::expected<void, FileError> finish(std::span<const std::size_t> shape) const;
  /// See AtomicFile::commit().
  [[nodiscard]] tl::expected<void, FileError> commit() { return file_.commit(); }

  [[nodiscard]] NpyType type() const { return type_; }

 private:
  NpyFile(AtomicFile file, NpyType type) : file_{std::move(file)}, type_{type} {}
  [[nodiscard]] tl::expected<void, FileError> write_bytes(std::size_t first_item,
                                                          std::span<const std::byte> bytes) const;

  AtomicFile file_;
  NpyType type_;
};

}  // namespace talus::files
