#include "web/error_answers.h"

#include <span>

#include <fmt/format.h>

#include <talus/voxel/codec.h>

#include "session/retry_after.h"
#include "web/columns_body.h"
#include "web/documents.h"

namespace talus::server::web {

using wire::ErrorCode;

std::vector<std::byte> refusal_response(ErrorCode code, const std::string& text,
                                        std::chrono::milliseconds retry_after) {
  const int status = code == ErrorCode::unauthorized ? 403 : 503;
  const http::Response response = error_response(status, code, text, retry_after);
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
      return error_response(503, ErrorCode::overloaded, "this takes longer than 20 s now",
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
  // A column of edited land has as many parts as a chunk of generated land.
  if (codec.size() == context.store_id.size()) {
    return error_response(404, ErrorCode::out_of_range,
                          fmt::format("'{}' stands where the chunk codec does; paths with a store id end in "
                                      "@{{revision}}, such as @0, and the answer leads to the newest",
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
  return error_response(
      404, ErrorCode::out_of_range,
      fmt::format("this server's edits are those of store {}; /v1/world names it", context.store_id));
}

}  // namespace talus::server::web
