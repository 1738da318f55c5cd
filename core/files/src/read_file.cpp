#include <talus/files/read_file.h>

#include <sys/stat.h>

#include <array>
#include <span>

#include "open_file.h"

namespace talus::files {
namespace {

tl::unexpected<FileError> cannot_read(const std::filesystem::path& file, std::error_code code) {
  return tl::unexpected{FileError{file, "cannot be read: " + code.message(), code}};
}

tl::expected<std::string, FileError> read_to_end(const std::filesystem::path& path, int file,
                                                 std::size_t max_bytes, FileLayer& layer) {
  std::string text;
  std::array<char, 1 << 16> block{};
  for (;;) {
    const auto bytes = layer.read(file, std::as_writable_bytes(std::span{block}));
    if (!bytes) return cannot_read(path, bytes.error());
    if (*bytes == 0) return text;
    text.append(block.data(), *bytes);
    if (text.size() > max_bytes) {
      return tl::unexpected{FileError{path, "has over " + std::to_string(max_bytes) + " bytes",
                                      std::make_error_code(std::errc::file_too_large)}};
    }
  }
}

}  // namespace

tl::expected<std::string, FileError> read_file(const std::filesystem::path& file, std::size_t max_bytes,
                                               FileLayer& layer) {
  const auto opened = layer.open_to_read(file, FileLayer::WaitPolicy::allowed);
  if (!opened) return cannot_read(file, opened.error());
  const OpenFile in{layer, *opened};
  return read_to_end(file, in.get(), max_bytes, layer);
}

tl::expected<std::string, FileError> read_regular_file(const std::filesystem::path& file,
                                                       std::size_t max_bytes, FileLayer& layer) {
  const auto opened = layer.open_to_read(file, FileLayer::WaitPolicy::never);
  if (!opened) return cannot_read(file, opened.error());
  const OpenFile in{layer, *opened};
  const auto mode = layer.mode(in.get());
  if (!mode) return cannot_read(file, mode.error());
  if (S_ISDIR(*mode)) return tl::unexpected{FileError{file, "is a directory", {}}};
  if (!S_ISREG(*mode)) return tl::unexpected{FileError{file, "is not a regular file", {}}};
  return read_to_end(file, in.get(), max_bytes, layer);
}

}  // namespace talus::files
