// talus-load: simulates players of a running server and measures their waits.
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>

#include <talus/build_version.h>
#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>
#include <talus/files/standard_descriptors.h>

#include "command_line.h"
#include "compare.h"
#include "figures.h"
#include "plot.h"
#include "report.h"
#include "run.h"
#include "world_probe.h"

namespace {

using namespace talus;
using namespace talus::load;

int failed(const std::string& line, int status = 1) {
  std::cerr << "talus-load: " << line << '\n';
  return status;
}

tl::expected<std::string, std::string> read_whole(const std::string& path) {
  constexpr std::size_t kMaxBytes = 256U << 20;  // maximum for a trace, or for figures
  return files::read_file(path, kMaxBytes).map_error([](const auto& error) { return error.message(); });
}

/// Checks output files, and the file to compare with, before the work starts.
tl::expected<void, std::string> check_files(const Options& options) {
  for (const std::string& path : {options.json, options.plot, options.edits_file}) {
    if (path.empty()) continue;
    const auto folder = std::filesystem::absolute(path).parent_path();
    if (::access(folder.c_str(), W_OK) != 0) {
      return tl::unexpected{path + ": cannot be written: " + std::strerror(errno) +
                            "; give a folder that is there"};
    }
  }
  if (options.compare.empty()) return {};
  const auto old = read_whole(options.compare);
  if (!old) return tl::unexpected{old.error()};
  const nlohmann::json nothing{
      {"format", 2}, {"settings", nlohmann::json::object()}, {"figures", nlohmann::json::object()}};
  if (const auto table = compare(*old, nothing); !table) {
    return tl::unexpected{options.compare + ": " + table.error()};
  }
  return {};
}

tl::expected<Plan, std::string> make_plan(const Options& options) {
  Plan plan;
  plan.options = options;
  if (!options.mix.trace_file.empty()) {
    const auto text = read_whole(options.mix.trace_file);
    if (!text) return tl::unexpected{text.error()};
    auto trace = parse_trace(*text);
    if (!trace) return tl::unexpected{options.mix.trace_file + ":" + trace.error()};
    plan.trace = std::make_shared<const Trace>(*std::move(trace));
  }
  if (!options.edits_file.empty()) {
    auto journal = EditJournal::open(options.edits_file);
    if (!journal) return tl::unexpected{journal.error()};
    plan.journal = *std::move(journal);
  }
  if (const auto probed = probe_world(plan); !probed) return tl::unexpected{probed.error()};
  return plan;
}

std::string plot_of(const Plan& plan, const RunResult& result) {
  const Tally players = result.players();
  std::vector<Curve> curves;
  const auto add = [&](std::string name, const measure::Histogram& waits) {
    if (waits.count() > 0) curves.push_back({std::move(name), &waits});
  };
  add("chunks of joins", players.join);
  add("chunks of travel", players.travel);
  add("requests", players.requests);
  add("first chunk", players.first_chunk);
  add("full view", players.full_view);
  add("edits acknowledged", players.edit_ack);
  add("edits seen elsewhere", players.edit_arrival);
  if (curves.empty()) return "";
  std::ostringstream subtitle;
  subtitle << plan.options.players << " players (" << plan.options.model << "), radius "
           << plan.options.radius << ", seed " << plan.options.seed << ", " << plan.world.server;
  return plot("Latency of chunks", subtitle.str(), curves);
}

/// Prints and writes the results of a run; returns one line for each failure to do so.
std::vector<std::string> tell(const Plan& plan, const RunResult& result) {
  const Options& options = plan.options;
  std::vector<std::string> failures;
  const auto note = [&](const tl::expected<void, files::FileError>& written) {
    if (!written) failures.push_back(written.error().message());
  };
  std::cout << report(plan, result);
  const nlohmann::json json = report_json(plan, result);
  if (!options.compare.empty()) {
    const auto old = read_whole(options.compare);
    const auto table = old ? compare(*old, json) : tl::unexpected{old.error()};
    if (table) {
      std::cout << "compared with " << options.compare << '\n' << *table;
    } else {
      failures.push_back((old ? options.compare + ": " : "") + table.error());
    }
  }
  if (!options.json.empty()) note(files::write_file(options.json, json.dump(2) + "\n"));
  if (!options.plot.empty()) note(files::write_file(options.plot, plot_of(plan, result)));
  if (plan.journal != nullptr) {
    if (const auto kept = plan.journal->flush(); !kept) failures.push_back(kept.error());
  }
  if (options.builds()) {
    const Tally players = result.players();
    if (players.edits_missing > 0) {
      failures.push_back(std::to_string(players.edits_missing) +
                         " acknowledged edits are missing: " + players.first_missing);
    }
    if (players.edits == 0) {
      failures.push_back("no edit was acknowledged; " +
                         (players.first_refused.empty()
                              ? "the server needs --data, and the token the right edit (or "
                                "access.without_token read,edit)"
                              : "the server said " + players.first_refused));
    } else if (players.edited_voxels == 0 ||
               (options.edit_group > 1 && options.players > options.groups && players.edit_arrivals == 0)) {
      failures.push_back(std::string{"the acknowledged edits "} +
                         (players.edited_voxels == 0 ? "changed nothing" : "reached no other player") +
                         ", so nothing was measured; an earlier run has built the same there: give another "
                         "--seed, or the server a new --data directory");
    }
  }
  std::cout.flush();
  if (!std::cout) failures.push_back("standard output: cannot be written");
  return failures;
}

}  // namespace

int main(int argc, char** argv) try {
  talus::files::open_closed_standard_descriptors();
  // OpenSSL writes to sockets that the server may have closed.
  std::signal(SIGPIPE, SIG_IGN);
  const auto options = read_command_line(argc, argv, kBuildVersion);
  if (!options && options.error().status != 0) return failed(options.error().text, options.error().status);
  if (!options) {
    std::cout << options.error().text;
    return std::cout.flush() ? 0 : failed("standard output: cannot be written");
  }
  if (const auto checked = check_files(*options); !checked) return failed(checked.error());
  const auto plan = make_plan(*options);
  if (!plan) return failed(plan.error());
  const auto result = run(*plan);
  if (!result) return failed(result.error());

  auto failures = tell(*plan, *result);
  for (const std::string& line : crossed_thresholds(options->fail_if, figures_of(*result)))
    failures.push_back(line);
  for (const std::string& line : failures) failed(line);
  return failures.empty() ? 0 : 1;
} catch (const std::exception& error) {  // the system refuses memory, a thread or a descriptor
  return failed(std::string{"cannot go on: "} + error.what());
}
