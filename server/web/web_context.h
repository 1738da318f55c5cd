// What players' HTTP connections share.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "chunks/chunk_source.h"
#include "chunks/edited_land.h"
#include "config/allowed_origins.h"
#include "config/networks.h"
#include "net/admission.h"
#include "net/http/service.h"
#include "net/session_runner.h"
#include "web/recent_revisions.h"
#include "web/site.h"
#include "web/world_document.h"

namespace talus::server::web {

struct WebSettings {
  bool public_chunks = false;  // chunks need no token, and every cache may keep them
  AllowedOrigins origins;
  Networks proxies;           // who names its clients in X-Forwarded-For
  std::uint64_t log_every{};  // answers, of which one is logged; 0: none
};

/// `runner`'s context outlives the connections.
struct WebContext {
  RunnerContextPtr runner;
  ChunkSource& chunks;      // as generated; those of sessions have their edits
  const EditedLand* edits;  // of those; null: none are stored
  WebSettings settings;
  Admission& admission;
  http::Service service;
  std::string fingerprint;              // as paths have it
  std::string store_id;                 // likewise
  std::atomic<std::uint64_t>& answers;  // of all connections, for the log
  std::atomic<std::uint64_t>& fetches;  // that ever waited, for their ids
  RecentRevisions& recent_revisions;    // of `edits`
  std::shared_ptr<const Site> site;     // null: none
  std::shared_ptr<WorldDocument> world;
};
using WebContextPtr = std::shared_ptr<const WebContext>;

}  // namespace talus::server::web
