// A model of a world's edits, outside of any server: what talus-load --edits-file has written down, laid over
// chunks as the generator makes them. It compares each chunk that was ever edited with what a running server
// gives to its players, by content hash and revision, and prints what `talusd store stat` must say:
//
//   talus-edits-model FILE HOST PORT   ->   COMPARED CHUNKS VOXELS REVISION HASH
//
// COMPARED chunks were ever edited; CHUNKS and VOXELS of them differ from the generated ones. The world is
// the one built into talusd. FILE must have every revision from 1 on: an edit without one happened, and its
// builder was never told. A comparison that fails is repeated if FILE has grown since it was read.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/io_context.hpp>

#include <talus/client/client.h>
#include <talus/edits/state_hash.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>

namespace {

using namespace talus;

struct Write {
  std::uint64_t revision = 0;
  VoxelPos at;
  MaterialId material{};
};

struct ModelChunk {
  std::uint64_t revision = 0;                     // of its newest edit
  std::map<std::uint16_t, MaterialId> materials;  // of each voxel that was ever written
};

using Model = std::map<ChunkCoord, ModelChunk>;

struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::vector<Write> read_writes(const std::string& path) {
  std::ifstream file{path};
  if (!file) throw Failure{path + ": cannot be read"};
  std::vector<Write> writes;
  for (std::string line; std::getline(file, line);) {
    // A line that was cut may still be five numbers, of which the last lacks digits.
    if (file.eof()) throw Failure{fmt::format("{}: line {} is cut", path, writes.size() + 1)};
    std::istringstream fields{line};
    Write write;
    std::uint16_t material = 0;
    fields >> write.revision >> write.at.x >> write.at.y >> write.at.z >> material;
    if (!fields || !fields.eof()) {
      throw Failure{
          fmt::format("{}: line {} is not an edit, which is five numbers", path, writes.size() + 1)};
    }
    write.material = MaterialId{material};
    writes.push_back(write);
  }
  if (!file.eof()) throw Failure{path + ": cannot be read"};
  return writes;
}

Model replay(std::vector<Write> writes) {
  std::ranges::sort(writes, {}, &Write::revision);
  const auto twice = std::ranges::adjacent_find(writes, {}, &Write::revision);
  if (twice != writes.end()) {
    throw Failure{fmt::format("two edits were acknowledged as revision {}", twice->revision)};
  }
  Model model;
  std::uint64_t expected = 1;
  for (const Write& write : writes) {
    if (write.revision != expected) {
      throw Failure{fmt::format("no edit was acknowledged as revision {}, and one as revision {}", expected,
                                write.revision)};
    }
    ++expected;
    ModelChunk& chunk = model[chunk_holding(write.at, Lod{})->coord];
    chunk.revision = write.revision;
    chunk.materials[static_cast<std::uint16_t>(voxel_index(local_pos(write.at)))] = write.material;
  }
  return model;
}

/// What the server gives for each of the model's chunks, in its order.
std::vector<client::ReceivedChunk> ask(const Model& model, const std::string& host, const std::string& port) {
  asio::io_context io{1};
  client::Options options;
  options.client_name = "talus-edits-model";
  client::Client client{io.get_executor(), options};
  std::vector<client::ReceivedChunk> answers(model.size());
  std::string error;
  const auto check_world = [&](const client::Result<client::WorldInfo>& world) {
    if (!world) {
      error = world.error().message;
    } else if (world->fingerprint != terrain::default_world().fingerprint()) {
      error = "the server has another world than the one built into talusd";
    }
    return error.empty();
  };
  std::size_t left = model.size();
  client.connect(host, port, [&](const client::Result<client::WorldInfo>& world) {
    if (!check_world(world) || left == 0) return io.stop();
    std::size_t place = 0;
    for (const auto& [coord, chunk] : model) {
      client.get(ChunkKey{coord, Lod{}}, {},
                 [&, place = place++](const client::Result<client::ReceivedChunk>& answer) {
                   if (answer) {
                     answers[place] = *answer;
                   } else if (error.empty()) {
                     error = answer.error().message;
                   }
                   if (--left == 0) io.stop();
                 });
    }
  });
  io.run();
  client.close();
  if (!error.empty()) throw Failure{fmt::format("{}:{}: {}", host, port, error)};
  return answers;
}

void compare(const std::string& file, const std::string& host, const std::string& port) {
  const Model model = replay(read_writes(file));
  const auto answers = ask(model, host, port);
  std::size_t place = 0;
  std::uint64_t differing = 0;
  std::uint64_t voxels = 0;
  std::uint64_t revision = 0;
  edits::StateHash hash;
  for (const auto& [coord, chunk] : model) {
    const client::ReceivedChunk& answer = answers[place++];
    const Chunk base = terrain::generate_chunk(terrain::default_world(), {coord, Lod{}});
    DenseVoxels generated;
    base.copy_to(generated);
    std::vector<Override> overrides;
    for (const auto& [index, material] : chunk.materials) {
      if (generated[index] != material) overrides.push_back({index, material});
    }
    const std::string name = fmt::format("chunk {},{},{}", coord.x, coord.y, coord.z);
    if (answer.revision != chunk.revision) {
      throw Failure{fmt::format("{}: revision {} at the server, {} in the model", name, answer.revision,
                                chunk.revision)};
    }
    const ContentHash expected = content_hash(base.with_overrides(overrides));
    if (answer.hash != expected) {
      throw Failure{fmt::format("{}: hash {} at the server, {} in the model", name, to_string(answer.hash),
                                to_string(expected))};
    }
    differing += overrides.empty() ? 0 : 1;
    voxels += overrides.size();
    revision = std::max(revision, chunk.revision);
    hash.add(coord, overrides);
  }
  fmt::print("{} {} {} {} {}\n", model.size(), differing, voxels, revision, edits::to_string(hash));
}

/// Edits that were acknowledged while the server was asked are in the file by now.
void run(const std::string& file, const std::string& host, const std::string& port) {
  for (;;) {
    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(file, ignored);
    try {
      return compare(file, host, port);
    } catch (const Failure&) {
      if (std::filesystem::file_size(file, ignored) == bytes) throw;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: talus-edits-model FILE HOST PORT\n");
    return 2;
  }
  try {
    run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "talus-edits-model: {}\n", error.what());
    return 1;
  }
  return 0;
}
