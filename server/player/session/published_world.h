// The files from which clients make the world by themselves: its spec, and what the spec names. In memory
// once for all clients. Immutable.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace talus::server {

/// Error text for a client that asks for an unpublished world's files.
inline constexpr std::string_view kNotPublished = "this server's world is not published";

struct PublishedWorld {
  std::string spec;                                         // the world's TOML file
  std::map<std::string, std::string, std::less<>> files{};  // by their names in it

  /// The spec if `name` is empty; null if the spec names no such file.
  [[nodiscard]] const std::string* find(std::string_view name) const {
    if (name.empty()) return &spec;
    const auto found = files.find(name);
    return found == files.end() ? nullptr : &found->second;
  }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = spec.size();
    for (const auto& [name, bytes] : files) sum += bytes.size();
    return sum;
  }
};

}  // namespace talus::server
