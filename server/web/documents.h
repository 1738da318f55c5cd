// The JSON documents that players get over HTTP. Pure functions. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <talus/protocol/message.h>

#include "chunks/heights_query.h"
#include "limits/rates/rates.h"
#include "net/http/response.h"
#include "player/session/session_limits.h"
#include "player/session/world_info.h"
#include "web/routes.h"

namespace talus::server::web {

inline constexpr const char* kJson = "application/json";

/// {"error": {"code", "text", "retry_after_ms"}}, with Retry-After in whole seconds if a retry may help.
[[nodiscard]] http::Response error_response(int status, wire::ErrorCode code, std::string_view text,
                                            std::chrono::milliseconds retry_after = {});

/// Welcome as JSON, without fields that edits change; 128-bit numbers as 32 hexadecimal digits.
[[nodiscard]] std::string world_document(const WorldInfo& world, const SessionLimits& limits,
                                         const RateLimits& rates);

/// Edit status.
struct EditsNow {
  bool taken = false;
  std::uint64_t revision = 0;
  bool operator==(const EditsNow&) const = default;
};
/// Adds the edit status to the world's document. The revision is a string of decimal digits, as most JSON
/// readers lose precision above 2^53.
[[nodiscard]] std::string with_edits(std::string_view world_document, EditsNow edits);

/// A line of the access log, as a JSON object.
struct AccessLine {
  std::uint64_t connection = 0;
  std::string_view client{};
  std::string_view method{};
  std::string_view target{};
  int status = 0;
  double ms = 0;
  std::size_t bytes = 0;
  std::uint64_t one_in = 0;  // sampling rate of the log
};
[[nodiscard]] std::string access_fields(const AccessLine& line);

/// Describes a heights document.
struct HeightsForm {
  std::size_t width = 0;              // width of the grid; 0: a list
  std::vector<std::string> looks{};   // names of the world's looks, by number; empty: omit looks
  std::vector<std::string> fields{};  // names of the values of each column
};
/// Heights in subvoxels, with the looks and values of `form`.
[[nodiscard]] std::string heights_document(const HeightsForm& form, const HeightsResult& found);
/// int32[row][column], or int32[column] for a list.
[[nodiscard]] std::string heights_npy(std::size_t width, const HeightsResult& found);

}  // namespace talus::server::web
