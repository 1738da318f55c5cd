// What talusd says on stderr: why it does not start, before there is a log or without one.
#pragma once

#include <string>
#include <string_view>

#include <spdlog/common.h>

namespace talus::server {

/// One line with its end: "talusd: TEXT", "talusd: warning: TEXT", or an object as the log writes them where
/// `format` is json. Bytes of `text` that are not printable ASCII become \xNN.
[[nodiscard]] std::string program_line(std::string_view format, spdlog::level::level_enum level,
                                       std::string_view text);

}  // namespace talus::server
