// The input is a token as a client shows it, or (where its first byte is 1) the claims of one that the key
// has signed. None may do harm, and none may be taken whose signature is not the key's, spelled in the one
// way.
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "config/access/signed_token.h"

namespace {

using namespace talus::server;

constexpr std::string_view kKey = "0123456789abcdef0123456789abcdef";
constexpr std::string_view kHeader = R"({"typ":"JWT","alg":"HS256"})";

std::string base64url(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  while (text.ends_with('=')) text.pop_back();
  for (char& c : text) c = c == '+' ? '-' : c == '/' ? '_' : c;
  return text;
}

std::string signature(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int bytes = 0;
  HMAC(EVP_sha256(), kKey.data(), static_cast<int>(kKey.size()),
       reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(), &bytes);
  return base64url({reinterpret_cast<const char*>(digest.data()), bytes});
}

std::string signed_claims(std::string_view claims) {
  const std::string text = base64url(kHeader) + "." + base64url(claims);
  return text + "." + signature(text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input{reinterpret_cast<const char*>(data), size};
  const std::string token = input.starts_with('\1') ? signed_claims(input.substr(1)) : std::string{input};
  const std::chrono::sys_seconds now{std::chrono::seconds{1'800'000'000}};
  const auto claims = read_signed_token(Secret{kKey}, token, now);
  if (!claims) return 0;
  const std::size_t dot = token.rfind('.');
  if (token.substr(dot + 1) != signature(token.substr(0, dot))) std::abort();
  if (!claims->rights.has(Right::read) || claims->expires + kClockSkew <= now) std::abort();
  return 0;
}
