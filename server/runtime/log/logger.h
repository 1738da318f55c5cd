// The server's log on stdout. main creates it once and passes it down.
#pragma once

#include <memory>
#include <string_view>

#include <spdlog/logger.h>

#if defined(FMT_VERSION) && FMT_VERSION < 100000 && !defined(FMT_HEADER_ONLY)
// libfmt contains this instantiation but its headers do not declare it extern. Without this line every file
// that logs would compile all of fmt's formatting.
extern template void fmt::detail::vformat_to(buffer<char>&, string_view,
                                             basic_format_args<buffer_context<char>>, locale_ref);
#endif

namespace talus::server {

using Logger = std::shared_ptr<spdlog::logger>;

/// `level` is trace, debug, info, warning, error or off; `format` is text or json. Config validates both.
[[nodiscard]] Logger make_logger(std::string_view level, std::string_view format);
/// The same log for lines that clients cause: its info lines per second are limited.
[[nodiscard]] Logger for_clients(const Logger& log);

}  // namespace talus::server
