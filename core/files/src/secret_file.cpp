#include <talus/files/secret_file.h>

#include <sys/stat.h>

#include <span>
#include <string>

#include "open_file.h"

namespace talus::files {

tl::expected<SecretFile, FileError> SecretFile::read(const std::filesystem::path& file, std::size_t max_bytes,
                                                     FileLayer& layer) {
  const auto refused = [&](const std::string& reason) { return tl::unexpected{FileError{file, reason, {}}}; };
  const auto failed = [&](std::error_code code) {
    return tl::unexpected{FileError{file, "cannot be read: " + code.message(), code}};
  };
  const auto opened = layer.open_to_read(file, FileLayer::WaitPolicy::never);
  if (!opened) return failed(opened.error());
  const OpenFile in{layer, *opened};
  const auto mode = layer.mode(in.get());
  if (!mode) return failed(mode.error());
  if (!S_ISREG(*mode)) return refused("is not a regular file");
  SecretFile read;
  read.mode_ = *mode;
  read.bytes_.resize(max_bytes + 1);
  std::size_t size = 0;
  while (size < read.bytes_.size()) {
    const auto bytes = layer.read(in.get(), std::as_writable_bytes(std::span{read.bytes_}).subspan(size));
    if (!bytes) return failed(bytes.error());
    if (*bytes == 0) break;
    size += *bytes;
  }
  if (size > max_bytes) return refused("has over " + std::to_string(max_bytes) + " bytes");
  read.bytes_.resize(size);
  return read;
}

SecretFile::~SecretFile() {
  volatile char* const bytes = bytes_.data();  // or a compiler leaves out what is not read again
  for (std::size_t i = 0; i < bytes_.size(); ++i) bytes[i] = 0;
}

}  // namespace talus::files
