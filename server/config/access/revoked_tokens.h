// The operator's list of signed tokens that are rejected before they expire (config/access/list_file.h):
//
//     jti ID              the token with this "jti"
//     sub TIME SUBJECT    tokens of SUBJECT that were issued before TIME
//
// TIME is UTC, as 2026-11-22T18:30:00Z. A token without "iat" counts as issued before any TIME.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <tl/expected.hpp>

namespace talus::server {

class RevokedTokens {
 public:
  /// An error is one line that begins with the number of the wrong line.
  [[nodiscard]] static tl::expected<RevokedTokens, std::string> parse(std::string_view text);
  /// An error is one line that begins with the file.
  [[nodiscard]] static tl::expected<RevokedTokens, std::string> read(const std::filesystem::path& file);

  /// Pass an empty `id` or `subject` if the token lacks it.
  [[nodiscard]] bool contains(const std::string& id, const std::string& subject,
                              std::optional<std::chrono::sys_seconds> issued) const;
  /// Number of revocations.
  [[nodiscard]] std::size_t size() const { return ids_.size() + subjects_.size(); }

 private:
  /// Returns why the line is wrong; empty if it is right.
  [[nodiscard]] std::string add(std::string_view line);

  std::unordered_set<std::string> ids_;
  std::unordered_map<std::string, std::chrono::sys_seconds> subjects_;  // rejected if issued before then
};

}  // namespace talus::server
