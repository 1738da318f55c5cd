// Failure of a command: one line for humans, one exit code for scripts.
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include <talus/files/file_error.h>

namespace talus::tools {

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitWrongUse = 2;

struct Failure {
  int exit_code = kExitFailed;
  std::string message;  // one line, no full stop, no line end

  Failure(int code, std::string line) : exit_code{code}, message{std::move(line)} {}
  /// Implicit, so that functions can return file errors directly.
  Failure(const files::FileError& error) : message{error.message()} {}
};

template <typename Value>
using Expected = tl::expected<Value, Failure>;

/// Converts the result of a file operation to a command's.
[[nodiscard]] inline Expected<void> outcome_of(const tl::expected<void, files::FileError>& done) {
  if (!done) return tl::unexpected{Failure{done.error()}};
  return {};
}

/// The command is valid, but it failed.
[[nodiscard]] inline tl::unexpected<Failure> failed(std::string message) {
  return tl::unexpected<Failure>{Failure{kExitFailed, std::move(message)}};
}

/// The command's arguments are wrong.
[[nodiscard]] inline tl::unexpected<Failure> wrong_use(std::string message) {
  return tl::unexpected<Failure>{Failure{kExitWrongUse, std::move(message)}};
}

}  // namespace talus::tools
