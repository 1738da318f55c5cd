#include "web/world_document.h"

#include <utility>

#include "web/entity_tag.h"

namespace talus::server::web {

std::shared_ptr<const WorldDocument::Text> WorldDocument::get(const RateLimits& rates) {
  const EditsNow now = edits_ == nullptr ? EditsNow{} : EditsNow{edits_->takes_edits(), edits_->revision()};
  const std::lock_guard lock{mutex_};
  if (rates_ != rates || edits_now_ != now) {
    if (rates_ != rates) base_ = world_document(world_, limits_, rates);
    std::string body = with_edits(base_, now);
    const http::EntityTag tag = entity_tag(body);
    text_ = std::make_shared<const Text>(Text{std::move(body), tag});
    rates_ = rates;
    edits_now_ = now;
  }
  return text_;
}

}  // namespace talus::server::web
