// Errors in a world.toml: the first one is kept, as one line. Private to core/terrain.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <talus/terrain/world.h>

#include "spec/text_writer.h"

namespace talus::terrain {

/// Formats a number as people write it: 16777216, 0.000001, 1e18, 1/65536.
[[nodiscard]] std::string plain(double number);

/// Concatenates the parts; formats floating-point numbers with plain().
[[nodiscard]] std::string text_of(const auto&... parts) {
  TextWriter text;
  const auto add = [&](const auto& part) {
    if constexpr (std::floating_point<std::decay_t<decltype(part)>>) {
      text << plain(part);
    } else {
      text << part;
    }
  };
  (add(parts), ...);
  return std::move(text).take();
}

class SpecErrors {
 public:
  /// `file` names the source in messages.
  explicit SpecErrors(std::string_view file) : file_{file} {}

  /// `column` may be 0, and `key` empty. Control characters, which keys and names may contain, are escaped.
  void add(int line, int column, const std::string& key, const std::string& what);

  [[nodiscard]] bool any() const { return first_.has_value(); }
  /// REQUIRES: any().
  [[nodiscard]] const SpecError& first() const { return *first_; }

 private:
  std::string file_;
  std::optional<SpecError> first_;
};

}  // namespace talus::terrain
