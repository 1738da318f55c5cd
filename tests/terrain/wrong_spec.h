// A spec with one thing changed, and what World::parse says of it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include <talus/terrain/world.h>

namespace talus::test {

/// One thing changed, and how the error begins, or what it holds.
struct Wrong {
  std::string from;
  std::string to;
  std::string message;
};

/// `text` with the first `from` at or behind `begin` replaced; it must be there.
[[nodiscard]] inline std::string replaced(std::string text, const std::string& from, const std::string& to,
                                          std::size_t begin = 0) {
  const std::size_t at = text.find(from, begin);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// The error of a spec in w.toml, or "accepted".
[[nodiscard]] inline std::string error_of(const std::string& text) {
  const auto world = terrain::World::parse(text, "w.toml");
  return world ? "accepted" : world.error().message;
}

}  // namespace talus::test
