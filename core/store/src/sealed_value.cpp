#include <talus/store/sealed_value.h>

#include <xxhash.h>

namespace talus::store {

std::uint64_t hash_of(std::string_view text) {
  return XXH3_64bits(text.data(), text.size());
}

ByteWriter begin_value(Bytes& out) {
  out.clear();
  ByteWriter writer{out};
  writer.byte(kStoreFormat);
  return writer;
}

std::uint64_t seal(std::uint64_t seed, Bytes& out) {
  const std::uint64_t checksum = XXH3_64bits_withSeed(out.data(), out.size(), seed);
  ByteWriter{out}.fixed64(checksum);
  return checksum;
}

std::optional<std::span<const std::byte>> sealed_bytes(std::uint64_t seed, std::span<const std::byte> value) {
  if (value.size() <= kChecksumBytes) return std::nullopt;
  const auto body = value.first(value.size() - kChecksumBytes);
  const std::uint64_t held = ByteReader{value.last(kChecksumBytes)}.fixed64();
  if (held != XXH3_64bits_withSeed(body.data(), body.size(), seed)) return std::nullopt;
  return body;
}

std::optional<std::span<const std::byte>> sealed(std::uint64_t seed, std::span<const std::byte> value) {
  const auto body = sealed_bytes(seed, value);
  if (!body || std::to_integer<std::uint8_t>(body->front()) != kStoreFormat) return std::nullopt;
  return body->subspan(1);
}

}  // namespace talus::store
