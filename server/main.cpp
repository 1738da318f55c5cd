// talusd: streams an endless world, generated on demand, to game clients.
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "access/access_control.h"
#include "access/key_file.h"
#include "access/token_command.h"
#include "config/command_line.h"
#include "log/escape.h"
#include "log/logger.h"
#include "net/server.h"
#include "net/tls_context.h"
#include "privileges/account.h"
#include "privileges/privileges.h"
#include "store/data_directory.h"
#include "world_file.h"

#include <talus/vectors/instruction_set.h>

namespace {

using namespace talus::server;

int failed(const std::string& line) {
  fmt::print(stderr, "talusd: {}\n", line);
  return 1;
}

/// The user to switch to, if one is configured.
tl::expected<std::optional<Account>, std::string> configured_account(const Config& config) {
  if (config.user.empty()) return std::nullopt;
  return find_account(config.user).map([](Account account) { return std::optional{std::move(account)}; });
}

/// Switches user, if one is configured, and opens the data directory.
tl::expected<std::optional<DataDirectory>, std::string> drop_privileges_and_open_data(
    const Config& config, const std::optional<Account>& account, talus::ContentHash fingerprint) {
  if (account) {
    if (runs_as_root() && !config.data.empty()) {
      if (const auto made = DataDirectory::make_for(config.data, account->uid, account->gid); !made) {
        return tl::make_unexpected(made.error());
      }
    }
    if (const auto done = switch_user(*account); !done) return tl::make_unexpected(done.error());
  }
  if (config.data.empty()) return std::nullopt;
  auto data = DataDirectory::open(config.data, fingerprint);
  if (!data && account) {
    return tl::make_unexpected(fmt::format("{}; talusd runs as user {}", data.error(), account->name));
  }
  return std::move(data).map([](DataDirectory opened) { return std::optional{std::move(opened)}; });
}

/// Lines for the log: what an operator should know of how the server was started.
std::vector<std::string> warnings_of(const Command& command, const std::vector<std::string>& of_keys,
                                     const std::optional<TlsIdentity>& tls) {
  std::vector<std::string> warnings = command.warnings;
  warnings.insert(warnings.end(), of_keys.begin(), of_keys.end());
  const Config& config = command.config;
  if (tls && !tls->valid_now) {
    warnings.push_back(fmt::format("TLS with {}: clients will refuse it today", tls->description));
  }
  if (tls) {
    if (auto warning = open_to_others(config.tls.key)) warnings.push_back(*std::move(warning));
  }
  for (const auto& file : {config.access.secret_file, config.access.signing_key_file,
                           config.access.previous_signing_key_file, config.tls.certificate, config.tls.key}) {
    if (file.empty() || ::access(file.c_str(), R_OK) == 0) continue;
    warnings.push_back(
        fmt::format("{}: the user that talusd runs as cannot read it; a reload will keep the old one",
                    escaped(file.string(), 500)));
  }
  if (command.config.user.empty() && runs_as_root()) {
    warnings.emplace_back(
        "talusd runs as root and does not need to: set user in the configuration file or TALUS_USER, or "
        "start it as "
        "another user");
  }
  return warnings;
}

int serve(const Command& command) {
  const Config& config = command.config;
  const auto fail = [&](const std::string& line) { return failed(command.origins.locate(line)); };
  if (const auto done = set_no_new_privs(); !done) return fail(done.error());
  if (const auto set = talus::forced_instruction_set(); !set) return fail(std::string{set.error()});
  const auto world = load_world(config.world);
  if (!world) return fail(world.error());
  const auto account = configured_account(config);
  if (!account) return fail(account.error());
  auto keys = load_keys(config.access);
  if (!keys) return fail(keys.error());
  std::optional<TlsIdentity> tls;
  if (config.tls.wanted()) {
    auto loaded = load_tls(config.tls.certificate, config.tls.key);
    if (!loaded) return fail(loaded.error());
    tls = *std::move(loaded);
  }
  if (command.check_only) {
    for (const std::string& warning : warnings_of(command, keys->warnings, tls))
      fmt::print(stderr, "talusd: warning: {}\n", warning);
    fmt::print("ok\n");
    if (std::fflush(stdout) != 0) return fail("standard output: cannot write to it");
    return 0;
  }

  if (keys->any() || tls) hide_memory();
  const std::vector<std::string> of_keys = keys->warnings;
  AccessControl access{config.access, *std::move(keys)};
  const Logger log = make_logger(config.log.level, config.log.format);
  Server server{config, *world, access, tls, log};
  const auto address = server.listen();
  if (!address) return fail(address.error());
  const auto operators = server.listen_to_operators();
  if (!operators) return fail(operators.error());

  // Addresses and keys are what root may be needed for. No thread runs yet.
  const auto data = drop_privileges_and_open_data(config, *account, (*world)->fingerprint());
  if (!data) return fail(data.error());
  if (*data) server.keep_in((*data)->store_id());

  for (const std::string& warning : warnings_of(command, of_keys, tls)) log->warn("{}", warning);
  log->info("world {}, generator {} with {} kernels", to_string((*world)->fingerprint()),
            talus::terrain::kGeneratorVersion, to_string(talus::instruction_set()));
  if (tls && tls->valid_now) log->info("TLS with {}", tls->description);
  // On its own and whatever the log level: programs that start a server read this line.
  fmt::print("listening on {}\n", *address);
  if (!operators->empty()) fmt::print("metrics and health on http://{}\n", *operators);
  std::fflush(stdout);
  server.run();
  log->info("ended");
  return 0;
}

int print_token(int argc, const char* const* argv) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const auto token = token_command(argc, argv, now);
  fmt::print(token || token.error().status == 0 ? stdout : stderr, "{}",
             token ? *token + "\n" : token.error().text);
  if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it");
  return token ? 0 : token.error().status;
}

/// What writes and patches gave back serves the next ones. By default glibc hands the top of its heaps to the
/// system from 128 KiB on, and a page fault for every 4 KiB of it costs more than an answer does.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMebibyte = 1 << 20;
  ::mallopt(M_TRIM_THRESHOLD, kMebibyte);
  ::mallopt(M_MMAP_THRESHOLD, kMebibyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  // A log whose reader went away must not end the server.
  std::signal(SIGPIPE, SIG_IGN);
  // A reload may be asked for before there is anything to read again.
  std::signal(SIGHUP, SIG_IGN);
  try {
    if (argc > 1 && std::string_view{argv[1]} == "token") return print_token(argc - 1, argv + 1);
    const auto command = read_command_line(argc, argv, process_environment());
    if (command) return serve(*command);
    fmt::print(command.error().status == 0 ? stdout : stderr, "{}", command.error().text);
    if (std::fflush(stdout) != 0) return failed("standard output: cannot write to it");
    return command.error().status;
  } catch (const std::exception& error) {
    return failed(fmt::format("unexpected: {}", error.what()));
  }
}
