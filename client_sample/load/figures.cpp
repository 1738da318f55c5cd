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

// Prefixes of the percentiles: all chunks, chunks of joins, chunks of travel, and so on.
constexpr std::array kSpreads{
    "",          "join_",         "travel_",           "request_", "first_chunk_", "full_view_",
    "horizon_",  "near_",         "return_",           "back_",    "full_again_",  "harness_late_",
    "edit_ack_", "edit_arrival_", "edit_other_server_"};
constexpr std::array kSingles{"bytes",
                              "chunks_per_s",
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
                              "reconnects",
                              "longest_without_ms",
                              "held_percent",
                              "generated_per_sent",
                              "patches_per_new",
                              "edits",
                              "edits_per_s",
                              "edit_arrivals",
                              "edits_unknown",
                              "edits_missing",
                              "made",
                              "proofs",
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

void put_spread(Figures& figures, const std::string& prefix, const measure::Histogram& waits) {
  if (waits.count() == 0) return;
  for (const Percentile& percentile : kPercentiles) {
    figures[prefix + percentile.name] = waits.percentile_ms(percentile.part);
  }
  figures[prefix + "max_ms"] = waits.max_ms();
}

void put_server(Figures& figures, const RunResult& result) {
  const ServerSample& from = result.begin.server;
  const ServerSample& to = result.end.server;
  if (from.cpu_seconds && to.cpu_seconds) {
    const double cpu = *to.cpu_seconds - *from.cpu_seconds;
    const auto messages = static_cast<double>(result.end.chunks - result.begin.chunks);
    const double chunks = messages + static_cast<double>(result.end.uniform - result.begin.uniform);
    figures["cpu_s"] = cpu;
    if (chunks > 0) figures["cpu_s_per_million"] = cpu / chunks * 1e6;
    if (messages > 0) figures["cpu_s_per_million_messages"] = cpu / messages * 1e6;
  }
  if (to.resident_bytes) figures["resident_bytes"] = *to.resident_bytes;
  if (const auto growth = result.resident_growth_percent()) figures["resident_growth_percent"] = *growth;
  const auto grown = [&](const char* name) -> double {
    const auto end = to.counters.find(name);
    const auto begin = from.counters.find(name);
    return end == to.counters.end() || begin == from.counters.end() ? 0 : end->second - begin->second;
  };
  if (const double sent = grown("talus_chunks_sent_total"); sent > 0) {
    figures["generated_per_sent"] = grown("talus_chunks_generated_total") / sent;
  }
  const double patches = grown("talus_patches_generated_total");
  if (const auto fresh = static_cast<double>(result.players().new_patches); fresh > 0 && patches > 0) {
    figures["patches_per_new"] = patches / fresh;
  }
  if (result.idle_joined > 0 && result.idle.resident_bytes && result.before.resident_bytes) {
    figures["idle_bytes_each"] = (*result.idle.resident_bytes - *result.before.resident_bytes) /
                                 static_cast<double>(result.idle_joined);
  }
  if (result.before.open_files && result.after.open_files) {
    figures["files_left"] = *result.after.open_files - *result.before.open_files;
  }
}

}  // namespace

Figures figures_of(const RunResult& result) {
  const Tally players = result.players();
  const Tally& slow = result.tallies[static_cast<std::size_t>(Role::slow)];
  const Tally& greedy = result.tallies[static_cast<std::size_t>(Role::greedy)];
  measure::Histogram chunks = players.join;
  chunks.merge(players.travel);
  Figures figures;
  put_spread(figures, "", chunks);
  put_spread(figures, "join_", players.join);
  put_spread(figures, "travel_", players.travel);
  put_spread(figures, "request_", players.requests);
  put_spread(figures, "first_chunk_", players.first_chunk);
  put_spread(figures, "full_view_", players.full_view);
  put_spread(figures, "horizon_", players.horizon);
  put_spread(figures, "near_", players.near);
  put_spread(figures, "return_", players.returns);
  put_spread(figures, "back_", players.back);
  put_spread(figures, "full_again_", players.full_again);
  put_spread(figures, "harness_late_", result.lateness);
  put_spread(figures, "edit_ack_", players.edit_ack);
  put_spread(figures, "edit_arrival_", players.edit_arrival);
  put_spread(figures, "edit_other_server_", players.edit_other_server);

  const double seconds = result.end.seconds - result.begin.seconds;
  const auto per_second = [seconds](std::uint64_t from, std::uint64_t to) {
    return seconds > 0 ? static_cast<double>(to - from) / seconds : 0;
  };
  figures["chunks_per_s"] =
      per_second(result.begin.chunks + result.begin.uniform, result.end.chunks + result.end.uniform);
  figures["chunk_messages_per_s"] = per_second(result.begin.chunks, result.end.chunks);
  figures["bytes_per_s"] = per_second(result.begin.bytes, result.end.bytes);

  figures["edits_per_s"] = per_second(result.begin.edits, result.end.edits);

  std::size_t latest = 0;
  std::uint64_t over_one = 0;
  for (std::size_t steps = 0; steps < players.late_steps.size(); ++steps) {
    if (players.late_steps[steps] > 0) latest = steps;
    if (steps > 1) over_one += players.late_steps[steps];
  }
  const auto put = [&](const char* name, auto count) { figures[name] = static_cast<double>(count); };
  put("bytes", result.end.bytes - result.begin.bytes);
  put("late_steps_max", latest);
  put("late_over_one_step", over_one);
  put("wrong", result.all().wrongs());
  put("errors", players.error_count());
  put("disconnects", players.disconnect_count());
  put("unanswered", players.unanswered);
  put("missed", players.missed);
  put("out_of_order", players.disordered);
  put("worst_ring_gap", players.worst_ring_gap);
  put("joins", players.joins);
  put("cuts", players.cuts);
  put("reconnects", players.reconnects);
  put("edits", players.edits);
  put("edit_arrivals", players.edit_arrivals);
  put("edits_unknown", players.edits_unknown);
  put("edits_missing", players.edits_missing);
  if (players.near.count() > 0) {
    figures["longest_without_ms"] =
        std::chrono::duration<double, std::milli>(players.longest_without).count();
  }
  if (!result.rates.empty()) {
    double held = 0;
    for (const auto& [name, rate] : result.rates) held = std::max(held, rate.held());
    figures["held_percent"] = held * 100;
  }
  put("made", players.made);
  put("proofs", players.proofs);
  put("slow_errors", slow.error_count());
  put("slow_disconnects", slow.disconnect_count());
  put("greedy_errors", greedy.error_count());
  put("greedy_chunks", greedy.chunks);
  put("harness_cpu_s", result.end.harness_cpu_seconds - result.begin.harness_cpu_seconds);
  put_server(figures, result);
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
