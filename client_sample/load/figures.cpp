#include "figures.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace talus::load {
namespace {

struct Percentile {
  const char* name;
  double part;
};
constexpr std::array kPercentiles{Percentile{"p50_ms", 0.5}, Percentile{"p95_ms", 0.95},
                                  Percentile{"p99_ms", 0.99}, Percentile{"p99_9_ms", 0.999}};

// Prefixes of the percentiles: all chunks, those of joins, those of travel, and so on.
constexpr std::array kSpreads{"",           "join_",        "travel_", "request_", "first_chunk_",
                              "full_view_", "harness_late_"};
constexpr std::array kSingles{"chunks_per_s",
                              "bytes_per_s",
                              "chunk_messages_per_s",
                              "late_steps_max",
                              "late_over_one_step",
                              "wrong",
                              "errors",
                              "disconnects",
                              "unanswered",
                              "missed",
                              "out_of_order",
                              "worst_ring_gap",
                              "joins",
                              "cuts",
                              "slow_errors",
                              "slow_disconnects",
                              "greedy_errors",
                              "greedy_chunks",
                              "cpu_s",
                              "cpu_s_per_million",
                              "cpu_s_per_million_messages",
                              "harness_cpu_s",
                              "resident_bytes",
                              "resident_growth_percent",
                              "idle_bytes_each",
                              "files_left"};

void put_spread(Figures& figures, const std::string& prefix, const Histogram& waits) {
  if (waits.count() == 0) return;
  for (const Percentile& percentile : kPercentiles) {
    figures[prefix + percentile.name] = waits.percentile_ms(percentile.part);
  }
  figures[prefix + "max_ms"] = waits.max_ms();
}

void put_server(Figures& figures, const Outcome& outcome) {
  const ServerSample& from = outcome.begin.server;
  const ServerSample& to = outcome.end.server;
  if (from.cpu_seconds && to.cpu_seconds) {
    const double cpu = *to.cpu_seconds - *from.cpu_seconds;
    const auto messages = static_cast<double>(outcome.end.chunks - outcome.begin.chunks);
    const double chunks = messages + static_cast<double>(outcome.end.uniform - outcome.begin.uniform);
    figures["cpu_s"] = cpu;
    if (chunks > 0) figures["cpu_s_per_million"] = cpu / chunks * 1e6;
    if (messages > 0) figures["cpu_s_per_million_messages"] = cpu / messages * 1e6;
  }
  if (to.resident_bytes) figures["resident_bytes"] = *to.resident_bytes;
  if (const auto growth = outcome.resident_growth_percent()) figures["resident_growth_percent"] = *growth;
  if (outcome.idle_joined > 0 && outcome.idle.resident_bytes && outcome.before.resident_bytes) {
    figures["idle_bytes_each"] = (*outcome.idle.resident_bytes - *outcome.before.resident_bytes) /
                                 static_cast<double>(outcome.idle_joined);
  }
  if (outcome.before.open_files && outcome.after.open_files) {
    figures["files_left"] = *outcome.after.open_files - *outcome.before.open_files;
  }
}

}  // namespace

Figures figures_of(const Outcome& outcome) {
  const Tally players = outcome.players();
  const Tally& slow = outcome.tallies[static_cast<std::size_t>(Role::slow)];
  const Tally& greedy = outcome.tallies[static_cast<std::size_t>(Role::greedy)];
  Histogram chunks = players.join;
  chunks.merge(players.travel);
  Figures figures;
  put_spread(figures, "", chunks);
  put_spread(figures, "join_", players.join);
  put_spread(figures, "travel_", players.travel);
  put_spread(figures, "request_", players.requests);
  put_spread(figures, "first_chunk_", players.first_chunk);
  put_spread(figures, "full_view_", players.full_view);
  put_spread(figures, "harness_late_", outcome.lateness);

  const double seconds = outcome.end.seconds - outcome.begin.seconds;
  const auto per_second = [seconds](std::uint64_t from, std::uint64_t to) {
    return seconds > 0 ? static_cast<double>(to - from) / seconds : 0;
  };
  figures["chunks_per_s"] =
      per_second(outcome.begin.chunks + outcome.begin.uniform, outcome.end.chunks + outcome.end.uniform);
  figures["chunk_messages_per_s"] = per_second(outcome.begin.chunks, outcome.end.chunks);
  figures["bytes_per_s"] = per_second(outcome.begin.bytes, outcome.end.bytes);

  std::size_t latest = 0;
  std::uint64_t over_one = 0;
  for (std::size_t steps = 0; steps < players.late_steps.size(); ++steps) {
    if (players.late_steps[steps] > 0) latest = steps;
    if (steps > 1) over_one += players.late_steps[steps];
  }
  const auto put = [&](const char* name, auto count) { figures[name] = static_cast<double>(count); };
  put("late_steps_max", latest);
  put("late_over_one_step", over_one);
  put("wrong", outcome.all().wrongs());
  put("errors", players.error_count());
  put("disconnects", players.disconnect_count());
  put("unanswered", players.unanswered);
  put("missed", players.missed);
  put("out_of_order", players.disordered);
  put("worst_ring_gap", players.worst_ring_gap);
  put("joins", players.joins);
  put("cuts", players.cuts);
  put("slow_errors", slow.error_count());
  put("slow_disconnects", slow.disconnect_count());
  put("greedy_errors", greedy.error_count());
  put("greedy_chunks", greedy.chunks);
  put("harness_cpu_s", outcome.end.harness_cpu_seconds - outcome.begin.harness_cpu_seconds);
  put_server(figures, outcome);
  return figures;
}

bool is_figure(const std::string& name) {
  if (std::find(kSingles.begin(), kSingles.end(), name) != kSingles.end()) return true;
  return std::any_of(kSpreads.begin(), kSpreads.end(), [&](const std::string& prefix) {
    return name == prefix + "max_ms" || std::any_of(kPercentiles.begin(), kPercentiles.end(),
                                                    [&](const auto& p) { return name == prefix + p.name; });
  });
}

std::string figure_names() {
  std::string names = "p50_ms p95_ms p99_ms p99_9_ms max_ms (of all chunks; of some with a prefix:";
  for (const std::string prefix : kSpreads) {
    if (!prefix.empty()) names += " " + prefix;
  }
  names += ")";
  for (const char* name : kSingles) names += fmt::format(" {}", name);
  return names;
}

}  // namespace talus::load
