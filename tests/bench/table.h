// One table out of Google Benchmark's runs: every stage beside its reference, as a ratio of the same run.
#pragma once

#include <string>

#include <benchmark/benchmark.h>

namespace talus::bench {

/// Counts what a stage works on: columns, samples or chunks. What the table calls `unit`.
void works_on(benchmark::State& state, const char* unit, std::int64_t items_an_iteration);

/// Runs what the command line asks for and prints the table: "stage" beside each "stage/vs:reference". Exit
/// status of main.
int run(int argc, char** argv);

}  // namespace talus::bench
