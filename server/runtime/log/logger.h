// The server's log on stdout. main makes it once and passes it down.
#pragma once

#include <memory>
#include <string_view>

#include <spdlog/logger.h>

#if defined(FMT_VERSION) && FMT_VERSION < 100000 && !defined(FMT_HEADER_ONLY)
// libfmt holds this function compiled, which its headers do not say. Every file that logs would compile it
// again, and with it all of formatting.
extern template void fmt::detail::vformat_to(buffer<char>&, string_view,
                                             basic_format_args<buffer_context<char>>, locale_ref);
#endif

namespace talus::server {

using Logger = std::shared_ptr<spdlog::logger>;

/// `level` is trace, debug, info, warning, error or off; `format` is text or json. The configuration checks
/// both.
[[nodiscard]] Logger make_logger(std::string_view level, std::string_view format);
/// The same log for lines that clients cause: the number of its info lines per second is limited.
[[nodiscard]] Logger for_clients(const Logger& log);

}  // namespace talus::server
