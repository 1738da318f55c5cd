// Lists that operators keep: text files with an entry a line. Empty lines, and those that begin with #, are
// ignored.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

inline constexpr std::size_t kMaxListFileBytes = std::size_t{16} << 20;

/// Takes a line without the blanks around it, and its number. Returns why it is wrong; empty: it is right.
using AddLine = std::function<std::string(std::string_view line, std::size_t number)>;

/// Hands all lines over, up to the first that is wrong. An error is one line that begins with the number of
/// that line.
[[nodiscard]] tl::expected<void, std::string> parse_list(std::string_view text, const AddLine& add);
/// Reads a regular file of at most kMaxListFileBytes. An error is one line that begins with the file.
[[nodiscard]] tl::expected<void, std::string> read_list(const std::filesystem::path& file,
                                                        const AddLine& add);

/// The first word of a text, which is cut off it with the blanks after it.
[[nodiscard]] std::string_view take_word(std::string_view& text);

}  // namespace talus::server
