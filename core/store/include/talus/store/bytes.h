// Encodes and decodes the store's values, front to back. The input of a reader is untrusted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace talus::store {

class ByteWriter {
 public:
  /// Appends to `out`, which must outlive this.
  explicit ByteWriter(std::vector<std::byte>& out) : out_{out} {}

  void byte(std::uint8_t value) { out_.push_back(static_cast<std::byte>(value)); }
  /// Little endian.
  void fixed32(std::uint32_t value) { fixed(value, 4); }
  void fixed64(std::uint64_t value) { fixed(value, 8); }
  /// LEB128.
  void varint(std::uint64_t value) {
    std::array<std::byte, 10> number;
    std::size_t count = 0;
    for (; value >= 128; value >>= 7) number[count++] = static_cast<std::byte>(128 | (value & 127));
    number[count++] = static_cast<std::byte>(value);
    bytes(std::span{number}.first(count));
  }
  /// Encodes small numbers of either sign in few bytes.
  void zigzag(std::int64_t value) {
    varint((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void bytes(std::span<const std::byte> all) { out_.insert(out_.end(), all.begin(), all.end()); }
  /// Prefixes the bytes by their count.
  void counted(std::span<const std::byte> all) {
    varint(all.size());
    bytes(all);
  }
  void counted(std::string_view text) { counted(std::as_bytes(std::span{text})); }
  /// Prefixes by its count what `write` appends to the vector passed to it.
  template <typename Write>
  void counted_by(const Write& write) {
    const std::size_t at = out_.size();
    out_.push_back(std::byte{0});  // the size of a count up to 127
    write(out_);
    const std::size_t count = out_.size() - at - 1;
    out_[at] = static_cast<std::byte>(count & 127);
    if (count < 128) return;
    out_[at] |= std::byte{128};
    std::vector<std::byte> rest;
    ByteWriter{rest}.varint(count >> 7);
    out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(at) + 1, rest.begin(), rest.end());
  }

 private:
  void fixed(std::uint64_t value, std::size_t count) {
    std::array<std::byte, 8> number;
    for (std::size_t i = 0; i < count; ++i) number[i] = static_cast<std::byte>(value >> (8 * i));
    bytes(std::span{number}.first(count));
  }

  std::vector<std::byte>& out_;
};

/// After the first error everything read is 0 or empty: check ok() at the end, and before allocating by a
/// count.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_{bytes} {}

  std::uint8_t byte() {
    const auto taken = take(1);
    return taken.empty() ? std::uint8_t{0} : std::to_integer<std::uint8_t>(taken.front());
  }
  std::uint32_t fixed32() { return static_cast<std::uint32_t>(fixed(4)); }
  std::uint64_t fixed64() { return fixed(8); }
  /// Accepts only the shortest encoding, and values of at most `max_value`.
  std::uint64_t varint(std::uint64_t max_value = UINT64_MAX) {
    std::uint64_t value = 0;
    for (int shift = 0; ok_; shift += 7) {
      const std::uint64_t part = byte();
      if (!ok_) break;
      value |= (part & 127) << shift;
      const bool padded = part == 0 && shift > 0;
      // Nine bytes hold 63 bits; the tenth holds one.
      if (padded || (shift == 63 && part > 1)) ok_ = false;
      if (part < 128) break;
    }
    if (value > max_value) ok_ = false;
    return ok_ ? value : 0;
  }
  /// `max_value` bounds the encoded number.
  std::int64_t zigzag(std::uint64_t max_value = UINT64_MAX) {
    const std::uint64_t value = varint(max_value);
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  /// Count of items of at least one byte each, so at most the bytes left.
  std::size_t count() { return static_cast<std::size_t>(varint(bytes_.size())); }
  std::span<const std::byte> take(std::size_t size) {
    if (!ok_ || size > bytes_.size()) {
      ok_ = false;
      return {};
    }
    const auto taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }
  std::span<const std::byte> counted() { return take(count()); }
  std::string text(std::size_t max_bytes) {
    const auto taken = counted();
    if (taken.size() > max_bytes) ok_ = false;
    if (!ok_) return {};
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }

  void fail() { ok_ = false; }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }
  [[nodiscard]] bool ok() const { return ok_; }
  /// True if all bytes were read without an error.
  [[nodiscard]] bool ended() const { return ok_ && bytes_.empty(); }

 private:
  std::uint64_t fixed(std::size_t size) {
    std::uint64_t value = 0;
    const auto taken = take(size);
    for (std::size_t i = 0; i < taken.size(); ++i) {
      value |= std::to_integer<std::uint64_t>(taken[i]) << (8 * i);
    }
    return value;
  }

  std::span<const std::byte> bytes_;
  bool ok_ = true;
};

}  // namespace talus::store
