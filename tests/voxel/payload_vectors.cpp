#include "payload_vectors.h"

#include <array>

#include <talus/voxel/content_hash.h>

#include "runs.h"
#include "sample_chunks.h"

namespace talus::testing {
namespace {

/// Sloping rock, soil of two rows that ends in the south, air.
Chunk slope() {
  Layers layers{{MaterialId{2}, MaterialId{300}, kAir}, {}};
  layers.tops.resize(2 * kChunkArea);
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const int rock = 10 + x / 8;
      layers.tops[column_index(x, z)] = static_cast<std::uint8_t>(rock);
      layers.tops[kChunkArea + column_index(x, z)] = static_cast<std::uint8_t>(z < 20 ? rock + 2 : rock);
    }
  }
  return Chunk::from_layers(std::move(layers));
}

template <class MaterialOf>
Chunk dense(const MaterialOf& material_of) {
  const auto voxels = std::make_unique<DenseVoxels>();
  for (std::uint8_t y = 0; y < kChunkSize; ++y) {
    for (std::uint8_t z = 0; z < kChunkSize; ++z) {
      for (std::uint8_t x = 0; x < kChunkSize; ++x) {
        (*voxels)[voxel_index({x, y, z})] = MaterialId{static_cast<std::uint16_t>(material_of(x, y, z))};
      }
    }
  }
  return Chunk::from_dense(*voxels);
}

/// Rock up to row 12 and one voxel of 300 in the air above.
Chunk lamp() {
  return dense([](int x, int y, int z) { return x == 5 && y == 20 && z == 7 ? 300 : y < 12 ? 1 : 0; });
}

/// Rock up to row 12, air, and rock again in row 31: three runs.
Chunk cellar() {
  return dense([](int, int y, int) { return y < 12 || y == 31 ? 1 : 0; });
}

std::vector<std::byte> encoded_as_runs(const Chunk& chunk) {
  std::vector<std::byte> payload{std::byte{4}, std::byte{3}};
  if (!codec::encode_runs(*voxels_of(chunk), kMaxPayloadBytes, payload)) throw std::runtime_error{"no runs"};
  return payload;
}

/// A house of bricks on a hill.
Chunk house() {
  std::vector<Override> bricks;
  for (std::uint8_t y = 20; y < 26; ++y) {
    for (std::uint8_t z = 8; z < 17; ++z) {
      for (std::uint8_t x = 5; x < 18; ++x) {
        const bool wall = y == 25 || z == 8 || z == 16 || x == 5 || x == 17;
        const auto brick = static_cast<std::uint16_t>((x * 7 + y * 13 + z * 5) % 11 == 0 ? 301 : 300);
        bricks.push_back(
            {static_cast<std::uint16_t>(voxel_index({x, y, z})), wall ? MaterialId{brick} : kAir});
      }
    }
  }
  return Chunk::from_layers(hill(1)).with_overrides(bricks);
}

std::string hex(const std::vector<std::byte>& bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kDigits[std::to_integer<std::size_t>(byte) / 16];
    text += kDigits[std::to_integer<std::size_t>(byte) % 16];
  }
  return text;
}

}  // namespace

std::vector<WorkedExample> worked_examples() {
  return {{"layered", slope(), encoded(slope())},
          {"volume", lamp(), encoded(lamp())},
          {"runs", cellar(), encoded_as_runs(cellar())}};
}

std::vector<FrozenChunk> frozen_chunks() {
  return {
      {"house", house(), "4d776bb6ac8aac322b612fb9f60e94f3"},
      {"hill", Chunk::from_dense(*voxels_of(Chunk::from_layers(hill(1)))),
       "86a412f7635065ddd535272aa6357d00"},
      {"few_materials", Chunk::from_dense(*random_voxels(4, 3, 40)), "1645b96dc33be125ec6d5c7ef429ff8f"},
      {"many_materials", Chunk::from_dense(*random_voxels(5, 250, 200)), "699e105c9c55b022744fa717aa6ed4a5"}};
}

std::string name_of(DecodeError error) {
  constexpr std::array kNames{"empty",    "unknown_version", "unknown_encoding", "truncated",
                              "too_long", "bad_materials",   "bad_number",       "bad_ending"};
  return kNames[static_cast<std::size_t>(error)];
}

std::string payload_vectors() {
  std::string text =
      "# Payloads of chunks for a decoder in any language. Lines that begin with # are comments; the others "
      "are:\n"
      "#   chunk NAME HASH PAYLOAD   a payload and the content hash of its voxels: XXH3-128 (seed 0) of "
      "32,768\n"
      "#                             ids of two bytes, low byte first, in dense order; high 64 bits first\n"
      "#   error NAME ERROR PAYLOAD  bytes that are no payload, and the error that FORMAT.md names\n"
      "# Payloads are hexadecimal; \"-\" is no bytes at all.\n";
  const auto add_chunk = [&text](const std::string& name, const std::vector<std::byte>& payload) {
    text +=
        "chunk " + name + ' ' + to_string(content_hash(decode(payload).value())) + ' ' + hex(payload) + '\n';
  };
  add_chunk("uniform", encoded(Chunk::uniform(MaterialId{300})));
  for (const WorkedExample& example : worked_examples())
    add_chunk("example_" + example.name, example.payload);
  add_chunk("layers_hill", encoded(Chunk::from_layers(hill(1))));
  add_chunk("layers_listed", encoded(Chunk::from_layers(with_large_ids(random_layers(3, 7, 400)))));
  for (const FrozenChunk& each : frozen_chunks()) add_chunk("frozen_" + each.name, encoded(each.chunk));

  const auto add_error = [&text](const std::string& name, const std::vector<std::byte>& payload) {
    const auto chunk = decode(payload);
    if (chunk) throw std::runtime_error{name + " is a chunk"};
    text +=
        "error " + name + ' ' + name_of(chunk.error()) + ' ' + (payload.empty() ? "-" : hex(payload)) + '\n';
  };
  const auto changed = [](std::vector<std::byte> payload, const auto& change) {
    change(payload);
    return payload;
  };
  add_error("no_bytes", {});
  add_error("version_2", {std::byte{2}, std::byte{0}, std::byte{1}, std::byte{0}});
  add_error("palette_of_version_3", {std::byte{3}, std::byte{1}, std::byte{1}, std::byte{0}});
  add_error("layered_of_version_4", {std::byte{4}, std::byte{0}, std::byte{1}, std::byte{0}});
  for (const auto& [name, chunk, payload] : worked_examples()) {
    add_error(name + "_cut", changed(payload, [](auto& bytes) { bytes.pop_back(); }));
    add_error(name + "_with_a_byte_more",
              changed(payload, [](auto& bytes) { bytes.push_back(std::byte{0}); }));
    add_error(name + "_without_states", changed(payload, [](auto& bytes) { bytes.resize(20); }));
  }
  const auto volume = encoded(lamp());
  add_error("volume_no_materials", changed(volume, [](auto& bytes) { bytes[2] = std::byte{0}; }));
  add_error("volume_unordered_materials", changed(volume, [](auto& bytes) { bytes[4] = std::byte{1}; }));
  add_error("volume_sizes_past_256", changed(volume, [](auto& bytes) { bytes[7] = std::byte{0x0e}; }));
  add_error("volume_exceptions_left_over", changed(volume, [](auto& bytes) { bytes[10] = std::byte{0x20}; }));
  add_error("volume_no_such_table", changed(volume, [](auto& bytes) { bytes[11] = std::byte{8}; }));
  add_error("volume_small_state", changed(volume, [](auto& bytes) { bytes[13] = std::byte{0}; }));
  add_error("volume_other_ending", changed(volume, [](auto& bytes) { bytes[40] = std::byte{0x09}; }));
  add_error("number_longer_than_it_need_be",
            {std::byte{3}, std::byte{0}, std::byte{1}, std::byte{0x80}, std::byte{0}});
  return text;
}

}  // namespace talus::testing
