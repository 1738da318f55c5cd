// What a client may do.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

enum class Right : std::uint8_t {
  read,     // to join and to request chunks
  edit,     // to change voxels
  admin,    // to change them where the server's settings protect them too
  gateway,  // to edit for others, and say for whom: a game server's
};

/// A set of rights. A set that is not empty has `read`.
class Rights {
 public:
  constexpr Rights() = default;
  constexpr Rights(std::initializer_list<Right> rights) {
    for (const Right right : rights) bits_ |= bit(right);
  }

  /// "none", or words separated by commas, "read" among them: "read,edit". The error says what is wrong and
  /// what is expected.
  [[nodiscard]] static tl::expected<Rights, std::string> parse(std::string_view text);

  [[nodiscard]] constexpr bool has(Right right) const { return (bits_ & bit(right)) != 0; }
  bool operator==(const Rights&) const = default;

 private:
  [[nodiscard]] static constexpr std::uint8_t bit(Right right) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(right));
  }

  std::uint8_t bits_ = 0;
};

/// The form that parse() reads.
[[nodiscard]] std::string to_string(Rights rights);

}  // namespace talus::server
