#include "cluster/jetstream/stream_settings.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "cluster/jetstream/json_member.h"

namespace talus::server::jetstream {
namespace {

constexpr std::int64_t kMaxAgeNs = 7LL * 24 * 3600 * 1'000'000'000;
constexpr std::int64_t kMaxBytes = 16LL << 30;
/// Returns true for a setting that no update of a stream changes, or takes back.
bool is_fixed(const SettingDifference& difference, const nlohmann::json& present) {
  constexpr std::array<std::string_view, 3> kFixed{"mirror", "storage", "sealed"};
  if (difference.name == "retention") return json_member<std::string>(present, "retention") == "workqueue";
  return std::ranges::find(kFixed, difference.name) != kFixed.end();
}

/// Formats as ASCII on one line, with a length limit.
std::string shown(const nlohmann::json& value) {
  constexpr std::size_t kMaxShownLength = 200;
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > kMaxShownLength) text.replace(kMaxShownLength, text.npos, "...");
  return text;
}

}  // namespace

nlohmann::json wanted_settings(const StreamNames& names, std::uint64_t replicas) {
  return {
      {"name", names.stream},
      {"subjects", {names.log}},
      {"retention", "limits"},
      {"storage", "file"},
      {"num_replicas", replicas},
      {"discard", "old"},
      {"max_age", kMaxAgeNs},
      {"max_bytes", kMaxBytes},
      {"max_msgs", -1},
      {"max_msgs_per_subject", -1},
      {"max_msg_size", kStreamMessageBytes},
      {"allow_direct", true},
      {"deny_delete", true},
      {"deny_purge", true},
      {"republish", {{"src", names.log}, {"dest", names.tail}}},
  };
}

std::vector<SettingDifference> differences(const nlohmann::json& present, const nlohmann::json& wanted) {
  std::vector<SettingDifference> found;
  // A stream with one of these is another's, whatever else differs.
  for (const char* const name : {"mirror", "sources", "subject_transform"}) {
    if (present.contains(name) && !present[name].is_null()) {
      found.push_back({name, shown(present[name]), "null"});
    }
  }
  for (const auto& [name, should] : wanted.items()) {
    // NATS omits false values.
    const nlohmann::json is =
        present.value(name, should.is_boolean() ? nlohmann::json(false) : nlohmann::json());
    if (is != should) found.push_back({name, shown(is), shown(should)});
  }
  // Other settings that remove or alter messages.
  for (const char* const name : {"sealed", "allow_rollup_hdrs", "no_ack"}) {
    if (json_member<bool>(present, name)) found.push_back({name, "true", "false"});
  }
  return found;
}

std::optional<std::string> other_settings(const nlohmann::json& present, const StreamNames& names,
                                          std::uint64_t replicas) {
  const auto others = differences(present, wanted_settings(names, replicas));
  if (others.empty()) return std::nullopt;
  const auto fixed = std::ranges::find_if(others, [&](const auto& each) { return is_fixed(each, present); });
  if (fixed != others.end()) {
    return fmt::format(
        "{} is there with other settings: {}, which NATS cannot change in a stream; name other NATS servers "
        "in cluster.nats, or delete the stream if it holds no edits; if it holds some, make a new one "
        "(CLUSTER.md, \"A new stream\")",
        names.stream, to_string(*fixed));
  }
  return fmt::format("{} is there with other settings: {}; change {} by the program nats", names.stream,
                     to_string(others.front()),
                     others.front().name == "num_replicas" ? "cluster.replicas, or it" : "it");
}

std::optional<std::string> small_payload(std::int64_t max_payload) {
  if (max_payload >= kStreamMessageBytes) return std::nullopt;
  return fmt::format(
      "max_payload of nats-server is {} and should be at least {}; raise it in its configuration",
      max_payload, kStreamMessageBytes);
}

std::string to_string(const SettingDifference& difference) {
  return fmt::format("{} is {} and should be {}", difference.name, difference.is, difference.should);
}

}  // namespace talus::server::jetstream
