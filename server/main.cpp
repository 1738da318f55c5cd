// talusd: streams an endless world, generated on demand, to game clients.
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>

#include <fmt/format.h>

#include "config/command_line.h"
#include "log/logger.h"
#include "net/server.h"
#include "net/tls_context.h"
#include "store/data_directory.h"
#include "world_file.h"

#include <talus/vectors/instruction_set.h>

namespace {

using namespace talus::server;

int failed(const std::string& line) {
  fmt::print(stderr, "talusd: {}\n", line);
  return 1;
}

int serve(const Command& command) {
  const Config& config = command.config;
  if (const auto set = talus::forced_instruction_set(); !set) return failed(std::string{set.error()});
  const auto world = load_world(config.world);
  if (!world) return failed(world.error());
  std::optional<TlsIdentity> tls;
  if (config.tls.wanted()) {
    auto loaded = load_tls(config.tls.certificate, config.tls.key);
    if (!loaded) return failed(loaded.error());
    tls = *std::move(loaded);
  }
  if (command.check_only) {
    for (const std::string& warning : command.warnings) fmt::print(stderr, "talusd: warning: {}\n", warning);
    fmt::print("ok\n");
    if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it");
    return 0;
  }

  std::optional<DataDirectory> data;
  if (!config.data.empty()) {
    auto opened = DataDirectory::open(config.data, (*world)->fingerprint());
    if (!opened) return failed(opened.error());
    data.emplace(*std::move(opened));
  }
  const Logger log = make_logger(config.log.level, config.log.format);
  Server server{config, *world, data ? data->store_id() : talus::ContentHash{}, tls, log};
  const auto address = server.listen();
  if (!address) return failed(address.error());
  const auto operators = server.listen_to_operators();
  if (!operators) return failed(operators.error());

  for (const std::string& warning : command.warnings) log->warn("{}", warning);
  log->info("world {}, generator {} with {} kernels", to_string((*world)->fingerprint()),
            talus::terrain::kGeneratorVersion, to_string(talus::instruction_set()));
  if (tls && tls->valid_now) log->info("TLS with {}", tls->description);
  if (tls && !tls->valid_now) log->warn("TLS with {}: clients will refuse it today", tls->description);
  // On its own and whatever the log level: programs that start a server read this line.
  fmt::print("listening on {}\n", *address);
  if (!operators->empty()) fmt::print("metrics and health on http://{}\n", *operators);
  std::fflush(stdout);
  server.run();
  log->info("ended");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // A log whose reader went away must not end the server.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const auto command = read_command_line(argc, argv, process_environment());
    if (command) return serve(*command);
    fmt::print(command.error().status == 0 ? stdout : stderr, "{}", command.error().text);
    return command.error().status;
  } catch (const std::exception& error) {
    return failed(fmt::format("unexpected: {}", error.what()));
  }
}
