#include "writable.h"

#include <io.h>

#include <cerrno>

namespace talus::cli {

std::error_code check_writable(const std::filesystem::path& folder) {
  if (::_waccess(folder.c_str(), 2 /* to write */) == 0) return {};
  return {errno, std::generic_category()};
}

}  // namespace talus::cli
