// A stream leader's answer to a request for the stream's state ($JS.API.STREAM.INFO). Pure.
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

/// Parses "2026-11-26T04:18:20.123456789Z", NATS' time format, since 1970; nullopt if malformed.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of(const std::string& text);

struct ReplicaState {
  std::string name;
  bool current = false;
  bool offline = false;
  std::uint64_t lag = 0;               // messages
  std::chrono::nanoseconds active{0};  // since its last sign of life
};

struct StreamInfo {
  StreamState state;
  std::uint64_t messages = 0;
  std::string first_time;  // the oldest message's, RFC 3339
  nlohmann::json settings;
  std::string description;             // of the settings; parsed into state.enabled
  std::string leader;                  // empty: no leader, or a single server
  std::vector<ReplicaState> replicas;  // except the leader
};

/// True if the leader was in contact with a majority, including itself, in the last seconds: a leader cut off
/// from the others answers for a while, but accepts nothing.
[[nodiscard]] bool has_majority(const StreamInfo& info);

/// JetStream's error codes (server/errors.json of nats-server).
inline constexpr int kMessageNotFound = 10037;
inline constexpr int kStreamNotFound = 10059;
inline constexpr int kNotEnabledForAccount = 10039;
inline constexpr int kNotEnabled = 10076;

/// A negative answer.
struct ApiError {
  int code = 0;  // JetStream's; 0: not an answer of JetStream
  std::string what;
};

/// Maximum size of JetStream's answers.
inline constexpr std::size_t kMaxApiAnswerBytes = 1U << 20;

/// Returns the object of a JetStream answer, or the error in it.
[[nodiscard]] tl::expected<nlohmann::json, ApiError> parse_answer(std::string_view text,
                                                                  std::size_t max_bytes = kMaxApiAnswerBytes);

[[nodiscard]] tl::expected<StreamInfo, ApiError> parse_stream_info(std::string_view text);
/// How many numbers from `first` on have no message, by an answer that lists them; 0 if a message of that
/// number was lost.
[[nodiscard]] tl::expected<std::uint64_t, ApiError> parse_unused(std::string_view text, std::uint64_t first);

/// Why publish() fails if JetStream answers this. After `unavailable` the message may be stored.
[[nodiscard]] StreamFailure::Kind kind_of_refusal(const ApiError& error);

/// The kind is `refused` if an operator must act.
[[nodiscard]] StreamFailure failure_of(const ApiError& error, std::string_view stream);

}  // namespace talus::server::jetstream
