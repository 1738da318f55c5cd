#include "commands/store/cluster_moves.h"

#include <fmt/format.h>

#include <talus/store/store_swap.h>
#include <talus/store/whole_store.h>

#include "cluster/join/enter_cluster.h"
#include "cluster/join/prepare_store.h"
#include "config/cluster_check.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;
using Text = tl::expected<std::string, std::string>;

tl::expected<void, std::string> check_nats(const Cluster& settings) {
  if (settings.wanted()) return check_cluster(settings);
  return tl::unexpected{std::string{
      "cluster.nats: no NATS server is named; give --config the file that the cluster's servers have"}};
}

/// A store's distance from the end of its stream, if known.
struct Behind {
  bool known = false;
  std::uint64_t messages = 0;
  std::string text;  // part of a sentence
};

Behind measure(const store::StoreMeta& meta, const Cluster& settings, const ClusterTools& tools) {
  const auto unknown = [](const std::string& why) {
    return Behind{false, 0, fmt::format("its distance behind the stream is unknown: {}", why)};
  };
  if (!settings.wanted()) return unknown("cluster.nats names no NATS server");
  const auto stream = tools.open(settings, meta.store_id, false);
  if (!stream) return unknown(stream.error());
  const auto state = (*stream)->state();
  if (!state) return unknown(state.error().reason);
  if (state->created_ns != meta.stream.created_ns) {
    return unknown("the stream was made anew; it is not the one that this store has read");
  }
  if (state->last < meta.stream.sequence) {
    return {true, 0,
            fmt::format("the stream has lost its end: it goes up to message {}, this store to {}",
                        state->last, meta.stream.sequence)};
  }
  const std::uint64_t behind = state->last - meta.stream.sequence;
  if (behind == 0) return {true, 0, "it has all that the stream has"};
  return {true, behind,
          fmt::format("the stream has {} message{} more, whose edits are not in it; to have them, start "
                      "talusd in the cluster "
                      "until it has read them, before it leaves",
                      behind, behind == 1 ? "" : "s")};
}

tl::expected<store::StoreMeta, std::string> place_of_member(const store::DataDirectory& directory) {
  auto meta = join::read_place(directory.path());
  if (!meta || meta->stream.sequence != 0) return meta;
  return tl::unexpected{fmt::format("data {}: its store is not in a cluster", directory.path().string())};
}

std::string place_of(const store::StoreMeta& meta) {
  return fmt::format("position {}, revision {}, hash {}", meta.head.position, meta.head.revision,
                     edits::to_string(meta.head.hash));
}

tl::expected<void, std::string> check_world(const store::DataDirectory& directory,
                                            const terrain::World& world) {
  if (!directory.identity() || directory.identity()->fingerprint == world.fingerprint()) return {};
  return tl::unexpected{fmt::format(
      "data {}: the store is of the world with fingerprint {}; --world has {}; give the store's world",
      directory.path().string(), to_string(directory.identity()->fingerprint),
      to_string(world.fingerprint()))};
}

std::string of_beginning(const fs::path& path, const store::StoreMeta& entered) {
  const std::string id = to_string(entered.store_id);
  return fmt::format(
      "{}: store {} begins its cluster's stream at {}\n"
      "set cluster.store = \"{}\" on all servers, start this one first, and let the others, with empty data "
      "directories, name it in cluster.peers\n",
      path.string(), id, place_of(entered), id);
}

/// Builds the copy with the new id in staging, so that a crash leaves either store whole.
tl::expected<fs::path, std::string> stage_with_id(const fs::path& path, ContentHash id) {
  const auto staging = store::stage_copy(path);
  if (!staging) return staging;
  if (const auto given = store::give_identity(*staging, id); !given) return tl::unexpected{given.error()};
  return *staging;
}

/// Makes the staged store, which has the same edits, the directory's. `if_not` ends the error if that fails.
tl::expected<void, std::string> put_in_place(const fs::path& path, std::string_view if_not) {
  const auto swapped = store::swap_in(path, store::ReplacedStore::goes);
  if (swapped) return {};
  if (!store::swap_is_begun(path)) return tl::unexpected{fmt::format("{}{}", swapped.error(), if_not)};
  return tl::unexpected{
      fmt::format("{}; the new store counts already: \"talusd store stat\" ends its move into place, and "
                  "prints its id",
                  swapped.error())};
}

}  // namespace

Text join_cluster(const store::DataDirectory& directory, const Cluster& settings, const terrain::World& world,
                  const ClusterTools& tools) {
  if (auto known = check_nats(settings); !known) return tl::unexpected{known.error()};
  if (auto right = check_world(directory, world); !right) return tl::unexpected{right.error()};
  const std::string id = to_string(directory.store_id());
  if (!settings.store.empty() && settings.store != id) {
    return tl::unexpected{
        fmt::format("cluster.store: it names store {}, and {} has store {}; name that, or \"\"",
                    settings.store, directory.path().string(), id)};
  }
  // Fails before a stream is created, or reported as one to delete.
  if (const auto place = join::read_place(directory.path()); !place) return tl::unexpected{place.error()};
  const auto stream = tools.open(settings, directory.store_id(), true);
  if (!stream) return tl::unexpected{stream.error()};
  const auto entered = join::enter_cluster(directory.path(), tools.settle_rules(world), **stream);
  if (!entered) return tl::unexpected{entered.error()};
  if (const auto forgotten = join::forget_rejoin(directory.path()); !forgotten)
    return tl::unexpected{forgotten.error()};
  return of_beginning(directory.path(), *entered);
}

Text leave_cluster(const store::DataDirectory& directory, const Cluster& settings, const ClusterTools& tools,
                   bool keeps_id, bool confirmed) {
  const auto meta = place_of_member(directory);
  if (!meta) return tl::unexpected{meta.error()};
  const Behind behind = measure(*meta, settings, tools);
  if (!confirmed) {
    return tl::unexpected{fmt::format(
        "nothing is changed yet: the store would be this machine's alone from {} on; {}; give --yes to do it",
        place_of(*meta), behind.text)};
  }
  const ContentHash id = keeps_id ? meta->store_id : store::random_store_id();
  if (keeps_id) {
    if (const auto left = store::enter_stream(directory.path(), {}); !left)
      return tl::unexpected{left.error()};
    if (const auto forgotten = join::forget_rejoin(directory.path()); !forgotten)
      return tl::unexpected{forgotten.error()};
  } else {
    const auto staging = stage_with_id(directory.path(), id);
    if (!staging) return tl::unexpected{staging.error()};
    if (const auto put = put_in_place(directory.path(), ""); !put) return tl::unexpected{put.error()};
  }
  return fmt::format(
      "{}: store {} is this machine's alone, at {}; {}\nset cluster.nats = \"\" before talusd is started\n",
      directory.path().string(), to_string(id), place_of(*meta), behind.text);
}

Text fork_cluster(const store::DataDirectory& directory, const Cluster& settings, const terrain::World& world,
                  const ClusterTools& tools, bool confirmed) {
  if (auto known = check_nats(settings); !known) return tl::unexpected{known.error()};
  if (auto right = check_world(directory, world); !right) return tl::unexpected{right.error()};
  const auto meta = place_of_member(directory);
  if (!meta) return tl::unexpected{meta.error()};
  const Behind behind = measure(*meta, settings, tools);
  if (!confirmed) {
    return tl::unexpected{fmt::format(
        "nothing is changed yet: this store, at {}, would become another one with a stream of its own; {}; "
        "every other server of the cluster has to take it from here with an empty data directory, and edits "
        "after this place, though acknowledged to players, are lost; do it only if the old stream is lost "
        "for good, on the server whose \"talusd store stat\" has the greatest position, and give --yes",
        place_of(*meta), behind.text)};
  }
  const ContentHash id = store::random_store_id();
  // Steps that may fail temporarily come first, while the store is unchanged.
  const auto stream = tools.open(settings, id, true);
  if (!stream) {
    return tl::unexpected{
        fmt::format("nothing is changed: the new stream cannot be made: {}", stream.error())};
  }
  const std::string if_not = fmt::format(
      "; the store is what it was, and the stream TALUS_{} is not used: it may be deleted in NATS",
      to_string(id));
  const auto staging = stage_with_id(directory.path(), id);
  if (!staging) return tl::unexpected{staging.error() + if_not};
  const auto entered = join::enter_cluster(*staging, tools.settle_rules(world), **stream);
  if (!entered) return tl::unexpected{entered.error() + if_not};
  if (const auto put = put_in_place(directory.path(), if_not); !put) return tl::unexpected{put.error()};
  return of_beginning(directory.path(), *entered);
}

}  // namespace talus::server
