// Opens the listening sockets while the process may still be root. No thread runs yet.
#pragma once

#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "admin/admin_server.h"
#include "config/config.h"
#include "net/acceptor.h"
#include "net/io_pool.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server {

struct Listeners {
  std::unique_ptr<IoPool> io;
  std::unique_ptr<Acceptor> players;  // on io->control()
  std::string players_address;        // with the real port
  std::unique_ptr<Acceptor> web;      // on io->control(); null: not configured
  std::string web_address;
  std::unique_ptr<AdminServer> operators;  // null: not configured
  std::string operators_address;
};

/// `clock` must outlive the listeners. An error is one line.
[[nodiscard]] tl::expected<Listeners, std::string> open_listeners(const Config& config, const Clock& clock,
                                                                  const Logger& log);

}  // namespace talus::server
