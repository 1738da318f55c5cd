#include "app/pregen_command.h"

#include <signal.h>

#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <talus/progress/progress_bar.h>
#include <talus/store/data_directory.h>
#include <talus/store/store_identity.h>

#include "app/secret_world.h"
#include "app/settings.h"
#include "chunks/column_cache/column_cache.h"
#include "chunks/generation/terrain_generator.h"
#include "chunks/pregen.h"
#include "commands/store/opened_store.h"
#include "config/parse_flags.h"
#include "edits/store_socket/store_connection.h"
#include "runtime/clock.h"
#include "runtime/log/escape.h"
#include "runtime/log/logger.h"

namespace talus::server {
namespace {

using PregenResult = tl::expected<PregenProgress, std::string>;

volatile std::sig_atomic_t interrupted = 0;

/// The first SIGINT or SIGTERM ends the work cleanly, the second ends the process.
void end_in_order_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

class Report {
 public:
  void operator()(const PregenProgress& progress) {
    const double part =
        progress.of == 0 ? 1 : static_cast<double>(progress.squares) / static_cast<double>(progress.of);
    bar_.show(part, progress.columns);
  }

 private:
  ProgressBar bar_{"pregen", "columns"};
};

/// The land is the running server's, so a configured world must be the same.
tl::expected<void, std::string> check_world(const Config& config) {
  if (config.world.empty()) return {};
  const auto file = config.data / "store.toml";
  const auto store = store::read_store_identity(file);
  if (!store) return tl::unexpected{store.error()};
  const auto world = load_secret_world(config.world, config.secret);
  if (!world) return tl::unexpected{world.error()};
  if ((*world)->fingerprint() == store->fingerprint) return {};
  return tl::unexpected{
      fmt::format("{}: the store that a talusd uses belongs to the world with fingerprint {}; {} has "
                  "fingerprint {}; give --world the store's world, or leave it out",
                  file.string(), to_string(store->fingerprint), config.world.string(),
                  to_string((*world)->fingerprint()))};
}

PregenResult by_server(StoreConnection& server, const Config& config, const PregenPlan& plan) {
  if (const auto same = check_world(config); !same) return tl::unexpected{same.error()};
  Report report;
  return server.pregen(plan, [&](const PregenProgress& progress) { report(progress); });
}

PregenResult by_itself(const Config& config, const PregenPlan& plan) {
  const auto world = load_secret_world(config.world, config.secret);
  if (!world) return tl::unexpected{world.error()};
  const auto columns = column_cache_settings(config, (*world)->fingerprint());
  if (!columns) return tl::unexpected{std::string{kNoColumnCache}};
  if (const auto may = check_may_write(config.data); !may) return tl::unexpected{may.error()};
  const auto directory = store::DataDirectory::open(config.data, (*world)->fingerprint());
  if (!directory) return tl::unexpected{directory.error()};
  const SystemClock clock;
  const Logger log = make_logger("warn", config.log.format);
  auto cache = ColumnCache::open(*columns, log, clock);
  if (!cache) return tl::unexpected{cache.error()};
  const PatchSize patch = measured_patch_size(config, **world, clock);
  Metrics metrics;
  MemoryBudget memory{config.limits.memory_bytes};
  const std::size_t threads = generator_threads(config);
  end_in_order_on_signals();
  Chunks chunks{
      std::make_unique<TerrainGenerator>(*world, patch.tiles, threads, ground_bytes(config, **world)),
      generation_settings(config, **world, patch),
      log,
      metrics,
      memory,
      clock,
      std::nullopt,
      *std::move(cache)};
  chunks.start();
  Pregen pregen{{chunks, [] { return false; }, clock, threads, pregen_file(*columns),
                 [&chunks] { chunks.keep_on_disk(); }}};
  Report report;
  const PregenResult ended = pregen.run(plan, [&](const PregenProgress& progress) {
    report(progress);
    while (!chunks.fit_caches()) {
    }
    return interrupted == 0;
  });
  return ended;
}

/// Parses X,Z in voxels.
bool parse_center(std::string_view text, PregenPlan& plan) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  const auto number = [](std::string_view digits, std::int32_t& into) {
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), into);
    return error == std::errc{} && stop == digits.data() + digits.size();
  };
  return number(text.substr(0, comma), plan.x) && number(text.substr(comma + 1), plan.z);
}

int pregen_failed(std::string_view line, int status = kFailed) {
  fmt::print(stderr, "talusd pregen: {}\n", on_one_line(line));
  return status;
}

}  // namespace

int pregen_command(int argc, const char* const* argv, const Environment& environment) {
  CLI::App app{
      "Fills the cache on disk with the land around a place, nearest first, so that players find it there. "
      "Goes "
      "on where it ended before, for the same center, radius and levels; what is on disk is not made again.",
      "talusd pregen"};
  app.footer(
      "If a talusd uses the data directory, that talusd makes the land, in time that no player waits for, "
      "until\n"
      "this command ends; else this command makes it. Columns that are cheap to make are made and not kept.\n"
      "Exit status: 0 everything is made, 1 something is not, 2 wrong flags.");
  PregenPlan plan;
  std::string data;
  std::string config_file;
  std::string world;
  std::string center = "0,0";
  app.add_option("--data", data, "the data directory; default: \"data\" of --config, or TALUS_DATA")
      ->type_name("DIR");
  app.add_option("--config", config_file, "the server's settings in TOML; default: no file")
      ->type_name("FILE");
  app.add_option("--world", world,
                 "the server's world; default: \"world\" of the settings. A running talusd refuses any other")
      ->type_name("FILE");
  app.add_option("--center", center, "the middle, in voxels")->capture_default_str()->type_name("X,Z");
  app.add_option("--radius", plan.radius, "voxels from the middle to each side")
      ->required()
      ->type_name("VOXELS");
  app.add_option("--levels", plan.levels, "levels of detail, from the finest: 1 to 7")
      ->capture_default_str()
      ->type_name("COUNT");
  app.add_option("--share", plan.share, "of the generators' time, 0.001 to 1")
      ->capture_default_str()
      ->type_name("SHARE");
  if (const auto exit = parse_flags(app, argc, argv)) {
    fmt::print(exit->status == 0 ? stdout : stderr, "{}", exit->text);
    return exit->status;
  }
  if (!parse_center(center, plan)) {
    return pregen_failed(fmt::format("--center: \"{}\" is wrong; give X,Z in voxels", escaped(center)),
                         kWrongUse);
  }
  if (const auto good = plan.check(); !good) return pregen_failed(good.error(), kWrongUse);
  Settings settings;
  if (!config_file.empty()) {
    if (const auto read = apply_file(settings, config_file); !read) return pregen_failed(read.error());
  }
  if (const auto read = apply_environment(settings, environment); !read) return pregen_failed(read.error());
  Config& config = settings.config;
  if (!data.empty()) config.data = data;
  if (!world.empty()) config.world = world;
  if (config.data.empty())
    return pregen_failed("the data directory is not set; give --data DIR, as talusd has it", kWrongUse);

  auto server = StoreConnection::open(config.data);
  if (!server) return pregen_failed(server.error());
  const PregenResult ended = *server ? by_server(**server, config, plan) : by_itself(config, plan);
  if (!ended) return pregen_failed(ended.error());
  fmt::print("{} of {} squares are made, {} columns of chunks in this run\n", ended->squares, ended->of,
             ended->columns);
  if (std::fflush(stdout) != 0) return pregen_failed("standard output: cannot write to it");
  return ended->squares == ended->of ? 0 : kFailed;
}

}  // namespace talus::server
