#include "app/startup.h"

#include <unistd.h>

#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>

#include "config/access/key_file.h"
#include "runtime/log/escape.h"
#include "runtime/privileges/privileges.h"

namespace talus::server {

tl::expected<std::optional<Account>, std::string> configured_account(const Config& config) {
  if (config.user.empty()) return std::nullopt;
  return find_account(config.user).map([](Account account) { return std::optional{std::move(account)}; });
}

tl::expected<std::optional<store::DataDirectory>, std::string> drop_privileges_and_open_data(
    const Config& config, const std::optional<Account>& account, ContentHash fingerprint) {
  if (account) {
    if (runs_as_root() && !config.data.empty()) {
      if (const auto made = store::DataDirectory::make_for(config.data, account->uid, account->gid); !made) {
        return tl::make_unexpected(made.error());
      }
    }
    if (const auto done = switch_user(*account); !done) return tl::make_unexpected(done.error());
  }
  if (config.data.empty()) return std::nullopt;
  auto data = config.cluster.wanted() ? store::DataDirectory::open_member(config.data, fingerprint)
                                      : store::DataDirectory::open(config.data, fingerprint);
  if (!data && account) {
    return tl::make_unexpected(fmt::format("{}; talusd runs as user {}", data.error(), account->name));
  }
  return std::move(data).map([](store::DataDirectory opened) { return std::optional{std::move(opened)}; });
}

void note_world(const Config& config, const terrain::World& world, LogWriter& log) {
  constexpr std::size_t kMaxBytes = 8192;
  const std::string text = fmt::format(
      "{}, seed {}, fingerprint {}\n", config.world.empty() ? "the built-in world" : config.world.string(),
      static_cast<std::int64_t>(world.spec().seed), to_string(world.fingerprint()));
  const auto file = config.data / "world.txt";
  if (const auto held = files::read_regular_file(file, kMaxBytes); held && *held == text) return;
  if (const auto written = files::write_file(file, std::string_view{text}); !written) {
    log.warn("{}", written.error().message());
  }
}

std::vector<std::string> startup_warnings(const Command& command, const std::vector<std::string>& of_keys,
                                          const std::optional<TlsIdentity>& tls, const ServedWorld& world) {
  std::vector<std::string> warnings = command.warnings;
  warnings.insert(warnings.end(), of_keys.begin(), of_keys.end());
  const Config& config = command.config;
  if (tls && !tls->valid_now) {
    warnings.push_back(fmt::format("TLS with {}: clients will refuse it today", tls->description));
  }
  if (tls) {
    if (auto warning = open_to_others(config.tls.key)) warnings.push_back(*std::move(warning));
  }
  for (const auto& file :
       {config.access.secret_file, config.access.signing_key_file, config.access.previous_signing_key_file,
        config.access.revoked_file, config.access.blocked_file, config.tls.certificate, config.tls.key}) {
    if (file.empty() || ::access(file.c_str(), R_OK) == 0) continue;
    warnings.push_back(
        fmt::format("{}: the user that talusd runs as cannot read it; a reload will keep the old one",
                    escaped(file.string(), 500)));
  }
  if (!world.withheld.empty()) {
    warnings.push_back(
        fmt::format("publish: the world is not published, as clients cannot make it without \"{}\", a height "
                    "map over 1 MiB; set publish_files = true, or publish = \"none\"",
                    escaped(world.withheld, 200)));
  }
  if (!config.http.web.empty() && !config.http.listen) {
    warnings.emplace_back("http.web: nothing is served without an address; give --http HOST:PORT");
  }
  if (command.config.user.empty() && runs_as_root()) {
    warnings.emplace_back(
        "talusd runs as root and does not need to: set user in the configuration file or TALUS_USER, or "
        "start "
        "it as another user");
  }
  return warnings;
}

}  // namespace talus::server
