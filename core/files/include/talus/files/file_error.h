// Error of reading or writing a file.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace talus::files {

struct FileError {
  std::filesystem::path path;  // as the caller gave it
  std::string reason;          // "cannot write: No space left on device", "is not a regular file"
  std::error_code code;        // the system's error; empty if the file was rejected for another reason

  /// One line: "PATH: REASON".
  [[nodiscard]] std::string message() const;
};

}  // namespace talus::files
