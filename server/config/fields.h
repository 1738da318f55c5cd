// The table of settings: key, unit, help text, range, and member of Config. The file, the environment and the
// flags are all read with it.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "config/config.h"

namespace talus::server {

/// A whole number from `min` to `max`.
struct NumberTarget {
  std::uint64_t& (*at)(Config&);
  std::uint64_t min;
  std::uint64_t max;
};
/// Like NumberTarget; nullopt, written "auto", lets the server choose.
struct OptionalNumberTarget {
  std::optional<std::uint64_t>& (*at)(Config&);
  std::uint64_t min;
  std::uint64_t max;
};
/// 0, or a power of two up to `max`, itself a power of two.
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
/// Empty string: unset.
struct OptionalEndpointTarget {
  std::optional<protocol::Endpoint>& (*at)(Config&);
};
struct PathTarget {
  std::filesystem::path& (*at)(Config&);
};
/// Empty string: no networks.
struct NetworksTarget {
  Networks& (*at)(Config&);
};
/// Empty string: no boxes.
struct BoxesTarget {
  Boxes& (*at)(Config&);
};
/// true or false.
struct SwitchTarget {
  bool& (*at)(Config&);
};
/// Empty string: the page's own host.
struct OriginsTarget {
  AllowedOrigins& (*at)(Config&);
};
/// A list, which may be empty.
struct UrlsTarget {
  ServerUrls& (*at)(Config&);
  std::span<const std::string_view> schemes;
};
/// One of `words`.
struct WordTarget {
  std::string& (*at)(Config&);
  std::span<const std::string_view> words;
};

/// A list of `words`, which may be empty.
struct WordsTarget {
  std::vector<std::string>& (*at)(Config&);
  std::span<const std::string_view> words;
};

/// A text validated by another module.
struct TextTarget {
  std::string& (*at)(Config&);
};

/// When a change of the file takes effect after SIGHUP.
enum class Counts : std::uint8_t { after_restart, for_new_sessions, at_once };

struct Field {
  std::string_view key;   // "limits.connections"
  std::string_view unit;  // empty if the value has no unit
  std::string_view help;
  std::variant<NumberTarget, OptionalNumberTarget, PowerOfTwoTarget, DurationTarget, EndpointTarget,
               OptionalEndpointTarget, PathTarget, NetworksTarget, BoxesTarget, SwitchTarget, OriginsTarget,
               UrlsTarget, WordTarget, WordsTarget, TextTarget>
      target;
};

[[nodiscard]] std::span<const Field> fields();
/// Returns null if no setting has this key.
[[nodiscard]] const Field* find_field(std::string_view key);

[[nodiscard]] Counts counts(const Field& field);

/// True for a number or "auto": set_from_number() accepts it, and files write it without quotes.
[[nodiscard]] bool is_number(const Field& field);

/// "TALUS_LIMITS_CONNECTIONS" for "limits.connections".
[[nodiscard]] std::string variable_name(std::string_view key);

/// Sets the field from text of the environment or a flag. The error describes what is wrong and what is
/// expected; the caller prefixes the value's origin.
[[nodiscard]] tl::expected<void, std::string> set_from_text(const Field& field, Config& config,
                                                            std::string_view text);
/// Requires is_number(field); otherwise returns an error.
[[nodiscard]] tl::expected<void, std::string> set_from_number(const Field& field, Config& config,
                                                              std::int64_t number);

/// Text of an unset OptionalNumberTarget.
inline constexpr std::string_view kAuto = "auto";

/// The field's value as text that set_from_text() accepts.
[[nodiscard]] std::string text_of(const Field& field, const Config& config);

/// Describes accepted values for error messages: "a whole number from 1 to 65536 (connections)".
[[nodiscard]] std::string expectation(const Field& field);

}  // namespace talus::server
