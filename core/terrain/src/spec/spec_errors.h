// What is wrong with a world.toml: the first fault is kept, as one line. Private to core/terrain.
#pragma once

#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <talus/terrain/world.h>

namespace talus::terrain {

[[nodiscard]] std::string text_of(const auto&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

class SpecErrors {
 public:
  /// `file` names the source in messages.
  explicit SpecErrors(std::string_view file) : file_{file} {}

  /// "FILE:LINE: what". Control characters are escaped: a key or a name may hold any.
  void add(int line, const std::string& what);

  [[nodiscard]] bool any() const { return first_.has_value(); }
  /// REQUIRES: any().
  [[nodiscard]] const SpecError& first() const { return *first_; }

 private:
  std::string file_;
  std::optional<SpecError> first_;
};

}  // namespace talus::terrain
