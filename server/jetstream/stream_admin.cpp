#include "jetstream/stream_admin.h"

#include <chrono>

#include <fmt/format.h>

#include "jetstream/stream_settings.h"

namespace talus::server::jetstream {
namespace {

constexpr std::chrono::milliseconds kAnswerIn{500};
// JetStream places replicas and waits for their vote.
constexpr std::chrono::milliseconds kMadeIn{10'000};

}  // namespace

StreamFailure failure_of(const StreamError& error, const StreamNames& names) {
  if (const auto* const failure = std::get_if<StreamFailure>(&error)) return *failure;
  return failure_of(std::get<ApiError>(error), names.stream);
}

tl::expected<StreamInfo, StreamError> ask_stream_info(Connection& connection, const StreamNames& names) {
  const auto reply = connection.request(names.info_subject(), "", kAnswerIn);
  if (!reply) return tl::unexpected{StreamError{reply.error()}};
  auto info = parse_stream_info(Arrived{reply->get()}.text());
  if (!info) return tl::unexpected{StreamError{info.error()}};
  return *std::move(info);
}

tl::expected<StreamInfo, StreamError> make_stream(Connection& connection, const StreamNames& names,
                                                  std::uint64_t replicas) {
  const std::string settings = wanted_settings(names, replicas).dump();
  const auto reply = connection.request("$JS.API.STREAM.CREATE." + names.stream, settings, kMadeIn);
  if (!reply) return tl::unexpected{StreamError{reply.error()}};
  const auto made = parse_answer(Arrived{reply->get()}.text());
  if (!made) return tl::unexpected{StreamError{made.error()}};
  return ask_stream_info(connection, names);
}

}  // namespace talus::server::jetstream
