#include "app/program.h"

#include <malloc.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <talus/local/settle_rules.h>

#include "admin/top_command.h"
#include "app/cluster_member.h"
#include "app/joining_page.h"
#include "app/listeners.h"
#include "app/lost_store.h"
#include "app/pregen_command.h"
#include "app/process_signals.h"
#include "app/secret_world.h"
#include "app/server.h"
#include "app/settings.h"
#include "app/startup.h"
#include "app/world_edits.h"
#include "app/world_file.h"
#include "cluster/jetstream/nats_threads.h"
#include "commands/cluster/cluster_command.h"
#include "commands/store/store_command.h"
#include "config/access/access_control.h"
#include "config/access/key_file.h"
#include "config/access/token_command.h"
#include "config/cluster_check.h"
#include "config/command_line.h"
#include "config/secret_layers.h"
#include "net/descriptors.h"
#include "net/tls_context.h"
#include "runtime/clock.h"
#include "runtime/log/escape.h"
#include "runtime/log/logger.h"
#include "runtime/log/program_line.h"
#include "runtime/privileges/privileges.h"
#include "runtime/signals.h"
#include "web/site.h"

#include <talus/build_version.h>
#include <talus/files/standard_descriptors.h>
#include <talus/vectors/instruction_set.h>

namespace {

using namespace talus::server;

int failed(std::string_view line, std::string_view format = "text") {
  fmt::print(stderr, "{}", program_line(format, LogLevel::error, line));
  return kFailed;
}

/// Returns the error line for an exception that ends the program: mostly the system refused a resource.
std::string line_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return "out of memory; let the process have more (ulimit -v, a container's limit), or lower "
           "limits.memory_bytes";
  }
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  const int code = system == nullptr ? 0 : system->code().value();
  if (code == EAGAIN) {
    return "a thread cannot start; let the process have more threads (ulimit -u, a container's limit) or "
           "memory (ulimit -v), or lower threads.io and threads.generator";
  }
  if (code == EMFILE || code == ENFILE) return "too many open files; raise ulimit -n";
  return fmt::format("unexpected: {}", error.what());
}

/// Log format known before the settings are read.
std::string format_of(const Environment& environment) {
  const auto set = environment.find("TALUS_LOG_FORMAT");
  return set == environment.end() ? Config{}.log.format : set->second;
}

/// Strips "talusd: " and the newline from an error about flags or settings.
std::string_view line_of(const Exit& exit) {
  std::string_view line{exit.text};
  constexpr std::string_view kBefore{"talusd: "};
  if (line.starts_with(kBefore)) line.remove_prefix(kBefore.size());
  if (line.ends_with('\n')) line.remove_suffix(1);
  return line;
}

int serve(const Command& command, const ReadSettings& read_settings) {
  const Config& config = command.config;
  const auto fail = [&](const std::string& line) {
    return failed(command.origins.locate(line), config.log.format);
  };
  const SystemClock clock;
  if (const auto done = set_no_new_privs(); !done) return fail(done.error());
  if (const auto set = talus::forced_instruction_set(); !set) return fail(std::string{set.error()});
  if (const auto enough = check_memory(config); !enough) return fail(enough.error());
  if (const auto member = check_member(config); !member) return fail(member.error());
  const auto secret = load_secret_key(config.secret);
  if (!secret) return fail(secret.error());
  auto served = load_served_world(config);
  if (!served) return fail(served.error());
  if (auto kept = with_secrets(served->world, *secret)) {
    served->world = *std::move(kept);
  } else {
    return fail(kept.error());
  }
  if (*secret && config.publish != "none") {
    return fail(
        "publish: clients cannot make a world with [secret]; set publish to none, or leave [secret] out");
  }
  const std::shared_ptr<const talus::terrain::World>& world = served->world;
  const auto account = configured_account(config);
  if (!account) return fail(account.error());
  auto keys = load_keys(config.access);
  if (!keys) return fail(keys.error());
  if (*secret && (*secret)->warning) keys->warnings.push_back(*(*secret)->warning);
  std::optional<ClusterKeys> cluster;
  if (config.cluster.wanted()) {
    auto read = load_cluster_keys(config.cluster);
    if (!read) return fail(read.error());
    keys->warnings.insert(keys->warnings.end(), read->warnings.begin(), read->warnings.end());
    cluster.emplace(*std::move(read));
  }
  std::optional<TlsIdentity> tls;
  if (config.tls.wanted()) {
    auto loaded = load_tls(config.tls.certificate, config.tls.key, clock.wall());
    if (!loaded) return fail(loaded.error());
    tls = *std::move(loaded);
  }
  std::shared_ptr<const web::Site> site;
  if (!config.http.web.empty()) {
    auto read = web::Site::read(config.http.web);
    if (!read) return fail(fmt::format("http.web: {}", read.error()));
    site = *std::move(read);
  }
  const std::uint64_t site_bytes = files_bytes(site.get(), served->published.get());
  if (const auto enough = check_memory(config, site_bytes); !enough) return fail(enough.error());
  if (command.check_only) {
    for (const std::string& warning : startup_warnings(command, keys->warnings, tls, *served))
      fmt::print(stderr, "{}", program_line(config.log.format, LogLevel::warn, warning));
    if (served->published != nullptr)
      fmt::print(stderr, "{}", program_line(config.log.format, LogLevel::info, kPublicationNote));
    fmt::print("ok\n");
    if (std::fflush(stdout) != 0) return fail("standard output: cannot write to it");
    return 0;
  }

  if (keys->any() || *secret || tls || (cluster && (cluster->nats->any() || cluster->peers_token))) {
    if (const auto hidden = hide_memory(); !hidden) return fail(hidden.error());
  }
  if (const auto allowed = raise_descriptor_limit(descriptors_wanted(config)); allowed < kMinDescriptors) {
    return fail(fmt::format("the system allows {} open files; talusd needs at least {}; raise ulimit -n",
                            allowed, kMinDescriptors));
  }
  const std::vector<std::string> of_keys = keys->warnings;
  AccessControl access{config.access, *std::move(keys)};
  const Logger log = make_logger(config.log.level, config.log.format);
  auto listeners = open_listeners(config, clock, log);
  if (!listeners) return fail(listeners.error());
  // Only binding addresses and reading keys may need root. No thread runs yet.
  auto data = drop_privileges_and_open_data(config, *account, world->fingerprint());
  if (!data) return fail(data.error());
  std::unique_ptr<WorldEdits> edits;
  const auto lost = std::make_shared<LostStore>(config.data, !config.cluster.peers.empty(), log);
  SharedLog shared;
  if (cluster) {
    const auto progress = std::make_shared<JoinProgress>();
    if (listeners->operators != nullptr) listeners->operators->start(joining_answers(progress));
    auto prepared = prepare_member(
        config.cluster, *cluster, **data, world->fingerprint(),
        [&](std::uint64_t done, std::uint64_t total) {
          progress->done = done;
          progress->total = total;
        },
        [&](const std::optional<talus::server::AsideStore>& aside) { progress->put_aside(aside); }, log);
    if (!prepared) return fail(prepared.error());
    shared = {
        std::move(prepared->stream), prepared->joins,
        [lost](talus::server::cluster::StoreLoss how, const std::string& reason) { lost->lose(how, reason); },
        [lost](const std::string& reason) { lost->start_again(reason); }};
  }
  if (*data) {
    // Opening a large store takes time; a signal ends the process meanwhile.
    auto opened = without_signals([&] {
      const talus::store::HistoryLimits history{config.edits.history_bytes,
                                                std::chrono::days{config.edits.history_days}};
      return WorldEdits::open(config.data, *world, (*data)->store_id(), clock, log,
                              edit_state_settings(config, site_bytes), history,
                              store_memory(config, site_bytes), std::move(shared));
    });
    if (!opened) return fail(opened.error());
    edits = *std::move(opened);
    note_world(config, *world, *log);
    const auto fits = check_index_memory(config, edits->state().index().bytes(), site_bytes);
    if (!fits) return fail(fits.error());
  }
  std::unique_ptr<ColumnCache> columns;
  if (const auto settings = column_cache_settings(config, world->fingerprint())) {
    auto opened = without_signals([&] { return ColumnCache::open(*settings, log, clock); });
    // Only a cache: players are served without it.
    if (opened) {
      columns = *std::move(opened);
    } else {
      log->warn("{}; going on without it", opened.error());
    }
  }
  const std::string address = listeners->players_address;
  const std::string web_address = listeners->web_address;
  const std::string operators_address = listeners->operators_address;
  Server server{config,
                *served,
                edits ? edits->store_id() : talus::ContentHash{},
                access,
                tls,
                *std::move(listeners),
                clock,
                log,
                command.has_file ? read_settings : ReadSettings{},
                site,
                std::move(edits),
                std::move(columns)};

  for (const std::string& warning : startup_warnings(command, of_keys, tls, *served))
    log->warn("{}", warning);
  if (served->published != nullptr) log->info("{}", kPublicationNote);
  if (!*data) log->info("edits are not taken: the data directory is not set; give --data DIRECTORY");
  log->info("world {}, generator {} with {} kernels", to_string(world->fingerprint()),
            to_integer(world->generator_version()), to_string(talus::instruction_set()));
  if (tls && tls->valid_now) log->info("TLS with {}", tls->description);
  // Printed alone, at every log level: programs that start a server parse this line.
  fmt::print("listening on {}\n", address);
  if (!web_address.empty()) {
    if (site != nullptr)
      log->info("{}: {} files at /", escaped(config.http.web.string(), 300), site->files());
    fmt::print("HTTP and WebSocket on {}://{}\n", tls && config.http.tls ? "https" : "http", web_address);
  }
  if (!operators_address.empty()) fmt::print("metrics and health on http://{}\n", operators_address);
  std::fflush(stdout);
  lost->serving();
  server.end_where([lost] { return lost->wants_end(); });
  server.run();
  log->info("ended");
  return lost->wants_end() ? kStartAgain : 0;
}

int print_token(int argc, const char* const* argv) {
  const auto token = token_command(argc, argv, SystemClock{}.wall());
  fmt::print(token || token.error().status == 0 ? stdout : stderr, "{}",
             token ? *token + "\n" : token.error().text);
  if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it");
  return token ? 0 : token.error().status;
}

int show_top(int argc, const char* const* argv, const Environment& environment) {
  const auto command = read_top_command(argc, argv, environment);
  if (!command) {
    fmt::print(command.error().status == 0 ? stdout : stderr, "{}", command.error().text);
    if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it");
    return command.error().status;
  }
  constexpr std::string_view kHomeAndErase{"\x1b[H\x1b[J"};
  const bool terminal = ::isatty(STDOUT_FILENO) != 0;
  for (;;) {
    const auto page = fetch_flows(command->admin);
    if (!page) {
      fmt::print(stderr, "talusd top: {}\n", page.error());
      return kFailed;
    }
    fmt::print("{}{}", terminal ? kHomeAndErase : std::string_view{}, *page);
    if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it");
    if (!terminal) return 0;
    std::this_thread::sleep_for(command->interval);
  }
}

/// First message of a new world's stream.
tl::expected<cluster::Genesis, std::string> first_message(const Config& config,
                                                          const talus::ContentHash& store_id) {
  const auto world = load_secret_world(config.world, config.secret);
  if (!world) return tl::make_unexpected(world.error());
  cluster::Genesis genesis;
  genesis.identity = {store_id, (*world)->fingerprint()};
  genesis.settles = talus::local::settle_rules(**world);
  return genesis;
}

/// Keeps memory freed by writes and patches for the next ones. By default glibc returns the top of its heaps
/// to the system from 128 KiB on, and a page fault per 4 KiB costs more than an answer.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMebibyte = 1 << 20;
  ::mallopt(M_TRIM_THRESHOLD, kMebibyte);
  ::mallopt(M_MMAP_THRESHOLD, kMebibyte);
#endif
}

}  // namespace

int talus::server::run_program(int argc, char** argv) {
  talus::files::open_closed_standard_descriptors();
  end_at_once_on_signals();
  // Writing to a closed log must not end the server.
  std::signal(SIGPIPE, SIG_IGN);
  keep_freed_memory();
  const jetstream::NatsThreads nats_threads;
  std::string log_format = "text";
  try {
    const Environment environment = process_environment();
    log_format = format_of(environment);
    if (argc > 1 && std::string_view{argv[1]} == "token") {
      end_by_default_on_signals();
      return print_token(argc - 1, argv + 1);
    }
    if (argc > 1 && std::string_view{argv[1]} == "top") {
      end_by_default_on_signals();
      return show_top(argc - 1, argv + 1, environment);
    }
    if (argc > 1 && std::string_view{argv[1]} == "store") {
      end_by_default_on_signals();
      return store_command(argc - 1, argv + 1, environment, load_secret_world, cluster_tools());
    }
    if (argc > 1 && std::string_view{argv[1]} == "cluster") {
      end_by_default_on_signals();
      return cluster_command(argc - 1, argv + 1, environment, first_message);
    }
    if (argc > 1 && std::string_view{argv[1]} == "pregen") {
      end_by_default_on_signals();
      return pregen_command(argc - 1, argv + 1, environment);
    }
    const auto command = read_command_line(argc, argv, environment, talus::kBuildVersion);
    if (command) {
      log_format = command->config.log.format;
      if (command->check_only) end_by_default_on_signals();
      return serve(*command, [&]() -> tl::expected<Config, std::string> {
        const auto again = read_command_line(argc, argv, environment, talus::kBuildVersion);
        if (!again) return tl::make_unexpected(std::string{line_of(again.error())});
        const auto enough = check_memory(again->config);
        if (!enough) return tl::make_unexpected(again->origins.locate(enough.error()));
        return again->config;
      });
    }
    if (command.error().status != 0) {
      fmt::print(stderr, "{}", program_line(log_format, LogLevel::error, line_of(command.error())));
    } else {
      fmt::print("{}", command.error().text);
      if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it", log_format);
    }
    return command.error().status;
  } catch (const std::exception& error) {
    return failed(line_of(error), log_format);
  }
}
