// Conversion of settings from and to text and numbers, and their descriptions.
#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "config/fields.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

tl::unexpected<std::string> refused(const Field& field, std::string_view value) {
  return tl::make_unexpected(fmt::format("{} is wrong; give {}", value, expectation(field)));
}

/// Assigns to a number or a duration.
template <typename Target>
tl::expected<void, std::string> assign_number(const Field& field, const Target& target, Config& config,
                                              std::optional<std::uint64_t> value, std::string_view shown) {
  using Value = std::remove_reference_t<decltype(target.at(config))>;
  const auto count = [](const Value& bound) {
    if constexpr (std::is_same_v<Value, milliseconds>)
      return static_cast<std::uint64_t>(bound.count());
    else
      return bound;
  };
  if (!value || *value < count(target.min) || *value > count(target.max)) return refused(field, shown);
  if constexpr (std::is_same_v<Value, milliseconds>) {
    target.at(config) = milliseconds{static_cast<milliseconds::rep>(*value)};
  } else {
    target.at(config) = *value;
  }
  return {};
}

tl::expected<void, std::string> assign_optional(const Field& field, const OptionalNumberTarget& target,
                                                Config& config, std::optional<std::uint64_t> value,
                                                std::string_view shown) {
  if (!value || *value < target.min || *value > target.max) return refused(field, shown);
  target.at(config) = value;
  return {};
}

tl::expected<void, std::string> assign_power_of_two(const Field& field, const PowerOfTwoTarget& target,
                                                    Config& config, std::optional<std::uint64_t> value,
                                                    std::string_view shown) {
  if (!value || *value > target.max) return refused(field, shown);
  if (*value != 0 && !std::has_single_bit(*value)) {
    return tl::make_unexpected(fmt::format("{} is wrong; give {} or {}, the nearest powers of two", shown,
                                           std::bit_floor(*value), std::bit_ceil(*value)));
  }
  target.at(config) = *value;
  return {};
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return !text.empty() && error == std::errc{} && stop == end ? std::optional{value} : std::nullopt;
}

/// Assigns a text to a target.
struct AssignText {
  const Field& field;
  Config& config;
  std::string_view text;

  [[nodiscard]] tl::unexpected<std::string> refused_endpoint(const std::string& reason) const {
    return tl::make_unexpected(fmt::format("\"{}\": {}", escaped(text), reason));
  }

  tl::expected<void, std::string> operator()(const NumberTarget& target) const {
    return assign_number(field, target, config, whole_number(text), fmt::format("\"{}\"", escaped(text)));
  }
  tl::expected<void, std::string> operator()(const OptionalNumberTarget& target) const {
    if (text == kAuto) {
      target.at(config).reset();
      return {};
    }
    return assign_optional(field, target, config, whole_number(text), fmt::format("\"{}\"", escaped(text)));
  }
  tl::expected<void, std::string> operator()(const PowerOfTwoTarget& target) const {
    return assign_power_of_two(field, target, config, whole_number(text),
                               fmt::format("\"{}\"", escaped(text)));
  }
  tl::expected<void, std::string> operator()(const DurationTarget& target) const {
    return assign_number(field, target, config, whole_number(text), fmt::format("\"{}\"", escaped(text)));
  }
  tl::expected<void, std::string> operator()(const EndpointTarget& target) const {
    auto endpoint = protocol::parse_endpoint(text);
    if (!endpoint) return refused_endpoint(endpoint.error());
    target.at(config) = *std::move(endpoint);
    return {};
  }
  tl::expected<void, std::string> operator()(const OptionalEndpointTarget& target) const {
    if (text.empty()) {
      target.at(config).reset();
      return {};
    }
    auto endpoint = protocol::parse_endpoint(text);
    if (!endpoint) return refused_endpoint(endpoint.error());
    target.at(config) = *std::move(endpoint);
    return {};
  }
  tl::expected<void, std::string> operator()(const PathTarget& target) const {
    // The operating system would truncate the path at a zero byte.
    if (text.find('\0') != std::string_view::npos)
      return refused(field, fmt::format("\"{}\"", escaped(text)));
    target.at(config) = std::filesystem::path{text};
    return {};
  }
  tl::expected<void, std::string> operator()(const NetworksTarget& target) const {
    auto networks = Networks::parse(text);
    if (!networks) return tl::make_unexpected(networks.error());
    target.at(config) = *std::move(networks);
    return {};
  }
  tl::expected<void, std::string> operator()(const BoxesTarget& target) const {
    auto boxes = Boxes::parse(text);
    if (!boxes) return tl::make_unexpected(boxes.error());
    target.at(config) = *std::move(boxes);
    return {};
  }
  tl::expected<void, std::string> operator()(const SwitchTarget& target) const {
    if (text != "true" && text != "false") return refused(field, fmt::format("\"{}\"", escaped(text)));
    target.at(config) = text == "true";
    return {};
  }
  tl::expected<void, std::string> operator()(const OriginsTarget& target) const {
    auto origins = AllowedOrigins::parse(text);
    if (!origins) return tl::make_unexpected(escaped(origins.error()));
    target.at(config) = *std::move(origins);
    return {};
  }
  tl::expected<void, std::string> operator()(const UrlsTarget& target) const {
    auto urls = ServerUrls::parse(text, target.schemes);
    if (!urls) return tl::make_unexpected(fmt::format("{}; give {}", urls.error(), expectation(field)));
    target.at(config) = *std::move(urls);
    return {};
  }
  tl::expected<void, std::string> operator()(const WordTarget& target) const {
    if (std::find(target.words.begin(), target.words.end(), text) == target.words.end()) {
      return refused(field, fmt::format("\"{}\"", escaped(text)));
    }
    target.at(config) = std::string{text};
    return {};
  }
  tl::expected<void, std::string> operator()(const WordsTarget& target) const {
    std::vector<std::string> words;
    for (std::string_view left = text; !left.empty();) {
      const std::string_view word = left.substr(0, left.find(','));
      left.remove_prefix(std::min(left.size(), word.size() + 1));
      const bool known = std::find(target.words.begin(), target.words.end(), word) != target.words.end();
      if (!known || std::find(words.begin(), words.end(), word) != words.end()) {
        return refused(field, fmt::format("\"{}\"", escaped(word)));
      }
      words.emplace_back(word);
    }
    target.at(config) = std::move(words);
    return {};
  }
  tl::expected<void, std::string> operator()(const TextTarget& target) const {
    target.at(config) = std::string{text};
    return {};
  }
};

/// Formats the value of a target.
struct ShowText {
  Config& config;

  std::string operator()(const NumberTarget& target) const { return fmt::to_string(target.at(config)); }
  std::string operator()(const OptionalNumberTarget& target) const {
    const auto& number = target.at(config);
    return number ? fmt::to_string(*number) : std::string{kAuto};
  }
  std::string operator()(const PowerOfTwoTarget& target) const { return fmt::to_string(target.at(config)); }
  std::string operator()(const DurationTarget& target) const {
    return fmt::to_string(target.at(config).count());
  }
  std::string operator()(const EndpointTarget& target) const { return to_string(target.at(config)); }
  std::string operator()(const OptionalEndpointTarget& target) const {
    const auto& endpoint = target.at(config);
    return endpoint ? to_string(*endpoint) : std::string{};
  }
  std::string operator()(const PathTarget& target) const { return target.at(config).string(); }
  std::string operator()(const NetworksTarget& target) const { return target.at(config).text(); }
  std::string operator()(const BoxesTarget& target) const { return target.at(config).text(); }
  std::string operator()(const SwitchTarget& target) const { return target.at(config) ? "true" : "false"; }
  std::string operator()(const OriginsTarget& target) const { return target.at(config).text(); }
  std::string operator()(const UrlsTarget& target) const { return target.at(config).text(); }
  std::string operator()(const WordTarget& target) const { return target.at(config); }
  std::string operator()(const WordsTarget& target) const {
    return fmt::format("{}", fmt::join(target.at(config), ","));
  }
  std::string operator()(const TextTarget& target) const { return target.at(config); }
};

/// Describes the values that a target accepts.
struct Describe {
  std::string_view unit;

  std::string operator()(const NumberTarget& target) const {
    return fmt::format("a whole number from {} to {} ({})", target.min, target.max, unit);
  }
  std::string operator()(const OptionalNumberTarget& target) const {
    return fmt::format("a whole number from {} to {} ({}), or \"{}\"", target.min, target.max, unit, kAuto);
  }
  std::string operator()(const PowerOfTwoTarget& target) const {
    std::string powers = "0, ";
    for (std::uint64_t power = 1; power < target.max; power *= 2) powers += fmt::format("{}, ", power);
    return fmt::format("{}or {} ({})", powers, target.max, unit);
  }
  std::string operator()(const DurationTarget& target) const {
    return fmt::format("a whole number from {} to {} ({})", target.min.count(), target.max.count(), unit);
  }
  std::string operator()(const EndpointTarget&) const { return "\"HOST:PORT\""; }
  std::string operator()(const OptionalEndpointTarget&) const {
    return "\"HOST:PORT\" or \"\" for no address";
  }
  std::string operator()(const PathTarget&) const { return fmt::format("the path of a {} in quotes", unit); }
  std::string operator()(const NetworksTarget&) const {
    return "addresses and networks in one string, separated by commas, or \"\" for an empty list";
  }
  std::string operator()(const BoxesTarget&) const {
    return "boxes such as -16,-16:16,16 in one string, separated by semicolons, or \"\" for an empty list";
  }
  std::string operator()(const SwitchTarget&) const { return "true or false"; }
  std::string operator()(const OriginsTarget&) const {
    return "origins such as https://play.example in one string, separated by commas, or \"*\", or \"\"";
  }
  std::string operator()(const UrlsTarget& target) const {
    return fmt::format(
        "a list such as [\"{}://HOST:PORT\"], in a variable separated by commas, or [] for an empty list",
        target.schemes.front());
  }
  std::string operator()(const WordTarget& target) const {
    return fmt::format("one of \"{}\"", fmt::join(target.words, "\", \""));
  }
  std::string operator()(const WordsTarget& target) const {
    return fmt::format("a list of \"{}\", in a variable separated by commas, or [] for an empty list",
                       fmt::join(target.words, "\", \""));
  }
  std::string operator()(const TextTarget&) const { return fmt::format("a {} in quotes", unit); }
};

}  // namespace

bool is_number(const Field& field) {
  return std::holds_alternative<NumberTarget>(field.target) ||
         std::holds_alternative<OptionalNumberTarget>(field.target) ||
         std::holds_alternative<PowerOfTwoTarget>(field.target) ||
         std::holds_alternative<DurationTarget>(field.target);
}

tl::expected<void, std::string> set_from_text(const Field& field, Config& config, std::string_view text) {
  return std::visit(AssignText{field, config, text}, field.target);
}

tl::expected<void, std::string> set_from_number(const Field& field, Config& config, std::int64_t number) {
  const std::string shown = fmt::to_string(number);
  if (number < 0 || !is_number(field)) return refused(field, shown);
  const auto value = static_cast<std::uint64_t>(number);
  if (const auto* target = std::get_if<NumberTarget>(&field.target)) {
    return assign_number(field, *target, config, value, shown);
  }
  if (const auto* target = std::get_if<OptionalNumberTarget>(&field.target)) {
    return assign_optional(field, *target, config, value, shown);
  }
  if (const auto* target = std::get_if<PowerOfTwoTarget>(&field.target)) {
    return assign_power_of_two(field, *target, config, value, shown);
  }
  return assign_number(field, std::get<DurationTarget>(field.target), config, value, shown);
}

std::string text_of(const Field& field, const Config& config) {
  Config copy = config;
  return std::visit(ShowText{copy}, field.target);
}

std::string expectation(const Field& field) {
  return std::visit(Describe{field.unit}, field.target);
}

}  // namespace talus::server
