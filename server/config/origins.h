// Records where settings were set, for errors that appear only when a setting is used.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace talus::server {

class Origins {
 public:
  /// `origin`: "talusd.toml:12" or "TALUS_USER". A later origin replaces an earlier one.
  void set(std::string_view key, std::string origin);
  /// Called if a flag overrides the setting: such errors name the flag.
  void forget(std::string_view key);

  /// Prefixes `line` with the origin of its setting if the line begins with the key of a setting that has an
  /// origin: "user: no such user" becomes "talusd.toml:12: user: no such user". Returns other lines
  /// unchanged.
  [[nodiscard]] std::string locate(std::string_view line) const;

 private:
  std::map<std::string, std::string, std::less<>> origins_;
};

}  // namespace talus::server
