// Lenient access to JSON from NATS: a member that is missing or has another type is treated as absent.
#pragma once

#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace talus::server::jetstream {

/// Returns the member, or a default value if it is missing or has another type.
template <typename Value>
[[nodiscard]] Value json_member(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return {};
  if constexpr (std::is_same_v<Value, std::string>) {
    return found->is_string() ? found->template get<std::string>() : Value{};
  } else if constexpr (std::is_same_v<Value, bool>) {
    return found->is_boolean() && found->template get<bool>();
  } else {
    return found->is_number_integer() ? found->template get<Value>() : Value{};
  }
}

}  // namespace talus::server::jetstream
