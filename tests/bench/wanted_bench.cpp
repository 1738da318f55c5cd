// What players' Views cost in WantedChunks: a crowd in one place whose boxes all differ, and beside it as
// many players far apart. Items are calls.
#include <string>
#include <vector>

#include "chunks/generation/wanted_chunks.h"
#include "table.h"

namespace {

using namespace talus;
using benchmark::State;
using server::WantedChunks;

/// A View of radius 8, 4 rows up and down. Clients stand within 8 x 8 chunks, above each other where they are
/// many, or each `apart` chunks from the next; `step` moves them by a row.
LevelBox view_of(std::int64_t client, std::int64_t apart, std::int64_t step) {
  const auto around = [](std::int64_t at, std::int64_t radius) {
    return ChunkRange{at - radius, at + radius};
  };
  return {Lod{},
          around(client % 8 + client * apart, 8),
          around(client / 64 * 2 + step % 2, 4),
          around(client / 8 % 8, 8),
          {},
          {}};
}

struct Crowd {
  WantedChunks wanted;
  std::int64_t clients;
  std::int64_t apart;

  Crowd(std::int64_t how_many, std::int64_t chunks_apart) : clients{how_many}, apart{chunks_apart} {
    for (std::int64_t client = 0; client < clients; ++client) move(client, 0);
  }
  void move(std::int64_t client, std::int64_t step) {
    const std::vector boxes{view_of(client, apart, step)};
    wanted.set(server::ClientId{static_cast<std::uint64_t>(client) + 1}, boxes);
  }
};

constexpr std::int64_t kFarApart = 1000;

/// Every client moves by a row.
void set(State& state, std::int64_t clients, std::int64_t apart) {
  Crowd crowd{clients, apart};
  std::int64_t step = 0;
  for (auto _ : state) {
    ++step;
    for (std::int64_t client = 0; client < crowd.clients; ++client) crowd.move(client, step);
  }
  bench::works_on(state, "set", crowd.clients);
}

/// Columns in which clients stand: all rows, so that no box ends the search.
void rows_of(State& state, std::int64_t clients, std::int64_t apart) {
  Crowd crowd{clients, apart};
  constexpr ChunkRange kAll{-1000, 1000};
  for (auto _ : state) {
    for (std::int64_t client = 0; client < crowd.clients; ++client) {
      const LevelBox box = view_of(client, apart, 0);
      const ChunkKey column{
          {static_cast<std::int32_t>(box.x.first + 8), 0, static_cast<std::int32_t>(box.z.first + 8)}, Lod{}};
      benchmark::DoNotOptimize(crowd.wanted.rows_of(column, kAll));
    }
  }
  bench::works_on(state, "look", crowd.clients);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::int64_t clients : {1, 500, 1000, 2000, 4000}) {
    const auto with = [&](const std::string& name, auto* measured) {
      benchmark::RegisterBenchmark(name.c_str(), measured, clients, 0);
      benchmark::RegisterBenchmark((name + "/vs:far apart").c_str(), measured, clients, kFarApart);
    };
    with("set, " + std::to_string(clients) + " in one place", &set);
    with("rows_of, " + std::to_string(clients) + " in one place", &rows_of);
  }
  return bench::run(argc, argv);
}
