#include <talus/files/file_error.h>
#include <talus/files/path_text.h>

namespace talus::files {

std::string FileError::message() const {
  return (path.empty() ? "''" : to_text(path)) + ": " + reason;
}

}  // namespace talus::files
