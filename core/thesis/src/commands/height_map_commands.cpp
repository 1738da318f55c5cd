#include <bit>
#include <cstdint>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "diamond_square.h"
#include "erode_height_map.h"
#include "height_map_file.h"
#include "option_faults.h"

namespace talus::tools {
namespace {

constexpr std::int64_t kMaxDroplets = 1'000'000'000;

struct ErodeArguments {
  std::string input;
  std::int64_t droplets = 100000;
  std::int64_t seed = 1;
  std::string output;
};

Expected<void> run_erode(const ErodeArguments& arguments) {
  return erode_height_map(
      arguments.input, arguments.output,
      {static_cast<std::uint64_t>(arguments.droplets), static_cast<std::uint64_t>(arguments.seed)});
}

struct DiamondArguments {
  std::int64_t seed = 1;
  int size = DiamondSquareOptions{}.side;
  double roughness = DiamondSquareOptions{}.roughness;
  std::string output;
};

Expected<void> run_diamond_square(const DiamondArguments& arguments) {
  if (!std::has_single_bit(static_cast<unsigned>(arguments.size))) {
    return wrong_use("--size: " + std::to_string(arguments.size) + " is not a power of two; " +
                     std::to_string(kMinDiamondSide) + ", 16, 32 ... " + std::to_string(kMaxDiamondSide));
  }
  return write_height_map(arguments.output, diamond_square({static_cast<std::uint64_t>(arguments.seed),
                                                            arguments.size, arguments.roughness}));
}

}  // namespace

Command add_erode(CLI::App& app) {
  auto* erode = app.add_subcommand("erode-heightmap", "Erode a height map by droplets of rain");
  const auto arguments = std::make_shared<ErodeArguments>();
  erode
      ->add_option("input", arguments->input, "16-bit grey PNG, or .npy of two axes (uint16, int32, float32)")
      ->type_name("IN")
      ->required();
  erode->add_option("--droplets", arguments->droplets, "Number of droplets; one a sample is a strong erosion")
      ->check(CLI::Range(std::int64_t{0}, kMaxDroplets))
      ->type_name("N")
      ->capture_default_str();
  erode->add_option("--seed", arguments->seed, "Seed of the places where they fall")
      ->check(fault_of_seed)
      ->type_name("S")
      ->capture_default_str();
  add_output(*erode, arguments->output, "Height map to write: .png for 16-bit samples, .npy for any", "OUT");
  erode->footer(
      "The same seed gives the same samples on every machine. The result is a height map that\n"
      "a world can use (surface.height_map.file).");
  return {erode, [arguments] { return run_erode(*arguments); }};
}

Command add_diamond_square(CLI::App& app) {
  auto* diamond = app.add_subcommand("diamond-square-heightmap",
                                     "Make a fractal height map that repeats, by midpoint displacement");
  const auto arguments = std::make_shared<DiamondArguments>();
  diamond->add_option("--seed", arguments->seed, "Seed of the heights")
      ->check(fault_of_seed)
      ->type_name("S")
      ->capture_default_str();
  diamond->add_option("--size", arguments->size, "Samples a side: a power of two, 8 to 8192")
      ->check(CLI::Range(kMinDiamondSide, kMaxDiamondSide))
      ->type_name("N")
      ->capture_default_str();
  diamond
      ->add_option("--roughness", arguments->roughness,
                   "0 to 1: displacement of each grid's points, relative to the grid twice as wide")
      ->check([](const std::string& text) { return fault_of_number(text, 0, 1); })
      ->type_name("R")
      ->capture_default_str();
  add_output(*diamond, arguments->output, "Height map to write, of 16 bits a sample: .png or .npy", "OUT");
  diamond->footer(
      "Opposite edges fit: with outside = \"repeat\" (surface.height_map) it becomes an endless world "
      "without\n"
      "seams. The same seed gives the same samples on every machine.");
  return {diamond, [arguments] { return run_diamond_square(*arguments); }};
}

}  // namespace talus::tools
