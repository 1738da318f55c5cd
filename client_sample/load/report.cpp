#include "report.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "figures.h"

namespace talus::load {
namespace {

/// A harness this far behind its schedule measures itself.
constexpr double kVoidMs = 1'000;

std::string row(const std::string& name, const measure::Histogram& waits) {
  if (waits.count() == 0) return "";
  return fmt::format("  {:<22}{:>11}{:>10.3f}{:>10.3f}{:>10.3f}{:>10.3f}{:>10.3f}\n", name, waits.count(),
                     waits.percentile_ms(0.5), waits.percentile_ms(0.95), waits.percentile_ms(0.99),
                     waits.percentile_ms(0.999), waits.max_ms());
}

std::string waits_of(const RunResult& result) {
  const Tally players = result.players();
  std::string rows = row("chunks of joins", players.join) + row("chunks of travel", players.travel);
  for (std::size_t role = 0; role < kRoles; ++role) {
    const Tally& tally = result.tallies[role];
    const std::string name{kRoleNames[role]};
    if (tally.join.count() != players.join.count()) rows += row("  joins, " + name, tally.join);
    if (tally.travel.count() != players.travel.count()) rows += row("  travel, " + name, tally.travel);
    if (!is_player(static_cast<Role>(role))) rows += row("  requests, " + name, tally.requests);
  }
  rows += row("requests", players.requests) + row("first chunk", players.first_chunk) +
          row("full view", players.full_view) + row("full horizon", players.horizon) +
          row("two nearest rings", players.near) + row("returns after a loss", players.returns) +
          row("  Pong, Attached", players.back) + row("  full view again", players.full_again) +
          row("edits acknowledged", players.edit_ack) + row("edits seen elsewhere", players.edit_arrival) +
          row("  at another server", players.edit_other_server);
  if (rows.empty()) return "";
  return fmt::format("  {:<22}{:>11}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "wait in ms", "count", "p50", "p95",
                     "p99", "p99.9", "max") +
         rows;
}

std::string counts_of(const std::map<std::string, std::uint64_t>& counts) {
  if (counts.empty()) return "none";
  std::string text;
  for (const auto& [name, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  return text;
}

std::string checks_of(const Plan& plan, const RunResult& result) {
  const Tally all = result.all();
  std::string text = fmt::format(
      "  wrong: {} ({} chunks decoded and hashed, {} bad; {} outside, {} twice, {} bad messages)\n",
      all.wrongs(), all.verified, all.bad_chunks, all.outside, all.duplicates, all.bad_messages);
  if (!all.first_wrong.empty()) text += fmt::format("  first wrong: {}\n", all.first_wrong);
  text += fmt::format("  never came: {}{}\n", all.unanswered,
                      all.unanswered == 0 ? "" : fmt::format(" (the first: {})", all.first_unanswered));
  if (all.made > 0) {
    text += fmt::format("  made by players: {} chunks, {} of them compared with the server's, {} differed\n",
                        all.made, all.proofs, all.failed_proofs);
  }
  if (all.edits > 0) {
    text += fmt::format(
        "  edits: {} acknowledged, which changed {} voxels, seen {} times elsewhere; missing: {}{}{}\n",
        all.edits, all.edited_voxels, all.edit_arrivals, all.edits_missing,
        all.edits_missing == 0 ? "" : fmt::format(" (the first: {})", all.first_missing),
        all.edits_unknown == 0 ? "" : fmt::format("; {} of unknown outcome", all.edits_unknown));
  }
  if (all.ordered > 0) {
    text += fmt::format("  order: {} of {} chunks came over {} rings before a nearer one, {} at most\n",
                        all.disordered, all.ordered, plan.options.ring_tolerance, all.worst_ring_gap);
  }
  text += fmt::format("  on the way: {} left the View before they came, {} came after they left it\n",
                      all.missed, all.stale);
  return text;
}

std::string troubles_of(const RunResult& result) {
  const Tally players = result.players();
  std::string text = fmt::format("  errors: {}\n  disconnects: {}\n", counts_of(players.errors),
                                 counts_of(players.disconnects));
  for (const Role role : {Role::slow, Role::greedy}) {
    const Tally& tally = result.tallies[static_cast<std::size_t>(role)];
    if (tally.joins == 0 && tally.disconnects.empty()) continue;
    text += fmt::format("  {}: {} chunks; errors: {}; disconnects: {}\n", name_of(role), tally.chunks,
                        counts_of(tally.errors), counts_of(tally.disconnects));
  }
  return text;
}

/// One line if the server's own rates delayed the players.
std::string held_by(const Plan& plan, const RunResult& result) {
  const auto held = result.held_by();
  if (held.empty()) return "";
  double most = 0;
  bool of_address = false;
  std::string rates;
  for (const auto& [name, rate] : held) {
    most = std::max(most, rate.held());
    const bool address = name.find("address") != std::string::npos;
    of_address = of_address || address;
    rates += fmt::format("{}{} ({:.0f} a second for {})", rates.empty() ? "" : ", ", name, rate.per_second(),
                         address ? "each address" : "each session");
  }
  return fmt::format(
      "  held: {:.0f} % of the time by the server's own {}; for more, raise {} there (0: no limit){}\n",
      most * 100, rates, held.size() == 1 ? "it" : "them",
      of_address && !plan.server.address().is_v6() ? ", or spread the players by --from-addresses" : "");
}

std::string server_of(const Figures& figures) {
  std::string text;
  const auto put = [&](const char* name, double scale, const char* format) {
    const auto found = figures.find(name);
    if (found == figures.end()) return;
    text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(format), found->second / scale);
  };
  put("cpu_s", 1, "{:.2f} CPU s");
  put("cpu_s_per_million", 1, "{:.2f} CPU s a million chunks");
  put("cpu_s_per_million_messages", 1, "{:.2f} a million Chunk messages");
  put("resident_bytes", 1 << 20, "{:.0f} MiB resident");
  put("resident_growth_percent", 1, "{:+.1f} % from the first tenth to the last");
  put("idle_bytes_each", 1024, "{:.1f} KiB an idle connection");
  put("files_left", 1, "{:.0f} files left open");
  put("generated_per_sent", 1, "{:.2f} chunks generated for each sent");
  put("patches_per_new", 1, "{:.2f} patches for each that is new land");
  return text.empty() ? "" : "  server: " + text + "\n";
}

nlohmann::json spread_json(const measure::Histogram& waits) {
  return {{"count", waits.count()},
          {"p50", waits.percentile_ms(0.5)},
          {"p95", waits.percentile_ms(0.95)},
          {"p99", waits.percentile_ms(0.99)},
          {"p99_9", waits.percentile_ms(0.999)},
          {"max", waits.max_ms()},
          {"mean", waits.mean_ms()}};
}

nlohmann::json tally_json(const Tally& tally) {
  return {{"chunk_messages", tally.chunks},
          {"chunk_bytes", tally.chunk_bytes},
          {"uniform_chunks", tally.uniform},
          {"unchanged", tally.unchanged},
          {"stale", tally.stale},
          {"repeated", tally.repeated},
          {"updated", tally.updated},
          {"missed", tally.missed},
          {"unconfirmed", tally.unconfirmed},
          {"verified", tally.verified},
          {"unanswered", tally.unanswered},
          {"edits",
           {{"acknowledged", tally.edits},
            {"voxels", tally.edited_voxels},
            {"arrivals", tally.edit_arrivals},
            {"unknown", tally.edits_unknown},
            {"missing", tally.edits_missing}}},
          {"wrong",
           {{"bad_chunks", tally.bad_chunks},
            {"outside", tally.outside},
            {"duplicates", tally.duplicates},
            {"bad_messages", tally.bad_messages}}},
          {"order",
           {{"looked_at", tally.ordered},
            {"over_tolerance", tally.disordered},
            {"worst_ring_gap", tally.worst_ring_gap}}},
          {"late_steps", tally.late_steps},
          {"joins", tally.joins},
          {"cuts", tally.cuts},
          {"reconnects", tally.reconnects},
          {"new_patches", tally.new_patches},
          {"longest_without_ms", std::chrono::duration<double, std::milli>(tally.longest_without).count()},
          {"errors", tally.errors},
          {"disconnects", tally.disconnects},
          {"wait_ms",
           {{"join", spread_json(tally.join)},
            {"travel", spread_json(tally.travel)},
            {"request", spread_json(tally.requests)},
            {"first_chunk", spread_json(tally.first_chunk)},
            {"full_view", spread_json(tally.full_view)},
            {"horizon", spread_json(tally.horizon)},
            {"near", spread_json(tally.near)},
            {"return", spread_json(tally.returns)},
            {"back", spread_json(tally.back)},
            {"full_again", spread_json(tally.full_again)},
            {"edit_ack", spread_json(tally.edit_ack)},
            {"edit_arrival", spread_json(tally.edit_arrival)},
            {"edit_other_server", spread_json(tally.edit_other_server)}}}};
}

nlohmann::json settings_json(const Options& options) {
  return {
      {"players", options.players},
      {"duration_s", options.seconds},
      {"ramp_up_s", options.ramp_up_seconds},
      {"warm_up_s", options.warm_up_seconds ? nlohmann::json(*options.warm_up_seconds) : nlohmann::json()},
      {"seed", options.seed},
      {"threads", options.threads},
      {"model", options.model},
      {"groups", options.groups},
      {"speed", options.speed ? nlohmann::json(*options.speed) : nlohmann::json()},
      {"radius", options.radius},
      {"vertical", options.vertical},
      {"horizon", options.horizon},
      {"tick_hz", options.tick_hz},
      {"every_tick", options.every_tick},
      {"dwell_s", options.dwell_seconds},
      {"churn_s", options.churn_seconds},
      {"edits", options.edits},
      {"edit_group", options.edit_group},
      {"edit_in_flight", options.edits_in_flight},
      {"idle", options.idle},
      {"greedy", options.greedy},
      {"slow", options.slow},
      {"slow_rate_kbit", options.slow_kbit},
      {"in_flight", options.in_flight},
      {"set", options.fixed_set},
      {"patch_tiles", options.patch_tiles},
      {"verify_percent", options.verify_percent},
      {"ring_tolerance", options.ring_tolerance},
      {"from_addresses", options.from_addresses},
      {"tls", options.connect.tls.on},
      {"websocket", options.connect.websocket.on}};
}

}  // namespace

std::string report(const Plan& plan, const RunResult& result) {
  const Figures figures = figures_of(result);
  const double seconds = result.end.seconds - result.begin.seconds;
  std::string text =
      fmt::format("{} players ({}) of {}, seed {}, {:.1f} s measured{}, {} cores\n", plan.options.players,
                  plan.options.builds()         ? "build"
                  : plan.options.in_flight != 0 ? "requests"
                                                : plan.options.model,
                  plan.world.server, plan.options.seed, seconds, result.interrupted ? " (interrupted)" : "",
                  std::thread::hardware_concurrency());
  text += waits_of(result);
  if (plan.published != nullptr) {
    text += "  chunks: made by the players, which receive only edits\n";
  } else if (!plan.not_published.empty()) {
    text += fmt::format("  chunks: all sent by the server: {}\n", plan.not_published);
  }
  text += fmt::format("  rate: {:.0f} chunks/s ({:.0f} Chunk messages/s), {:.2f} MB/s\n",
                      figures.at("chunks_per_s"), figures.at("chunk_messages_per_s"),
                      figures.at("bytes_per_s") / 1e6);
  const Tally players = result.players();
  if (plan.options.builds()) text += fmt::format("  edits: {:.0f}/s\n", figures.at("edits_per_s"));
  if (players.travel.count() + players.join.count() > 0) {
    text += fmt::format(
        "  late: {:.0f} chunks by more than one View step, {}{:.0f} steps at most\n",
        figures.at("late_over_one_step"),
        figures.at("late_steps_max") == static_cast<double>(players.late_steps.size() - 1) ? "over " : "",
        figures.at("late_steps_max"));
  }
  if (players.near.count() > 0) {
    text += fmt::format("  without any chunk, while waiting for some: {:.0f} ms at most\n",
                        figures.at("longest_without_ms"));
  }
  if (players.reconnects > 0) text += fmt::format("  reconnects: {}\n", players.reconnects);
  text += held_by(plan, result) + checks_of(plan, result) + troubles_of(result) + server_of(figures);
  text += fmt::format("  harness: {:.2f} CPU s, p99 {:.3f} ms behind its own schedule\n",
                      figures.at("harness_cpu_s"), result.lateness.percentile_ms(0.99));
  if (result.lateness.percentile_ms(0.99) > kVoidMs) {
    text +=
        "  void: talus-load could not keep up with its own players, and the figures above are its own, not "
        "the server's; give it fewer --players, or more --threads\n";
  }
  return text;
}

nlohmann::json report_json(const Plan& plan, const RunResult& result) {
  nlohmann::json roles = nlohmann::json::object();
  for (std::size_t role = 0; role < kRoles; ++role) {
    const Tally& tally = result.tallies[role];
    if (tally.joins > 0 || !tally.disconnects.empty())
      roles[std::string{kRoleNames[role]}] = tally_json(tally);
  }
  nlohmann::json held = nlohmann::json::object();
  for (const auto& [name, rate] : result.held_by()) held[name] = rate.held();
  nlohmann::json counters = nlohmann::json::object();
  for (const auto& [name, value] : result.end.server.counters) {
    const auto before = result.begin.server.counters.find(name);
    counters[name] = value - (before == result.begin.server.counters.end() ? 0 : before->second);
  }
  return {{"format", 2},
          {"program", "talus-load " TALUS_VERSION},
          {"machine", {{"cores", std::thread::hardware_concurrency()}}},
          {"server", {{"name", plan.world.server}, {"fingerprint", to_string(plan.world.fingerprint)}}},
          {"settings", settings_json(plan.options)},
          {"measured_s", result.end.seconds - result.begin.seconds},
          {"interrupted", result.interrupted},
          {"figures", figures_of(result)},
          {"held_by", held},
          {"roles", roles},
          {"server_counters", counters}};
}

}  // namespace talus::load
