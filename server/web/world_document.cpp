#include "web/world_document.h"

#include <utility>

#include "web/documents.h"
#include "web/entity_tag.h"

namespace talus::server::web {

std::shared_ptr<const WorldDocument::Text> WorldDocument::get(const RateLimits& rates) {
  const std::lock_guard lock{mutex_};
  if (rates_ != rates) {
    std::string body = world_document(world_, limits_, rates);
    std::string tag = entity_tag(body);
    text_ = std::make_shared<const Text>(Text{std::move(body), std::move(tag)});
    rates_ = rates;
  }
  return text_;
}

}  // namespace talus::server::web
