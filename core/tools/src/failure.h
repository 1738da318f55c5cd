// How a command of talus-gen fails: one line for the person, one exit code for the script.
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace talus::tools {

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitWrongUse = 2;

struct Failure {
  int exit_code = kExitFailed;
  std::string message;  // one line, no full stop, no line end
};

template <typename Value>
using Expected = tl::expected<Value, Failure>;

/// The command was right, but it could not be done.
[[nodiscard]] inline tl::unexpected<Failure> failed(std::string message) {
  return tl::unexpected<Failure>{Failure{kExitFailed, std::move(message)}};
}

/// The command itself is wrong.
[[nodiscard]] inline tl::unexpected<Failure> wrong_use(std::string message) {
  return tl::unexpected<Failure>{Failure{kExitWrongUse, std::move(message)}};
}

}  // namespace talus::tools
