// Reasons in one line, in the order in which they are added, each once.
#pragma once

#include <string>
#include <string_view>

namespace talus::server {

class Reasons {
 public:
  /// Ignores an empty reason, and one that the text has.
  void add(std::string_view reason) {
    if (reason.empty() || text_.find(reason) != std::string::npos) return;
    if (!text_.empty()) text_ += "; ";
    text_ += reason;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace talus::server
