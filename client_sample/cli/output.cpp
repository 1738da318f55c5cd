#include "output.h"

#include <talus/files/path_text.h>

#include "writable.h"

namespace talus::cli {

tl::expected<void, std::string> check_output(const std::filesystem::path& path) {
  if (path.empty()) return {};
  const auto folder = std::filesystem::absolute(path).parent_path();
  const std::error_code refused = check_writable(folder);
  if (!refused) return {};
  return tl::unexpected{files::to_text(path) + ": cannot be written: " + refused.message() +
                        "; give a folder that is there and can be written to"};
}

}  // namespace talus::cli
