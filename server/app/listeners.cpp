#include "app/listeners.h"

#include <utility>

#include <fmt/format.h>

#include "app/settings.h"

namespace talus::server {

tl::expected<Listeners, std::string> open_listeners(const Config& config, const Clock& clock,
                                                    const Logger& log) {
  const auto failed = [](std::string_view setting, const protocol::Endpoint& endpoint,
                         const std::string& why) {
    return tl::make_unexpected(fmt::format("{} {}: {}; choose another address with --{} HOST:PORT", setting,
                                           to_string(endpoint), why, setting));
  };
  Listeners listeners;
  listeners.io = std::make_unique<IoPool>(io_threads(config), log);
  listeners.players = std::make_unique<Acceptor>(listeners.io->control(), log, clock);
  auto address = listeners.players->listen(config.listen);
  if (!address) return failed("listen", config.listen, address.error());
  listeners.players_address = *std::move(address);
  if (config.http.listen) {
    listeners.web = std::make_unique<Acceptor>(listeners.io->control(), log, clock);
    address = listeners.web->listen(*config.http.listen);
    if (!address) return failed("http", *config.http.listen, address.error());
    listeners.web_address = *std::move(address);
  }
  if (config.admin) {
    listeners.operators = std::make_unique<AdminServer>(clock, log);
    address = listeners.operators->listen(*config.admin);
    if (!address) return failed("admin", *config.admin, address.error());
    listeners.operators_address = *std::move(address);
  }
  return listeners;
}

}  // namespace talus::server
