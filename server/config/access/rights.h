// Rights of a client.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

enum class Right : std::uint8_t {
  read,     // join and request chunks
  edit,     // change voxels
  admin,    // also change voxels that the server's settings protect
  gateway,  // edit on behalf of named players, for game servers
};

/// A set of rights. Every non-empty set has `read`.
class Rights {
 public:
  constexpr Rights() = default;
  constexpr Rights(std::initializer_list<Right> rights) {
    for (const Right right : rights) bits_ |= bit(right);
  }

  /// Parses "none", or words separated by commas and blanks that include "read", such as "read,edit". The
  /// error names what is wrong and what is expected.
  [[nodiscard]] static tl::expected<Rights, std::string> parse(std::string_view text);

  [[nodiscard]] constexpr bool has(Right right) const { return (bits_ & bit(right)) != 0; }
  bool operator==(const Rights&) const = default;

 private:
  [[nodiscard]] static constexpr std::uint8_t bit(Right right) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(right));
  }

  std::uint8_t bits_ = 0;
};

/// Inverse of parse().
[[nodiscard]] std::string to_string(Rights rights);

}  // namespace talus::server
