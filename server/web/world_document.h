// What /v1/world answers, made once for the rates that apply: asking for it costs no more than a chunk in
// memory.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "rates/rates.h"
#include "session/session_limits.h"
#include "session/world_info.h"

namespace talus::server::web {

/// Callable from any thread.
class WorldDocument {
 public:
  struct Text {
    std::string body;
    std::string tag;
  };

  /// Both outlive it.
  WorldDocument(const WorldInfo& world, const SessionLimits& limits) : world_{world}, limits_{limits} {}

  [[nodiscard]] std::shared_ptr<const Text> get(const RateLimits& rates);

 private:
  const WorldInfo& world_;
  const SessionLimits& limits_;
  std::mutex mutex_;
  std::optional<RateLimits> rates_;  // of text_
  std::shared_ptr<const Text> text_;
};

}  // namespace talus::server::web
