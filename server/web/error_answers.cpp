#include "web/error_answers.h"

#include <span>

#include <fmt/format.h>

#include <talus/voxel/codec.h>

#include "player/session/retry_after.h"
#include "web/columns_body.h"
#include "web/documents.h"

namespace talus::server::web {

using wire::ErrorCode;

namespace {

constexpr std::string_view kHowToSend = "by HTTP it is sent as Authorization: Bearer TOKEN";

/// `remedy` precedes the way to send a token.
http::Response ask_for_token(const AuthError& error, std::string_view remedy) {
  http::Response response =
      error_response(401, ErrorCode::unauthorized, fmt::format("{}; {}{}", error.text(), remedy, kHowToSend));
  // RFC 6750, 3.1: a request without a token gets no error code.
  response.fields.push_back(
      {"WWW-Authenticate", error.failure == AuthFailure::missing
                               ? "Bearer"
                               : fmt::format(R"(Bearer error="invalid_token", error_description="{}")",
                                             describe(error.failure))});
  return response;
}

}  // namespace

http::Response blocked_response() {
  return error_response(
      403, ErrorCode::unauthorized,
      fmt::format("{}; only the operator can let you in again", describe(AuthFailure::blocked)));
}

http::Response token_refused(const AuthError& error) {
  switch (error.failure) {
    case AuthFailure::blocked:
      return blocked_response();
    case AuthFailure::missing:
      return ask_for_token(error, "");
    case AuthFailure::not_accepted:
      if (!error.signed_by_key) {
        return ask_for_token(error, "it is not one of this server's, or not whole; ");
      }
      [[fallthrough]];
    default:
      return ask_for_token(error, "get a new one; ");
  }
}

http::Response right_missing() {
  return error_response(403, ErrorCode::forbidden,
                        "this token does not give the right read; get one that does");
}

std::vector<std::byte> refusal_response(ErrorCode code, const std::string& text,
                                        std::chrono::milliseconds retry_after) {
  // Before a request, `unauthorized` can only mean a blocked address, never a token.
  const http::Response response =
      code == ErrorCode::unauthorized ? blocked_response() : error_response(503, code, text, retry_after);
  std::string whole;
  http::append_head(whole, response, false,
                    std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  whole += response.body;
  const auto bytes = std::as_bytes(std::span{whole});
  return {bytes.begin(), bytes.end()};
}

http::Response fetch_failed(FetchError error, const MemoryBudget& memory) {
  switch (error) {
    case FetchError::busy:
      return memory.takes_jobs() ? error_response(503, ErrorCode::overloaded,
                                                  "too many chunks wait to be generated", retry_after::kBusy)
                                 : no_memory();
    case FetchError::late:
      return error_response(503, ErrorCode::overloaded, "the answer takes longer than 20 s now",
                            retry_after::kBusy);
    default:
      return error_response(503, ErrorCode::internal, "this could not be generated", retry_after::kFailed);
  }
}

http::Response no_memory() {
  return error_response(503, ErrorCode::overloaded, kNoMemory, retry_after::kBusy);
}

http::Response body_too_large() {
  static_assert(kMaxBodyBytes == std::size_t{4} << 20);
  return error_response(400, ErrorCode::too_large, "this is over 4 MiB; ask for its chunks one by one");
}

Answer check_world(const WebContext& context, std::string_view fingerprint) {
  if (fingerprint == context.fingerprint) return std::nullopt;
  return error_response(
      404, ErrorCode::out_of_range,
      fmt::format("this server's world is {}; /v1/world describes it", context.fingerprint));
}

Answer check_world(const WebContext& context, std::string_view fingerprint, std::string_view codec) {
  if (auto wrong = check_world(context, fingerprint)) return wrong;
  static const std::string kCodec = std::to_string(kCodecVersion);
  if (codec == kCodec) return std::nullopt;
  // A path of a column of edited land has as many parts as one of a generated chunk.
  if (codec.size() == context.store_id.size()) {
    return error_response(404, ErrorCode::out_of_range,
                          fmt::format("'{}' is not a chunk codec; paths with a store id end in "
                                      "@{{revision}}, such as @0, and the answer redirects to the newest",
                                      codec));
  }
  return error_response(404, ErrorCode::version,
                        fmt::format("this server sends chunk codec {}", kCodecVersion));
}

Answer check_store(const WebContext& context, std::string_view store) {
  if (context.edits == nullptr) {
    return error_response(404, ErrorCode::out_of_range,
                          "this server stores no edits; paths without a store id have its chunks");
  }
  if (store == context.store_id) return std::nullopt;
  return error_response(404, ErrorCode::out_of_range,
                        fmt::format("this server has store {}; /v1/world names it", context.store_id));
}

}  // namespace talus::server::web
