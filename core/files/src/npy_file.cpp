#include <talus/files/npy_file.h>

#include <cassert>
#include <utility>
#include <vector>

#include <talus/vectors/little_endian.h>

namespace talus::files {

namespace {

const char* descriptor(NpyType type) {
  switch (type) {
    case NpyType::int32:
      return "<i4";
    case NpyType::uint8:
      return "|u1";
    case NpyType::uint16:
      return "<u2";
    case NpyType::float32:
      return "<f4";
    case NpyType::float64:
      return "<f8";
  }
  return "";
}

}  // namespace

std::size_t item_bytes(NpyType type) {
  switch (type) {
    case NpyType::int32:
      return 4;
    case NpyType::uint8:
      return 1;
    case NpyType::uint16:
      return 2;
    case NpyType::float32:
      return 4;
    case NpyType::float64:
      return 8;
  }
  return 0;
}

std::string npy_header(NpyType type, std::span<const std::size_t> shape) {
  std::string axes;
  for (const std::size_t length : shape) axes += std::to_string(length) + ", ";
  if (shape.size() > 1) axes.resize(axes.size() - 2);
  if (shape.size() == 1) axes.resize(axes.size() - 1);  // (3,) is a tuple, (3) is a number
  constexpr std::size_t kPreambleBytes = 10;            // magic, version, length of the dictionary
  constexpr std::size_t kDictionaryBytes = kNpyHeaderBytes - kPreambleBytes;
  std::string header{"\x93NUMPY\x01\x00", 8};
  header += static_cast<char>(kDictionaryBytes & 0xFF);
  header += static_cast<char>(kDictionaryBytes >> 8);
  header +=
      std::string{"{'descr': '"} + descriptor(type) + "', 'fortran_order': False, 'shape': (" + axes + "), }";
  assert(header.size() < kNpyHeaderBytes);
  header.resize(kNpyHeaderBytes - 1, ' ');
  return header + '\n';
}

tl::expected<NpyFile, FileError> NpyFile::create(const std::filesystem::path& target, NpyType type,
                                                 FileLayer& layer) {
  auto file = AtomicFile::create(target, layer);
  if (!file) return tl::unexpected{file.error()};
  return NpyFile{std::move(*file), type};
}

tl::expected<void, FileError> NpyFile::write_bytes(std::size_t first_item,
                                                   std::span<const std::byte> bytes) const {
  return file_.write_at(kNpyHeaderBytes + first_item * item_bytes(type_), bytes);
}

tl::expected<void, FileError> NpyFile::write(std::size_t first_item,
                                             std::span<const std::int32_t> items) const {
  assert(type_ == NpyType::int32);
  std::vector<std::byte> scratch;
  return write_bytes(first_item, little_endian_bytes(items, scratch));
}

tl::expected<void, FileError> NpyFile::write(std::size_t first_item,
                                             std::span<const std::uint8_t> items) const {
  assert(type_ == NpyType::uint8);
  std::vector<std::byte> scratch;
  return write_bytes(first_item, little_endian_bytes(items, scratch));
}

tl::expected<void, FileError> NpyFile::write(std::size_t first_item,
                                             std::span<const std::uint16_t> items) const {
  assert(type_ == NpyType::uint16);
  std::vector<std::byte> scratch;
  return write_bytes(first_item, little_endian_bytes(items, scratch));
}

tl::expected<void, FileError> NpyFile::write(std::size_t first_item, std::span<const float> items) const {
  assert(type_ == NpyType::float32);
  std::vector<std::byte> scratch;
  return write_bytes(first_item, little_endian_bytes(items, scratch));
}

tl::expected<void, FileError> NpyFile::write(std::size_t first_item, std::span<const double> items) const {
  assert(type_ == NpyType::float64);
  std::vector<std::byte> scratch;
  return write_bytes(first_item, little_endian_bytes(items, scratch));
}

tl::expected<void, FileError> NpyFile::finish(std::span<const std::size_t> shape) const {
  std::size_t items = 1;
  for (const std::size_t length : shape) items *= length;
  const std::string header = npy_header(type_, shape);
  if (auto written = file_.write_at(0, std::as_bytes(std::span{header})); !written) return written;
  return file_.resize(kNpyHeaderBytes + items * item_bytes(type_));
}

}  // namespace talus::files
