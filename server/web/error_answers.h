// Error responses. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <talus/protocol/message.h>

#include "config/access/access_control.h"
#include "limits/memory/memory_budget.h"
#include "net/http/response.h"
#include "web/fetch.h"
#include "web/web_context.h"

namespace talus::server::web {

/// A response; nullopt if there is no error so far or the answer must be waited for.
using Answer = std::optional<http::Response>;

/// A whole response for a refused client of the HTTP port.
[[nodiscard]] std::vector<std::byte> refusal_response(wire::ErrorCode code, const std::string& text,
                                                      std::chrono::milliseconds retry_after);

/// For an address that the operator has blocked.
[[nodiscard]] http::Response blocked_response();
/// For a token that is missing or not accepted, or whose subject is blocked; explains how to send a valid
/// one.
[[nodiscard]] http::Response token_refused(const AuthError& error);
/// For a token without the right to read.
[[nodiscard]] http::Response right_missing();

[[nodiscard]] http::Response fetch_failed(FetchError error, const MemoryBudget& memory);
[[nodiscard]] http::Response no_memory();
/// For a body larger than kMaxBodyBytes.
[[nodiscard]] http::Response body_too_large();

/// Returns an error if the path belongs to another world or codec.
[[nodiscard]] Answer check_world(const WebContext& context, std::string_view fingerprint);
[[nodiscard]] Answer check_world(const WebContext& context, std::string_view fingerprint,
                                 std::string_view codec);
/// Returns an error if the path belongs to another store of edits.
[[nodiscard]] Answer check_store(const WebContext& context, std::string_view store);

}  // namespace talus::server::web
