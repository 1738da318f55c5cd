#include "commands/cluster/status.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "admin/top_command.h"
#include "cluster/jetstream/stream_admin.h"
#include "commands/cluster/formats_line.h"

namespace talus::server::cluster_tool {
namespace {

using namespace std::chrono_literals;

constexpr auto kLeaderPatience = 5s;  // while a leader is being elected
constexpr auto kPagePatience = 2000ms;
constexpr std::string_view kPrefix = "talus_cluster_";

nlohmann::ordered_json formats_json(const cluster::EnabledFormats& enabled) {
  nlohmann::ordered_json json{{"reads", cluster::kLogFormat},
                              {"understood", enabled.understood},
                              {"enabled", nlohmann::ordered_json::array()}};
  for (const cluster::EnabledFormat& each : enabled.list) {
    json["enabled"].push_back({{"format", each.number}, {"from", each.from}});
  }
  return json;
}

double in_seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>{time}.count();
}

}  // namespace

std::map<std::string, double> cluster_metrics(std::string_view page) {
  std::map<std::string, double> found;
  while (!page.empty()) {
    const std::string_view line = page.substr(0, page.find('\n'));
    page.remove_prefix(std::min(line.size() + 1, page.size()));
    const std::size_t space = line.find(' ');
    if (!line.starts_with(kPrefix) || space == std::string_view::npos) continue;
    if (line.find('{') != std::string_view::npos) continue;  // belongs to a histogram
    found.emplace(line.substr(kPrefix.size(), space - kPrefix.size()),
                  std::strtod(std::string{line.substr(space + 1)}.c_str(), nullptr));
  }
  return found;
}

tl::expected<ClusterStatus, std::string> read_status(const Target& target) {
  const auto connection = target.connect();
  if (!connection) return tl::unexpected{connection.error().reason};
  const auto until = std::chrono::steady_clock::now() + kLeaderPatience;
  for (;;) {
    auto info = ask_stream_info(**connection, target.names);
    if (!info) {
      const StreamFailure failure = failure_of(info.error(), target.names);
      if (failure.kind != StreamFailure::Kind::refused && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(kBetweenTries);
        continue;
      }
      return tl::unexpected{failure.reason};
    }
    ClusterStatus status{target.names.stream, to_string(target.store_id), *std::move(info), {}, {}};
    if (!target.admin) {
      status.not_here = "the settings have no operators' port (admin)";
      return status;
    }
    const auto page = fetch_page(*target.admin, "/metrics", kPagePatience);
    if (page) {
      status.here = cluster_metrics(*page);
      if (const auto ready = fetch_any_page(*target.admin, "/-/ready", kPagePatience)) {
        status.state = ready->text.substr(0, ready->text.find('\n'));
        status.ready = ready->status == 200;
      }
    } else {
      status.not_here = page.error();
    }
    return status;
  }
}

std::string status_lines(const ClusterStatus& status) {
  const jetstream::StreamInfo& info = status.info;
  std::string text = fmt::format("stream {}\n", status.stream);
  text += fmt::format("messages {} to {}, {} bytes", info.state.first, info.state.last, info.state.bytes);
  text += info.messages == 0 ? "\n" : fmt::format(", the oldest of {}\n", info.first_time);
  text += formats_line(info) + "\n";
  if (!info.leader.empty()) text += fmt::format("leader {}\n", info.leader);
  if (!has_majority(info)) text += "NO majority of its servers: the log takes no edits\n";
  for (const jetstream::ReplicaState& replica : info.replicas) {
    text += fmt::format("replica {}: {}, {} messages behind, last contact {:.1f} s ago\n", replica.name,
                        replica.offline   ? "offline"
                        : replica.current ? "current"
                                          : "not current",
                        replica.lag, in_seconds(replica.active));
  }
  if (!status.here) return text + fmt::format("this server: {}\n", status.not_here);
  const auto value = [&](const char* name) {
    const auto found = status.here->find(name);
    return found == status.here->end() ? 0.0 : found->second;
  };
  if (status.here->empty()) return text + "this server: runs, and is not in a cluster\n";
  text += fmt::format("this server: message {:.0f} applied, {:.0f} behind; {}, {}{}\n", value("sequence"),
                      value("lag_messages"), value("connected") > 0 ? "connected" : "NOT connected",
                      value("quorum") > 0 ? "the log takes edits" : "the log takes NO edits",
                      value("state_differs") > 0 ? "; its state DIFFERS from others'" : "");
  if (!status.state.empty()) {
    text += fmt::format("this server reports: {}{}\n", status.ready ? "" : "NOT ready: ", status.state);
  }
  if (const double skipped = value("messages_skipped_total"); skipped > 0) {
    text += fmt::format("this server passed over {:.0f} messages since its start that no talusd wrote\n",
                        skipped);
  }
  return text;
}

std::string status_json(const ClusterStatus& status) {
  const jetstream::StreamInfo& info = status.info;
  nlohmann::ordered_json json{{"stream", status.stream},
                              {"store", status.store},
                              {"first", info.state.first},
                              {"last", info.state.last},
                              {"created_ns", info.state.created_ns},
                              {"messages", info.messages},
                              {"bytes", info.state.bytes},
                              {"log_format", formats_json(info.state.enabled)},
                              {"leader", info.leader},
                              {"majority", has_majority(info)},
                              {"replicas", nlohmann::ordered_json::array()}};
  for (const jetstream::ReplicaState& replica : info.replicas) {
    json["replicas"].push_back({{"name", replica.name},
                                {"current", replica.current},
                                {"offline", replica.offline},
                                {"lag", replica.lag},
                                {"heard_s", in_seconds(replica.active)}});
  }
  json["server"] = nullptr;
  if (status.here) json["server"] = *status.here;
  json["ready"] = status.ready;
  json["says"] = status.state;
  return json.dump(2) + "\n";
}

}  // namespace talus::server::cluster_tool
