// Every setting once: its key in the file, its range, unit and meaning, and where it lives in Config.
// The file, the environment and the flags are all read through this table.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <tl/expected.hpp>

#include "config/config.h"

namespace talus::server {

/// A whole number from `least` to `most`.
struct NumberTarget {
  std::uint64_t& (*at)(Config&);
  std::uint64_t least;
  std::uint64_t most;
};
struct EndpointTarget {
  protocol::Endpoint& (*at)(Config&);
};
/// An empty string stands for none.
struct OptionalEndpointTarget {
  std::optional<protocol::Endpoint>& (*at)(Config&);
};
struct PathTarget {
  std::filesystem::path& (*at)(Config&);
};
/// An empty string stands for none.
struct NetworksTarget {
  Networks& (*at)(Config&);
};
/// One of a few words.
struct WordTarget {
  std::string& (*at)(Config&);
  std::span<const std::string_view> words;
};

/// What other parts understand.
struct TextTarget {
  std::string& (*at)(Config&);
};

struct Field {
  std::string_view key;   // "limits.connections"
  std::string_view unit;  // "" where the value has none
  std::string_view help;
  std::variant<NumberTarget, EndpointTarget, OptionalEndpointTarget, PathTarget, NetworksTarget, WordTarget,
               TextTarget>
      target;
};

[[nodiscard]] std::span<const Field> fields();
[[nodiscard]] const Field* find_field(std::string_view key);

/// "TALUS_LIMITS_CONNECTIONS" for "limits.connections".
[[nodiscard]] std::string variable_name(const Field& field);

/// Sets the field from a text, as the environment and flags give it. The error says what is wrong and what
/// would be right; the caller puts in front where the value stood.
[[nodiscard]] tl::expected<void, std::string> set_from_text(const Field& field, Config& config,
                                                            std::string_view text);
/// Sets a number; an error for any other kind of field.
[[nodiscard]] tl::expected<void, std::string> set_from_number(const Field& field, Config& config,
                                                              std::int64_t number);

/// What a right value looks like, for messages: "a whole number from 1 to 65536 (connections)".
[[nodiscard]] std::string expectation(const Field& field);

}  // namespace talus::server
