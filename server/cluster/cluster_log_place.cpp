// Finds the message at which a store continues in the stream.
#include <fmt/format.h>

#include "cluster/cluster_log.h"
#include "cluster/last_message.h"
#include "cluster/log_reasons.h"
#include "cluster/message.h"

namespace talus::server::cluster {
namespace {

using std::chrono::milliseconds;
using SteadyClock = std::chrono::steady_clock;

}  // namespace

bool ClusterLog::find_place() {
  const auto stream = parts_.stream.state();
  if (!stream) {
    trouble(stream.error().reason);
    return false;
  }
  const store::StreamPlace place = parts_.database.meta().stream;
  if (stream->last == 0) {
    trouble("the stream has no genesis; run talusd cluster init");
    const std::lock_guard lock{mutex_};
    began_silent_ = false;  // it answered, but an empty stream is not worth waiting for
    return false;
  }
  if (place.sequence == 0) {
    if (!begin_at_genesis(*stream)) return false;
  } else if (place.created_ns != stream->created_ns) {
    lose(StoreLoss::other, kMadeAnew);
    return false;
  } else if (stream->first > place.sequence + 1) {
    lose(StoreLoss::too_old,
         fmt::format("the stream keeps messages from {} on, and this server has messages up to {}",
                     stream->first, place.sequence));
    return false;
  } else if (!is_as_applied(*stream, place)) {
    return false;
  }
  const store::StreamPlace now = parts_.database.meta().stream;
  placed_ = true;
  {
    const std::lock_guard lock{mutex_};
    places_known_ = true;
    created_ns_ = now.created_ns;
    sequence_ = now.sequence;
    end_.applied(now.sequence);
    trouble_.clear();
  }
  const edits::Head& head = parts_.state.head();
  comparison_.stands(head.revision, head.hash);
  parts_.log->info("cluster: continues after message {} of {}", now.sequence, stream->last);
  tell_whether_it_takes();
  return true;
}

bool ClusterLog::is_as_applied(const StreamState& stream, const store::StreamPlace& place) {
  if (stream.last < place.sequence) {
    trouble(kShorter);  // the watching thread decides if that is permanent
    return false;
  }
  const auto last = compare_last_message(parts_.stream, stream, place);
  if (!last) {
    cannot_get(last.error());
    return false;
  }
  if (*last != LastMessage::other) return true;
  const std::string reason = fmt::format(
      "message {} of the stream is another than the one that this server has applied: the stream "
      "lost its end, and went on without it",
      place.sequence);
  trouble(reason);
  // A faulty replica may have answered; the next request may reach another.
  const auto now = SteadyClock::now();
  if (!other_since_) other_since_ = now;
  if (now - *other_since_ > settings_.sure_of_other) lose(StoreLoss::other, reason);
  return false;
}

bool ClusterLog::begin_at_genesis(const StreamState& stream) {
  const edits::Head& own = parts_.state.head();
  const bool is_empty = own.position == 0;
  if (stream.first > 1) {
    lose(is_empty ? StoreLoss::no_start : StoreLoss::too_old,
         fmt::format("the stream keeps messages from {} on, and this server has no message of it",
                     stream.first));
    return false;
  }
  const auto first = parts_.stream.next(0, SteadyClock::now() + milliseconds{500});
  if (!first || !*first) {
    trouble(first ? "the stream's first message does not arrive" : first.error().reason);
    return false;
  }
  const auto genesis = decode_genesis((*first)->bytes);
  if (!genesis) {
    const MessageFault& fault = genesis.error();
    if (came_damaged(**first, fault.reason)) return false;
    stop_applying(not_applied(1, fmt::format("{}{}", fault.reason, remedy_of(fault))));
    return false;
  }
  if (genesis->identity.store_id != identity_.store_id) {
    stop_applying(fmt::format("the stream is of store {}; this server has store {}",
                              to_string(genesis->identity.store_id), to_string(identity_.store_id)));
  } else if (genesis->identity.fingerprint != identity_.fingerprint) {
    stop_applying(
        fmt::format("the stream is of the world with fingerprint {}; this server's world has {}; "
                    "all servers of a store must have the same world and secret.key_file",
                    to_string(genesis->identity.fingerprint), to_string(identity_.fingerprint)));
  } else if (genesis->level_rule != edits::kLevelRule) {
    stop_applying(
        fmt::format("the stream's coarse levels are made by rule {}; this talusd has rule {}; all "
                    "servers of a store must have the same",
                    genesis->level_rule, edits::kLevelRule));
  } else if (settings_.settles != nullptr && *settings_.settles != genesis->settles) {
    stop_applying(
        "loose material slides differently in this world and the stream's; all servers of a store must have "
        "the same world");
  } else if (genesis->head != own) {
    lose(is_empty ? StoreLoss::no_start : StoreLoss::other,
         fmt::format("the stream begins at revision {}, entry {}; this server's store is at revision {}, "
                     "entry {}",
                     genesis->head.revision, genesis->head.position, own.revision, own.position));
  } else {
    store::EditDatabase::Status entered;
    if (is_empty && !genesis->materials.empty()) entered = parts_.database.bind(genesis->materials);
    if (entered) entered = parts_.database.enter({1, stream.created_ns, 0, hash_of_message((*first)->bytes)});
    writer_.entered();
    if (entered) return true;
    trouble(entered.error());
  }
  return false;
}
}  // namespace talus::server::cluster
