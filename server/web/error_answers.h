// What is said where there is no answer. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <talus/protocol/message.h>

#include "config/access/auth_failure.h"
#include "limits/memory/memory_budget.h"
#include "net/http/response.h"
#include "web/fetch.h"
#include "web/web_context.h"

namespace talus::server::web {

/// None: nothing is wrong so far, or the answer has to be waited for.
using Answer = std::optional<http::Response>;

/// What a client of the HTTP port is told that is refused: a whole response.
[[nodiscard]] std::vector<std::byte> refusal_response(wire::ErrorCode code, const std::string& text,
                                                      std::chrono::milliseconds retry_after);

/// What an address is told that the operator has blocked.
[[nodiscard]] http::Response blocked_response();
/// Where the token is missing or not accepted, or its subject blocked: how a right one is sent.
[[nodiscard]] http::Response token_refused(AuthFailure failure);
/// Where the token lacks the right to read.
[[nodiscard]] http::Response right_missing();

[[nodiscard]] http::Response fetch_failed(FetchError error, const MemoryBudget& memory);
[[nodiscard]] http::Response no_memory();
/// A body of over kMaxBodyBytes.
[[nodiscard]] http::Response body_too_large();

/// Where a path is of another world, or of another codec.
[[nodiscard]] Answer check_world(const WebContext& context, std::string_view fingerprint);
[[nodiscard]] Answer check_world(const WebContext& context, std::string_view fingerprint,
                                 std::string_view codec);
/// Where a path is of another store of edits.
[[nodiscard]] Answer check_store(const WebContext& context, std::string_view store);

}  // namespace talus::server::web
