#include "cluster/jetstream/stream_info.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "cluster/jetstream/json_member.h"
#include "runtime/log/escape.h"

namespace talus::server::jetstream {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxReplicas = 16;

/// An answer to a message that no replica has then stored.
struct Refusal {
  int code = 0;
  std::string_view what;  // empty: whatever the answer says
  StreamFailure::Kind kind{};
};
// 10077 is the code of every failure to store, also of a disk. Its texts here are the limits of a stream
// whose `discard` is "new".
constexpr std::array kRefusals{
    Refusal{10054, "", StreamFailure::Kind::too_large},  // for the stream
    Refusal{10002, "", StreamFailure::Kind::rejected},   // the account is full
    Refusal{10023, "", StreamFailure::Kind::rejected},   // the servers are full
    Refusal{10077, "maximum messages exceeded", StreamFailure::Kind::rejected},
    Refusal{10077, "maximum bytes exceeded", StreamFailure::Kind::rejected},
    Refusal{10077, "maximum messages per subject exceeded", StreamFailure::Kind::rejected},
    Refusal{10109, "", StreamFailure::Kind::rejected},  // the stream is sealed
};

json object_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_object() ? *found : json::object();
}

}  // namespace

std::optional<std::int64_t> nanoseconds_of(const std::string& text) {
  std::tm time{};
  int read = 0;
  if (std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d%n", &time.tm_year, &time.tm_mon, &time.tm_mday,
                  &time.tm_hour, &time.tm_min, &time.tm_sec, &read) != 6) {
    return std::nullopt;
  }
  if (time.tm_year < 1970 || time.tm_year > 2261) return std::nullopt;  // range of 64 bits
  time.tm_year -= 1900;
  time.tm_mon -= 1;
  std::int64_t fraction = 0;
  auto at = static_cast<std::size_t>(read);
  if (at < text.size() && text[at] == '.') {
    ++at;
    for (std::int64_t unit = 100'000'000; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
      fraction += (text[at] - '0') * unit;
      unit /= 10;
    }
  }
  if (text.substr(at) != "Z") return std::nullopt;
  return static_cast<std::int64_t>(::timegm(&time)) * 1'000'000'000 + fraction;
}

tl::expected<json, ApiError> parse_answer(std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes) {
    return tl::unexpected{ApiError{0, fmt::format("the answer is over {} MiB", max_bytes >> 20U)}};
  }
  json answer = json::parse(text, nullptr, false);
  if (!answer.is_object()) return tl::unexpected{ApiError{0, "the answer is not a JSON object"}};
  if (const auto error = answer.find("error"); error != answer.end() && error->is_object()) {
    return tl::unexpected{ApiError{json_member<int>(*error, "err_code"),
                                   escaped(json_member<std::string>(*error, "description"), 300)}};
  }
  return answer;
}

tl::expected<StreamInfo, ApiError> parse_stream_info(std::string_view text) {
  const auto answer = parse_answer(text);
  if (!answer) return tl::unexpected{answer.error()};
  const json state = object_of(*answer, "state");
  const auto created = nanoseconds_of(json_member<std::string>(*answer, "created"));
  if (!created || !state.contains("last_seq")) {
    return tl::unexpected{ApiError{0, "the answer lacks the stream's state"}};
  }
  StreamInfo info;
  info.settings = object_of(*answer, "config");
  info.messages = json_member<std::uint64_t>(state, "messages");
  info.first_time = escaped(json_member<std::string>(state, "first_ts"));
  const auto last = json_member<std::uint64_t>(state, "last_seq");
  const std::uint64_t first = info.messages == 0 ? last + 1 : json_member<std::uint64_t>(state, "first_seq");
  const auto description = json_member<std::string>(info.settings, "description");
  info.description = escaped(description);
  info.state = {first, last, *created, json_member<std::uint64_t>(state, "bytes"),
                cluster::enabled_formats(description)};
  const json cluster = object_of(*answer, "cluster");
  info.leader = escaped(json_member<std::string>(cluster, "leader"));
  if (const auto replicas = cluster.find("replicas"); replicas != cluster.end() && replicas->is_array()) {
    for (const json& each : *replicas) {
      if (!each.is_object() || info.replicas.size() == kMaxReplicas) break;
      info.replicas.push_back({escaped(json_member<std::string>(each, "name")),
                               json_member<bool>(each, "current"), json_member<bool>(each, "offline"),
                               json_member<std::uint64_t>(each, "lag"),
                               std::chrono::nanoseconds{json_member<std::int64_t>(each, "active")}});
    }
  }
  return info;
}

tl::expected<std::uint64_t, ApiError> parse_unused(std::string_view text, std::uint64_t first) {
  constexpr std::size_t kMaxBytes = std::size_t{16} << 20U;  // over a million numbers
  const auto answer = parse_answer(text, kMaxBytes);
  if (!answer) return tl::unexpected{answer.error()};
  const json state = object_of(*answer, "state");
  const auto numbers = [](const json& object, const char* name) {
    std::set<std::uint64_t> all;
    const auto found = object.find(name);
    if (found == object.end() || !found->is_array()) return all;
    for (const json& each : *found) {
      if (each.is_number_unsigned()) all.insert(each.get<std::uint64_t>());
    }
    return all;
  };
  const auto deleted = numbers(state, "deleted");
  const auto lost = numbers(object_of(state, "lost"), "msgs");
  std::uint64_t unused = 0;
  while (deleted.contains(first + unused) && !lost.contains(first + unused)) ++unused;
  return unused;
}

bool has_majority(const StreamInfo& info) {
  constexpr std::chrono::seconds kSilent{5};  // five heartbeats
  if (info.leader.empty() && !info.replicas.empty()) return false;
  const auto heard = std::ranges::count_if(
      info.replicas, [&](const ReplicaState& each) { return !each.offline && each.active < kSilent; });
  return 2 * (1 + static_cast<std::size_t>(heard)) > 1 + info.replicas.size();
}

StreamFailure::Kind kind_of_refusal(const ApiError& error) {
  const auto* const found = std::ranges::find_if(kRefusals, [&](const Refusal& each) {
    return each.code == error.code && (each.what.empty() || each.what == error.what);
  });
  return found == kRefusals.end() ? StreamFailure::Kind::unavailable : found->kind;
}

StreamFailure failure_of(const ApiError& error, std::string_view stream) {
  using Kind = StreamFailure::Kind;
  switch (error.code) {
    case kStreamNotFound:
      return {Kind::refused,
              fmt::format("NATS has no stream {}; name the NATS servers that have it in cluster.nats. If it "
                          "was never made: \"talusd cluster init\" for a new world, \"talusd store "
                          "join-cluster\" for a store that has edits. If it was lost: \"talusd store fork\" "
                          "at the server that is furthest; do not make it anew",
                          stream)};
    case kNotEnabled:
    case kNotEnabledForAccount:
      return {Kind::refused,
              fmt::format("NATS: {}; switch JetStream on at these servers and for this user's account",
                          error.what)};
    default:
      return {Kind::unavailable, fmt::format("NATS: {}: {}", stream, error.what)};
  }
}

}  // namespace talus::server::jetstream
