#include "config/access/base64url.h"

#include <openssl/evp.h>

#include <algorithm>

namespace talus::server {
namespace {

unsigned char* bytes_of(std::string& text) {
  return reinterpret_cast<unsigned char*>(text.data());
}
const unsigned char* bytes_of(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

bool is_letter_or_digit(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

/// Decodes the alphabet with + and /; the length must be a multiple of 4.
std::optional<std::string> decode_padded(std::string_view text, std::size_t padding) {
  std::string bytes(text.size() / 4 * 3, '\0');
  if (::EVP_DecodeBlock(bytes_of(bytes), bytes_of(text), static_cast<int>(text.size())) < 0) {
    return std::nullopt;
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

}  // namespace

std::string base64url_encode(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // OpenSSL appends a zero byte
  const int size = ::EVP_EncodeBlock(bytes_of(text), bytes_of(bytes), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  while (text.ends_with('=')) text.pop_back();
  for (char& c : text) c = c == '+' ? '-' : c == '/' ? '_' : c;
  return text;
}

std::optional<std::string> base64url_decode(std::string_view text) {
  const auto in_alphabet = [](char c) { return is_letter_or_digit(c) || c == '-' || c == '_'; };
  if (text.size() % 4 == 1 || !std::ranges::all_of(text, in_alphabet)) return std::nullopt;
  std::string padded{text};
  for (char& c : padded) c = c == '-' ? '+' : c == '_' ? '/' : c;
  const std::size_t padding = (4 - text.size() % 4) % 4;
  padded.append(padding, '=');
  return decode_padded(padded, padding);
}

std::optional<std::string> base64_decode(std::string_view text) {
  const auto in_alphabet = [](char c) { return is_letter_or_digit(c) || c == '+' || c == '/'; };
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  if (text.size() % 4 != 0 || !std::ranges::all_of(text.substr(0, text.size() - padding), in_alphabet)) {
    return std::nullopt;
  }
  return decode_padded(text, padding);
}

}  // namespace talus::server
