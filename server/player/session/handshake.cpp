#include "player/session/handshake.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>

namespace talus::server {
namespace {

constexpr std::size_t kMaxCodecsNamed = 16;  // listed in an error's text

std::string versions(unsigned oldest, unsigned newest) {
  return oldest == newest ? fmt::format("version {}", oldest)
                          : fmt::format("versions {} to {}", oldest, newest);
}

Rejection no_common_protocol(const wire::Hello& hello) {
  return {wire::ErrorCode::version,
          fmt::format("this server speaks protocol {}, this client {}",
                      versions(protocol::kOldestProtocol, protocol::kProtocolVersion),
                      versions(hello.protocol_min(), hello.protocol_max()))};
}

Rejection no_common_codec(const std::vector<unsigned>& codecs) {
  std::string named;
  for (std::size_t i = 0; i < std::min(codecs.size(), kMaxCodecsNamed); ++i) {
    named += (i == 0 ? "" : ", ") + std::to_string(codecs[i]);
  }
  return {wire::ErrorCode::version, fmt::format("this server sends chunk codec {}, this client decodes {}",
                                                unsigned{kCodecVersion}, named.empty() ? "none" : named)};
}

bool too_long(const flatbuffers::String* text) {
  return text != nullptr && text->size() > protocol::kMaxStringBytes;
}

}  // namespace

tl::expected<Greeting, Rejection> greet(const wire::Hello& hello, const SessionLimits& limits,
                                        const AccessControl& access, std::chrono::sys_seconds now) {
  const std::uint16_t chosen = protocol::choose_protocol(hello.protocol_min(), hello.protocol_max());
  if (chosen == 0) return tl::make_unexpected(no_common_protocol(hello));

  std::vector<unsigned> codecs;
  if (hello.codecs() != nullptr) codecs.assign(hello.codecs()->begin(), hello.codecs()->end());
  if (std::find(codecs.begin(), codecs.end(), unsigned{kCodecVersion}) == codecs.end()) {
    return tl::make_unexpected(no_common_codec(codecs));
  }
  if (too_long(hello.token()) || too_long(hello.client())) {
    return tl::make_unexpected(Rejection{
        wire::ErrorCode::malformed,
        fmt::format("Hello.token and Hello.client may have {} bytes each", protocol::kMaxStringBytes)});
  }
  const std::string_view token = hello.token() == nullptr ? std::string_view{} : hello.token()->string_view();
  auto grant = access.admit(token, now);
  if (!grant) {
    AuthError& error = grant.error();
    std::string text = error.text();
    if (text.ends_with(error.reason)) error.reason.clear();
    return tl::make_unexpected(Rejection{wire::ErrorCode::unauthorized, std::move(text),
                                         std::move(error.reason), error.failure, error.repeated});
  }
  const std::uint64_t window = hello.window_bytes() == 0 ? limits.window_bytes : hello.window_bytes();
  return Greeting{chosen, kCodecVersion, std::min<std::uint64_t>(window, limits.window_bytes),
                  hello.client() == nullptr ? std::string{} : hello.client()->str(), *std::move(grant)};
}

}  // namespace talus::server
