// What talus-gen reads is a regular file: opening a pipe may wait forever, and a device has no end.
#pragma once

#include <string>

#include "failure.h"

namespace talus::tools {

/// An error where `path` is there and is no regular file. What is not there is found when it is opened.
[[nodiscard]] Expected<void> check_regular_file(const std::string& path);

}  // namespace talus::tools
