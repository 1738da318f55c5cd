#include "regular_file.h"

#include <filesystem>
#include <system_error>

namespace talus::tools {

Expected<void> check_regular_file(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return failed(path + ": is a directory");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return failed(path + ": is not a regular file");
  }
  return {};
}

}  // namespace talus::tools
