// Origins whose pages were refused, so that the log names each once. Callable from any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace talus::server::web {

class RefusedOrigins {
 public:
  /// Maximum number of origins, and of characters of each; more are not remembered.
  static constexpr std::size_t kMax = 100;
  static constexpr std::size_t kMaxLength = 200;

  /// Returns true if the origin is new and there is room for it.
  [[nodiscard]] bool add(std::string_view origin) {
    origin = origin.substr(0, kMaxLength);
    const std::lock_guard lock{mutex_};
    if (origins_.size() == kMax || origins_.contains(origin)) return false;
    origins_.emplace(origin);
    return true;
  }

 private:
  std::mutex mutex_;
  std::set<std::string, std::less<>> origins_;
};

}  // namespace talus::server::web
