#include <cstdio>
#include <memory>
#include <string>

#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/explain.h>

#include "chunk_files.h"
#include "commands/commands.h"

namespace talus::tools {
namespace {

struct Arguments {
  std::string input;
  std::string output;
  std::size_t symbols = 16;
};

Expected<void> run_encode(const Arguments& arguments) {
  const auto chunk = read_voxels(arguments.input);
  if (!chunk) return tl::make_unexpected(chunk.error());
  std::vector<std::byte> payload;
  encode(*chunk, payload);
  if (const auto written = write_payload(payload, arguments.output); !written) return written;
  std::printf("%zu bytes; zstd -3: %zu bytes; content hash %s\n", payload.size(), zstd_bytes(*chunk),
              to_string(content_hash(*chunk)).c_str());
  return {};
}

Expected<void> run_decode(const Arguments& arguments) {
  const auto payload = read_payload(arguments.input);
  if (!payload) return tl::make_unexpected(payload.error());
  const auto chunk = decode(*payload);
  if (!chunk) return failed(arguments.input + ": " + std::string{describe(chunk.error())});
  if (const auto written = write_voxels(*chunk, arguments.output); !written) return written;
  std::printf("content hash %s\n", to_string(content_hash(*chunk)).c_str());
  return {};
}

Expected<void> run_explain(const Arguments& arguments) {
  const auto payload = read_payload(arguments.input);
  if (!payload) return tl::make_unexpected(payload.error());
  constexpr std::size_t kShownBytes = 8;
  std::printf("offset  bytes                     field                     meaning\n");
  for (const PayloadField& field : explain(*payload, arguments.symbols)) {
    std::string bytes;
    for (std::size_t i = 0; i < field.size && i < kShownBytes; ++i) {
      char digits[4];
      std::snprintf(digits, sizeof digits, "%02x ", std::to_integer<unsigned>((*payload)[field.offset + i]));
      bytes += i + 1 == kShownBytes && field.size > kShownBytes ? ".." : digits;
    }
    std::printf("%6zu  %-24s  %-24s  %s\n", field.offset, bytes.c_str(), field.name.c_str(),
                field.meaning.c_str());
  }
  const auto chunk = decode(*payload);
  if (!chunk) return failed(arguments.input + ": " + std::string{describe(chunk.error())});
  std::printf("content hash %s\n", to_string(content_hash(*chunk)).c_str());
  return {};
}

void add_input(CLI::App& command, Arguments& arguments, const char* meaning, const char* type) {
  command.add_option("input", arguments.input, meaning)->type_name(type)->required();
}

}  // namespace

Command add_encode(CLI::App& app) {
  auto* encode = app.add_subcommand("encode", "Encode a chunk of voxels as a payload, as servers do");
  const auto arguments = std::make_shared<Arguments>();
  add_input(*encode, *arguments, "32 x 32 x 32 voxels", "F.npy|F.vox");
  add_output(*encode, arguments->output, "Payload to write", "F.chunk");
  encode->footer(
      "F.npy is uint8 or uint16, [y][z][x], with y up and z south. F.vox is one MagicaVoxel model of at "
      "most\n"
      "32 voxels a side: x is east, y north and z up; palette indices are material ids, and what the model\n"
      "does not fill is air. Prints the payload's size, and the size of the same voxels under zstd -3.\n"
      "core/voxel/FORMAT.md specifies the payload.");
  return {encode, [arguments] { return run_encode(*arguments); }};
}

Command add_decode(CLI::App& app) {
  auto* decode = app.add_subcommand("decode", "Decode a payload to a NumPy array of voxels");
  const auto arguments = std::make_shared<Arguments>();
  add_input(*decode, *arguments, "Payload", "F.chunk");
  add_output(*decode, arguments->output,
             "Array to write: [y][z][x], uint8, or uint16 where a material id is above 255", "F.npy");
  return {decode, [arguments] { return run_decode(*arguments); }};
}

Command add_explain(CLI::App& app) {
  auto* explain = app.add_subcommand("explain", "Print a payload field by field, for authors of decoders");
  const auto arguments = std::make_shared<Arguments>();
  add_input(*explain, *arguments, "Payload", "F.chunk");
  explain->add_option("--symbols", arguments->symbols, "Number of coded symbols to print")
      ->check(CLI::Range(std::size_t{0}, std::size_t{100'000}))
      ->type_name("N")
      ->capture_default_str();
  explain->footer(
      "Prints offsets, bytes and their meaning. Then, for each of the first coded symbols, its context, its\n"
      "interval, and the rANS state before and after. core/voxel/FORMAT.md defines the terms.");
  return {explain, [arguments] { return run_explain(*arguments); }};
}

}  // namespace talus::tools
