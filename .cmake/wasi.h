// Included before every source for WebAssembly: what Debian's libc++ for it leaves out.
#pragma once

#include <version>

// File streams, which work.
#undef _LIBCPP_HAS_NO_FILESYSTEM
#undef _LIBCPP_AVAILABILITY_HAS_ADDITIONAL_IOSTREAM_EXPLICIT_INSTANTIATIONS_1
#define _LIBCPP_AVAILABILITY_HAS_ADDITIONAL_IOSTREAM_EXPLICIT_INSTANTIATIONS_1 0

// A double from text. By it toml++ does without std::stringstream, whose locales would be a tenth of the
// module.
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  char* end = nullptr;
  value = strtod(text.c_str(), &end);
  // As where streams read them: what is too large is no number.
  if (end == text.c_str() || !isfinite(value)) return {first, errc::invalid_argument};
  return {first + (end - text.c_str()), errc{}};
}

}  // namespace std
