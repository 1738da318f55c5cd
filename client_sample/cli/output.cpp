#include "output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace talus::cli {

tl::expected<void, std::string> check_output(const std::filesystem::path& path) {
  if (path.empty()) return {};
  const auto folder = std::filesystem::absolute(path).parent_path();
  if (::access(folder.c_str(), W_OK) == 0) return {};
  return tl::unexpected{path.string() + ": cannot be written: " + std::strerror(errno) +
                        "; give a folder that is there and can be written to"};
}

}  // namespace talus::cli
