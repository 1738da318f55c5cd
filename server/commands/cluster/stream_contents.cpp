#include "commands/cluster/stream_contents.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_admin.h"

namespace talus::server::cluster_tool {
namespace {

using namespace std::chrono_literals;

constexpr auto kMessagePatience = 500ms;
constexpr int kMaxTries = 20;  // while a leader is being elected
constexpr std::size_t kMaxUnreadMessages = 10;

/// Returns the message; nullopt if the stream no longer keeps it.
tl::expected<std::optional<jetstream::StoredMessage>, std::string> message_of(
    jetstream::Connection& connection, const Target& target, std::uint64_t sequence) {
  std::string why;
  for (int asked = 0; asked < kMaxTries; ++asked) {
    if (asked > 0) std::this_thread::sleep_for(kBetweenTries);
    auto reply = connection.request(target.names.message_get(), jetstream::StreamNames::by_number(sequence),
                                    kMessagePatience);
    if (!reply) {
      why = reply.error().reason;
      if (reply.error().kind == StreamFailure::Kind::refused) break;
      continue;
    }
    auto message = jetstream::parse_stored_message(jetstream::ReceivedMessage{reply->get()}.text());
    if (message && message->sequence == sequence) return *std::move(message);
    if (message) {
      why = fmt::format("the answer is message {}", message->sequence);
      continue;
    }
    why = message.error().what;
    if (message.error().code != jetstream::kMessageNotFound) continue;
    const auto info = ask_stream_info(connection, target.names);
    if (info && info->state.first > sequence) return std::nullopt;
  }
  return tl::unexpected{fmt::format("{}: message {}: {}", target.names.stream, sequence, why)};
}

}  // namespace

tl::expected<Contents, std::string> read_contents(
    jetstream::Connection& connection, const Target& target, const store::StoreIdentity& identity,
    std::uint64_t max_messages, const std::function<void(std::uint64_t done, std::uint64_t all)>& on_read) {
  const auto info = ask_stream_info(connection, target.names);
  if (!info) return tl::unexpected{failure_of(info.error(), target.names).reason};
  const StreamState state = info->state;
  Contents contents;
  contents.last = state.last;
  contents.enabled = state.enabled;
  contents.first = std::max(state.first, state.last - std::min(state.last, max_messages) + 1);
  for (std::uint64_t sequence = contents.first; sequence <= state.last; ++sequence) {
    const auto message = message_of(connection, target, sequence);
    if (!message) return tl::unexpected{message.error()};
    if (*message) {
      auto fault = cluster::fault_of((*message)->bytes, sequence, identity);
      if (fault) {
        ++contents.unread_count;
        if (contents.unread.size() < kMaxUnreadMessages)
          contents.unread.push_back({sequence, *std::move(fault)});
      }
    }
    on_read(sequence - contents.first + 1, state.last - contents.first + 1);
  }
  return contents;
}

}  // namespace talus::server::cluster_tool
