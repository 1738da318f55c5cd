// Where a setting was set: for errors that show only when the setting is used.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace talus::server {

class Origins {
 public:
  /// `origin`: "talusd.toml:12" or "TALUS_USER". A later origin replaces an earlier one.
  void set(std::string_view key, std::string origin);
  /// A flag overrides the setting: errors name it as the flag does.
  void forget(std::string_view key);

  /// `line` with the origin of its setting before it, where the line begins with the key of a setting that
  /// has an origin: "user: no such user" becomes "talusd.toml:12: user: no such user". Other lines stay as
  /// they are.
  [[nodiscard]] std::string locate(std::string_view line) const;

 private:
  std::map<std::string, std::string, std::less<>> origins_;
};

}  // namespace talus::server
