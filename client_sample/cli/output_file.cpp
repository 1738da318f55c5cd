#include "output_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace talus::cli {

tl::expected<void, std::string> write_file(const std::filesystem::path& path,
                                           std::span<const std::byte> bytes) {
  std::filesystem::path part = path;
  part += ".part";
  errno = 0;
  std::ofstream out{part, std::ios::binary | std::ios::trunc};
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) {
    std::filesystem::rename(part, path, error);
  } else {
    error = std::error_code{errno == 0 ? EIO : errno, std::generic_category()};
  }
  if (!error) return {};
  std::error_code ignored;  // the first error is the one to tell
  std::filesystem::remove(part, ignored);
  return tl::unexpected{path.string() + ": cannot be written: " + error.message()};
}

}  // namespace talus::cli
