#include "table.h"

#include <cstdio>
#include <map>
#include <vector>

namespace talus::bench {
namespace {

constexpr const char* kVersus = "/vs:";

struct Row {
  std::string stage;
  std::string reference;  // empty: the stage itself
  std::string unit;
  double ns = 0;  // an item
  double bytes = 0;
  double least_ns = 0;
};

Row row_of(const benchmark::BenchmarkReporter::Run& run) {
  Row row;
  const std::string name =
      run.run_name.function_name + (run.run_name.args.empty() ? "" : "/" + run.run_name.args);
  const std::size_t versus = name.find(kVersus);
  row.stage = name.substr(0, versus);
  if (versus != std::string::npos) row.reference = name.substr(versus + std::string{kVersus}.size());
  row.unit = run.report_label;
  const auto items = run.counters.find("items_per_second");
  if (items != run.counters.end() && items->second.value > 0) row.ns = 1e9 / items->second.value;
  const auto bytes = run.counters.find("bytes");
  if (bytes != run.counters.end()) row.bytes = bytes->second.value;
  const auto least = run.counters.find("least_ns");
  if (least != run.counters.end()) row.least_ns = least->second.value;
  return row;
}

/// Prints each stage when its run is over, and once more beside every reference.
class Table final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override {
    std::printf("%-34s %14s   %-34s %9s %10s\n", "stage", "ns", "reference, in the same run", "its ns",
                "ratio");
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) {
        std::printf("%-34s failed: %s\n", run.benchmark_name().c_str(), run.error_message.c_str());
        continue;
      }
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name != "median") continue;
      print(row_of(run));
    }
    std::fflush(stdout);
  }

 private:
  void print(const Row& row) {
    if (row.reference.empty()) {
      stages_[row.stage] = row;
      std::printf("%-34s %10.2f a %s", row.stage.c_str(), row.ns, row.unit.c_str());
      if (row.least_ns > 0) std::printf(", at least %.0f", row.least_ns);
      if (row.bytes > 0) std::printf(", %.1f bytes", row.bytes);
      std::printf("\n");
      return;
    }
    const Row& stage = stages_[row.stage];
    std::printf("%-34s %10s %-5s  %-34s %9.2f %9.2fx", "", "", "", row.reference.c_str(), row.ns,
                stage.ns > 0 ? row.ns / stage.ns : 0.0);
    if (row.bytes > 0) std::printf("  bytes %.1f, ours %.2f of that", row.bytes, stage.bytes / row.bytes);
    std::printf("\n");
  }

  std::map<std::string, Row> stages_;
};

}  // namespace

void works_on(benchmark::State& state, const char* unit, std::int64_t items_an_iteration) {
  state.SetItemsProcessed(state.iterations() * items_an_iteration);
  state.SetLabel(unit);
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  return 0;
}

}  // namespace talus::bench
