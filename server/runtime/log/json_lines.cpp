#include "runtime/log/json_lines.h"

#include <chrono>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/log/utc_time.h"

namespace talus::server {

void JsonLines::format(const spdlog::details::log_msg& line, spdlog::memory_buf_t& out) {
  using std::chrono::milliseconds;
  const auto since_1970 = std::chrono::duration_cast<milliseconds>(line.time.time_since_epoch());
  const auto seconds = std::chrono::floor<std::chrono::seconds>(since_1970);
  const auto level = spdlog::level::to_string_view(line.level);
  const nlohmann::json text = std::string_view{line.payload.data(), line.payload.size()};
  // Replaces bytes that are not UTF-8, because dump() would throw.
  fmt::format_to(std::back_inserter(out), R"({{"time":"{}.{:03}Z","level":"{}","text":{})",
                 utc_time(std::chrono::sys_seconds{seconds}, "%Y-%m-%dT%H:%M:%S"),
                 (since_1970 - seconds).count(), std::string_view{level.data(), level.size()},
                 text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  if (!line.source.empty()) {
    fmt::format_to(std::back_inserter(out), R"(,"{}":{})", line.source.filename, line.source.funcname);
  }
  out.push_back('}');
  out.push_back('\n');
}

std::unique_ptr<spdlog::formatter> JsonLines::clone() const {
  return std::make_unique<JsonLines>();
}

}  // namespace talus::server
