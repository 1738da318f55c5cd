#include <talus/files/read_file.h>

#include <array>
#include <span>

#include "open_file.h"

namespace talus::files {

tl::expected<std::string, FileError> read_file(const std::filesystem::path& file, std::size_t max_bytes,
                                               FileLayer& layer) {
  const auto failed = [&](std::error_code code) {
    return tl::unexpected{FileError{file, "cannot be read: " + code.message(), code}};
  };
  const auto opened = layer.open_to_read(file, FileLayer::Waiting::allowed);
  if (!opened) return failed(opened.error());
  const OpenFile in{layer, *opened};
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const auto bytes = layer.read(in.get(), std::as_writable_bytes(std::span{block}));
    if (!bytes) return failed(bytes.error());
    if (*bytes == 0) return text;
    text.append(block.data(), *bytes);
    if (text.size() > max_bytes) return failed(std::make_error_code(std::errc::file_too_large));
  }
}

}  // namespace talus::files
