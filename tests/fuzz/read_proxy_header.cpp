// The input is what a proxy sends before a connection's own bytes: a prefix, and a body that it announces.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "net/proxy_header.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus::server;
  const auto bytes = std::as_bytes(std::span{data, size});
  if (bytes.size() < kProxyPrefixBytes) return 0;
  const auto prefix = read_proxy_prefix(bytes.first<kProxyPrefixBytes>());
  if (!prefix) return 0;
  if (prefix->body_bytes > kMaxProxyBodyBytes) std::abort();
  // Of its own, so that a byte read past its end is seen.
  std::vector<std::byte> body(prefix->body_bytes);
  const auto rest = bytes.subspan(kProxyPrefixBytes);
  std::copy_n(rest.begin(), std::min(rest.size(), body.size()), body.begin());
  const auto client = proxied_client(*prefix, body);
  const bool peer = prefix->origin == ProxyPrefix::Origin::peer;
  if (client.has_value() == peer) std::abort();
  if (client && client->address().is_v4() != (prefix->origin == ProxyPrefix::Origin::tcp4)) std::abort();
  return 0;
}
