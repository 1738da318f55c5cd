#include "jetstream/leader_scout.h"

#include <algorithm>
#include <utility>

#include "jetstream/connection.h"
#include "jetstream/inbox.h"
#include "jetstream/stored_message.h"
#include "jetstream/stream_info.h"
#include "random/random_number.h"

namespace talus::server::jetstream {

LeaderScout::LeaderScout(ServerUrls urls, std::shared_ptr<const Credentials> credentials, StreamNames names)
    : urls_{std::move(urls)},
      credentials_{std::move(credentials)},
      names_{std::move(names)},
      next_{static_cast<std::size_t>(random_number() % urls_.size())} {}  // not all go to one

std::optional<ServerUrls> LeaderScout::look() {
  const auto until = std::chrono::steady_clock::now() + kPatience;
  for (std::size_t asked = 0; asked < urls_.size() && std::chrono::steady_clock::now() < until; ++asked) {
    ServerUrls server = urls_.just(next_);
    next_ = (next_ + 1) % urls_.size();
    if (answers_by(server)) return server;
  }
  return std::nullopt;
}

bool LeaderScout::answers_by(const ServerUrls& server) const {
  const auto connection = Connection::open(server, credentials_, nullptr, Retry::never);
  if (!connection) return false;
  const auto reply = (*connection)->request(names_.info(), "", kAnswerPatience);
  if (!reply) return false;
  const auto info = parse_stream_info(Arrived{reply->get()}.text());
  if (!info || !has_majority(*info)) return false;
  const auto message =
      (*connection)
          ->request(names_.message_get(),
                    StreamNames::by_number(std::max<std::uint64_t>(info->state.last, 1)), kAnswerPatience);
  return message && is_of_messages(parse_stored_message(Arrived{message->get()}.text()));
}

}  // namespace talus::server::jetstream
