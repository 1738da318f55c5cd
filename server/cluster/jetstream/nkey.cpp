#include "cluster/jetstream/nkey.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include <openssl/crypto.h>
#include <openssl/evp.h>

namespace talus::server::jetstream {
namespace {

constexpr std::string_view kBase32 = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
constexpr std::size_t kKeyBytes = 32;
constexpr std::size_t kSumBytes = 2;
constexpr std::uint8_t kSeed = 18U << 3U;
constexpr std::uint8_t kUser = 20U << 3U;

/// Two bytes of prefix, the key, the checksum.
using SeedBytes = std::array<std::uint8_t, 2 + kKeyBytes + kSumBytes>;
constexpr std::size_t kSeedDigits = (SeedBytes{}.size() * 8 + 4) / 5;

std::uint16_t crc16(std::span<const std::uint8_t> bytes) {
  constexpr std::uint16_t kPolynomial = 0x1021;
  std::uint16_t crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc = static_cast<std::uint16_t>(crc ^ (byte << 8U));
    for (int bit = 0; bit < 8; ++bit) {
      const bool high = (crc & 0x8000U) != 0;
      crc = static_cast<std::uint16_t>(crc << 1U);
      if (high) crc ^= kPolynomial;
    }
  }
  return crc;
}

bool decode_base32(std::string_view text, std::span<std::uint8_t> into) {
  std::uint32_t bits = 0;
  int count = 0;
  std::size_t filled = 0;
  for (const char c : text) {
    const std::size_t digit = kBase32.find(c);
    if (digit == std::string_view::npos) return false;
    bits = (bits << 5U) | static_cast<std::uint32_t>(digit);
    count += 5;
    if (count < 8) continue;
    count -= 8;
    if (filled == into.size()) return false;
    into[filled++] = static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count));
    bits &= (1U << static_cast<unsigned>(count)) - 1U;
  }
  return filled == into.size();
}

std::string encode_base32(std::span<const std::uint8_t> bytes) {
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;
  for (const std::uint8_t byte : bytes) {
    bits = (bits << 8U) | byte;
    for (count += 8; count >= 5;) {
      count -= 5;
      text += kBase32[(bits >> static_cast<unsigned>(count)) & 31U];
    }
    bits &= 31U;
  }
  if (count > 0) text += kBase32[(bits << static_cast<unsigned>(5 - count)) & 31U];
  return text;
}

/// Derives the Ed25519 public key.
std::optional<std::array<std::uint8_t, kKeyBytes>> public_key(std::span<const std::uint8_t> secret) {
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key{
      EVP_PKEY_new_raw_private_key(EVP_PKEY_ED25519, nullptr, secret.data(), secret.size()), EVP_PKEY_free};
  std::array<std::uint8_t, kKeyBytes> made{};
  std::size_t size = made.size();
  if (key == nullptr || EVP_PKEY_get_raw_public_key(key.get(), made.data(), &size) != 1) return std::nullopt;
  return made;
}

}  // namespace

tl::expected<std::string, std::string> public_nkey(std::string_view seed) {
  const auto wrong = [](std::string_view what) { return tl::unexpected{std::string{what}}; };
  if (seed.size() != kSeedDigits)
    return wrong("is not an NKey seed, which has 58 characters and begins with SU");
  SeedBytes bytes{};
  const struct Cleansed {
    SeedBytes& bytes;
    ~Cleansed() { OPENSSL_cleanse(bytes.data(), bytes.size()); }
  } cleansed{bytes};
  if (!decode_base32(seed, bytes))
    return wrong("is not an NKey seed, which has only capitals and the digits 2 to 7");
  const std::span<const std::uint8_t> all{bytes};
  const std::span<const std::uint8_t> summed = all.first(all.size() - kSumBytes);
  const std::uint16_t sum = crc16(summed);
  if (all[summed.size()] != (sum & 0xFFU) || all[summed.size() + 1] != (sum >> 8U)) {
    return wrong("is not an NKey seed: its checksum is wrong, so part of it is missing or mistyped");
  }
  // Five bits of kind, eight bits of owner.
  const auto kind = static_cast<std::uint8_t>(all[0] & 0xF8U);
  const auto owner = static_cast<std::uint8_t>(((all[0] & 7U) << 5U) | (all[1] >> 3U));
  if (kind != kSeed || owner != kUser)
    return wrong("is an NKey, but not a user's seed, which begins with SU");
  const auto key = public_key(summed.subspan(2));
  if (!key) return wrong("is not an Ed25519 key that OpenSSL accepts");
  std::array<std::uint8_t, 1 + kKeyBytes + kSumBytes> shown{kUser};
  std::copy(key->begin(), key->end(), shown.begin() + 1);
  const std::uint16_t shown_sum = crc16(std::span<const std::uint8_t>{shown}.first(1 + kKeyBytes));
  shown[1 + kKeyBytes] = static_cast<std::uint8_t>(shown_sum & 0xFFU);
  shown[2 + kKeyBytes] = static_cast<std::uint8_t>(shown_sum >> 8U);
  return encode_base32(shown);
}

}  // namespace talus::server::jetstream
