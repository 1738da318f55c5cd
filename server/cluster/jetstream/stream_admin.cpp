#include "cluster/jetstream/stream_admin.h"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "cluster/jetstream/stream_settings.h"

namespace talus::server::jetstream {
namespace {

constexpr std::chrono::milliseconds kAnswerIn{500};
// JetStream places replicas and waits for their votes.
constexpr std::chrono::milliseconds kMadeIn{10'000};
constexpr std::chrono::seconds kPresentIn{15};
constexpr std::chrono::milliseconds kBetweenTries{100};
constexpr int kNoPlaceForReplicas = 10005;  // too few NATS servers exist or are known yet
constexpr int kNoStorage = 10047;
constexpr int kNoStorageInCluster = 10023;

std::string reason_of(const StreamError& error, const StreamNames& names, std::uint64_t replicas) {
  std::string reason = failure_of(error, names).reason;
  const auto* const said = std::get_if<ApiError>(&error);
  if (said == nullptr) return reason;
  if (said->code == kNoPlaceForReplicas) {
    reason += fmt::format("; cluster.replicas is {}: it needs that number of NATS servers with JetStream",
                          replicas);
  }
  if (said->code == kNoStorage || said->code == kNoStorageInCluster) {
    reason +=
        "; the log may grow to 16 GiB: each NATS server's jetstream max_file_store must have room for it";
  }
  return reason;
}

}  // namespace

StreamFailure failure_of(const StreamError& error, const StreamNames& names) {
  if (const auto* const failure = std::get_if<StreamFailure>(&error)) return *failure;
  return failure_of(std::get<ApiError>(error), names.stream);
}

tl::expected<StreamInfo, StreamError> ask_stream_info(Connection& connection, const StreamNames& names) {
  const auto reply = connection.request(names.info(), "", kAnswerIn);
  if (!reply) return tl::unexpected{StreamError{reply.error()}};
  auto info = parse_stream_info(ReceivedMessage{reply->get()}.text());
  if (!info) return tl::unexpected{StreamError{info.error()}};
  return *std::move(info);
}

tl::expected<StreamInfo, StreamError> make_stream(Connection& connection, const StreamNames& names,
                                                  std::uint64_t replicas) {
  const std::string settings = wanted_settings(names, replicas).dump();
  const auto reply = connection.request("$JS.API.STREAM.CREATE." + names.stream, settings, kMadeIn);
  if (!reply) return tl::unexpected{StreamError{reply.error()}};
  const auto made = parse_answer(ReceivedMessage{reply->get()}.text());
  if (!made) return tl::unexpected{StreamError{made.error()}};
  return ask_stream_info(connection, names);
}

tl::expected<PresentStream, std::string> ensure_stream(Connection& connection, const StreamNames& names,
                                                       std::uint64_t replicas) {
  const auto until = std::chrono::steady_clock::now() + kPresentIn;
  for (;;) {
    auto found = ask_stream_info(connection, names);
    const auto* const said = found ? nullptr : std::get_if<ApiError>(&found.error());
    const bool makes = said != nullptr && said->code == kStreamNotFound;
    if (makes) found = make_stream(connection, names, replicas);
    if (found) {
      if (auto other = other_settings(found->settings, names, replicas))
        return tl::unexpected{*std::move(other)};
      return PresentStream{*std::move(found), makes};
    }
    // A cluster that has just started answers after a while.
    const bool for_a_person = failure_of(found.error(), names).kind == StreamFailure::Kind::refused;
    if (for_a_person || std::chrono::steady_clock::now() > until) {
      return tl::unexpected{reason_of(found.error(), names, replicas)};
    }
    std::this_thread::sleep_for(kBetweenTries);
  }
}

}  // namespace talus::server::jetstream
