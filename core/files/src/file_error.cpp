#include <talus/files/file_error.h>

namespace talus::files {

std::string FileError::message() const {
  return (path.empty() ? "''" : path.string()) + ": " + reason;
}

}  // namespace talus::files
