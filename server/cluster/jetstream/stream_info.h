// What the leader of a stream says of it ($JS.API.STREAM.INFO). Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "cluster/log_stream.h"

namespace talus::server::jetstream {

/// Since 1970, of "2026-11-26T04:18:20.123456789Z", as NATS writes times; nothing where it is none.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of(const std::string& text);

struct ReplicaState {
  std::string name;
  bool current = false;
  bool offline = false;
  std::uint64_t lag = 0;               // messages
  std::chrono::nanoseconds active{0};  // since it was heard of
};

struct StreamInfo {
  StreamState state;
  std::uint64_t messages = 0;
  std::string first_time;  // of the oldest message, RFC 3339
  nlohmann::json settings;
  std::string description;             // of the settings; for people: state.enabled is what it says
  std::string leader;                  // empty: there is none, or there is one server
  std::vector<ReplicaState> replicas;  // without the leader
};

/// Whether the leader has heard of a majority, itself among it, in the last seconds: one that has lost the
/// others answers on for a while, and takes nothing.
[[nodiscard]] bool has_majority(const StreamInfo& info);

/// JetStream's error codes (server/errors.json of nats-server).
inline constexpr int kMessageNotFound = 10037;
inline constexpr int kStreamNotFound = 10059;
inline constexpr int kNotEnabledForAccount = 10039;
inline constexpr int kNotEnabled = 10076;

/// An answer that says no.
struct ApiError {
  int code = 0;  // JetStream's; 0: the answer is not what JetStream answers
  std::string what;
};

/// JetStream's answers are not longer.
inline constexpr std::size_t kMostAnswerBytes = 1U << 20;

/// The object of an answer of JetStream, or the error in it.
[[nodiscard]] tl::expected<nlohmann::json, ApiError> parse_answer(std::string_view text);

[[nodiscard]] tl::expected<StreamInfo, ApiError> parse_stream_info(std::string_view text);

/// Whether a person has to act.
[[nodiscard]] StreamFailure failure_of(const ApiError& error, std::string_view stream);

}  // namespace talus::server::jetstream
