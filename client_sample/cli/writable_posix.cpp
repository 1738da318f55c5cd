#include "writable.h"

#include <unistd.h>

#include <cerrno>

namespace talus::cli {

std::error_code check_writable(const std::filesystem::path& folder) {
  if (::access(folder.c_str(), W_OK) == 0) return {};
  return {errno, std::generic_category()};
}

}  // namespace talus::cli
