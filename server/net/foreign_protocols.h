// Recognises clients of other protocols by the length that their first bytes would announce as a frame.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>
#include <vector>

#include <talus/protocol/frame.h>

namespace talus::server {

/// True for the beginning of an HTTP request.
[[nodiscard]] bool is_http_request(const protocol::FrameError& error);
/// True for the beginning of a TLS handshake.
[[nodiscard]] bool is_tls_hello(const protocol::FrameError& error);

/// Returns an HTTP response with one line of text. `now`: for its Date.
[[nodiscard]] std::vector<std::byte> http_refusal(std::string_view line, std::chrono::sys_seconds now);

}  // namespace talus::server
