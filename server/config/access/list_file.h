// Lists that operators maintain: text files with one entry per line. Empty lines and lines that begin with #
// are ignored.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

inline constexpr std::size_t kMaxListFileBytes = std::size_t{16} << 20;

/// Takes a trimmed line and its number. Returns why the line is wrong; empty if it is right.
using AddLine = std::function<std::string(std::string_view line, std::size_t number)>;

/// Passes each line to `add`, up to the first wrong one. An error is one line that begins with the number of
/// the wrong line.
[[nodiscard]] tl::expected<void, std::string> parse_list(std::string_view text, const AddLine& add);
/// Reads a regular file of at most kMaxListFileBytes. An error is one line that begins with the file.
[[nodiscard]] tl::expected<void, std::string> read_list(const std::filesystem::path& file,
                                                        const AddLine& add);

/// Removes the first word and the blanks after it from `text`, and returns the word.
[[nodiscard]] std::string_view take_word(std::string_view& text);

}  // namespace talus::server
