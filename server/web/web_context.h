// Objects and settings shared by players' HTTP connections.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "chunks/edited_land.h"
#include "config/allowed_origins.h"
#include "config/networks.h"
#include "net/admission.h"
#include "net/http/service.h"
#include "net/runner_context.h"
#include "web/recent_revisions.h"
#include "web/refused_origins.h"
#include "web/site.h"
#include "web/world_document.h"

namespace talus::server::web {

class WorldFiles;

struct WebSettings {
  bool public_chunks = false;  // chunks need no token, and every cache may keep them
  AllowedOrigins origins;
  Networks proxies;           // name their clients in X-Forwarded-For
  std::uint64_t log_every{};  // one in this many answers is logged; 0: off
};

/// `runner`'s context outlives the connections.
struct WebContext {
  RunnerContextPtr runner;
  const EditedLand* edits;  // null: no edits are stored
  WebSettings settings;
  Admission& admission;
  http::Service service;
  std::string fingerprint;              // as in paths
  std::string store_id;                 // as in paths
  std::atomic<std::uint64_t>& answers;  // number of answers on all connections, for the log
  std::atomic<std::uint64_t>& fetches;  // number of waits on all connections, for their ids
  RecentRevisions& recent_revisions;    // of `edits`
  std::shared_ptr<const Site> site;     // null: not served
  std::shared_ptr<WorldDocument> world;
  std::shared_ptr<const WorldFiles> world_files{};  // null: the world is not published
  std::shared_ptr<RefusedOrigins> refused_origins = std::make_shared<RefusedOrigins>();
};
using WebContextPtr = std::shared_ptr<const WebContext>;

}  // namespace talus::server::web
