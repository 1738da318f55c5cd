// The table of settings: key, unit, help text, range, and member of Config. The file, the environment and the
// flags are all read through it.
#pragma once

#include <chrono>
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

/// A whole number from `min` to `max`.
struct NumberTarget {
  std::uint64_t& (*at)(Config&);
  std::uint64_t min;
  std::uint64_t max;
};
/// As NumberTarget; none, which is "auto", means that the server chooses.
struct OptionalNumberTarget {
  std::optional<std::uint64_t>& (*at)(Config&);
  std::uint64_t min;
  std::uint64_t max;
};
/// 0, or a power of two up to `max`, which is one.
struct PowerOfTwoTarget {
  std::uint64_t& (*at)(Config&);
  std::uint64_t max;
};
/// A whole number of milliseconds; its key ends in "_ms".
struct DurationTarget {
  std::chrono::milliseconds& (*at)(Config&);
  std::chrono::milliseconds min;
  std::chrono::milliseconds max;
};
struct EndpointTarget {
  protocol::Endpoint& (*at)(Config&);
};
/// An empty string means none.
struct OptionalEndpointTarget {
  std::optional<protocol::Endpoint>& (*at)(Config&);
};
struct PathTarget {
  std::filesystem::path& (*at)(Config&);
};
/// An empty string means none.
struct NetworksTarget {
  Networks& (*at)(Config&);
};
/// An empty string means none.
struct BoxesTarget {
  Boxes& (*at)(Config&);
};
/// true or false.
struct SwitchTarget {
  bool& (*at)(Config&);
};
/// An empty string means the page's own host.
struct OriginsTarget {
  AllowedOrigins& (*at)(Config&);
};
/// A list. An empty one means none.
struct UrlsTarget {
  ServerUrls& (*at)(Config&);
  std::span<const std::string_view> schemes;
};
/// One of `words`.
struct WordTarget {
  std::string& (*at)(Config&);
  std::span<const std::string_view> words;
};

/// A text that another module checks.
struct TextTarget {
  std::string& (*at)(Config&);
};

/// When a setting counts that has changed in the file, after SIGHUP.
enum class Counts : std::uint8_t { after_restart, for_new_sessions, at_once };

struct Field {
  std::string_view key;   // "limits.connections"
  std::string_view unit;  // "" where the value has none
  std::string_view help;
  std::variant<NumberTarget, OptionalNumberTarget, PowerOfTwoTarget, DurationTarget, EndpointTarget,
               OptionalEndpointTarget, PathTarget, NetworksTarget, BoxesTarget, SwitchTarget, OriginsTarget,
               UrlsTarget, WordTarget, TextTarget>
      target;
};

[[nodiscard]] std::span<const Field> fields();
/// Null where no setting has this key.
[[nodiscard]] const Field* find_field(std::string_view key);

[[nodiscard]] Counts counts(const Field& field);

/// Whether it is a number, or auto in its place: set_from_number() sets it, and a file has it without quotes.
[[nodiscard]] bool is_number(const Field& field);

/// "TALUS_LIMITS_CONNECTIONS" for "limits.connections".
[[nodiscard]] std::string variable_name(std::string_view key);

/// Sets the field from a text, as the environment and flags have it. The error says what is wrong and what is
/// expected; the caller puts the origin of the value before it.
[[nodiscard]] tl::expected<void, std::string> set_from_text(const Field& field, Config& config,
                                                            std::string_view text);
/// Of a field that is_number(); an error for others.
[[nodiscard]] tl::expected<void, std::string> set_from_number(const Field& field, Config& config,
                                                              std::int64_t number);

/// The text of an OptionalNumberTarget that has none.
inline constexpr std::string_view kAuto = "auto";

/// The field's value as a text that set_from_text() would take.
[[nodiscard]] std::string text_of(const Field& field, const Config& config);

/// What the field accepts, for error messages: "a whole number from 1 to 65536 (connections)".
[[nodiscard]] std::string expectation(const Field& field);

}  // namespace talus::server
