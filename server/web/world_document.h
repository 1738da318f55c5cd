// The answer of /v1/world, made once for each change of the rates or of the edits' revision: it costs no more
// than a chunk in memory.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "chunks/edited_land.h"
#include "limits/rates/rates.h"
#include "net/http/response.h"
#include "player/session/session_limits.h"
#include "player/session/world_info.h"
#include "web/documents.h"

namespace talus::server::web {

/// Callable from any thread.
class WorldDocument {
 public:
  struct Text {
    std::string body;
    http::EntityTag tag;
  };

  /// All arguments outlive it. `edits` null: no edits are stored.
  WorldDocument(const WorldInfo& world, const SessionLimits& limits, const EditedLand* edits)
      : world_{world}, limits_{limits}, edits_{edits} {}

  [[nodiscard]] std::shared_ptr<const Text> get(const RateLimits& rates);

 private:
  const WorldInfo& world_;
  const SessionLimits& limits_;
  const EditedLand* const edits_;
  std::mutex mutex_;
  std::optional<RateLimits> rates_;  // of base_
  std::string base_;                 // without the edit status
  EditsNow edits_now_;               // of text_
  std::shared_ptr<const Text> text_;
};

}  // namespace talus::server::web
