#include "web/edits_answers.h"

#include "web/columns_body.h"

namespace talus::server::web {

Answer answer_now(Exchange& exchange, const EditsRoute& route) {
  if (auto wrong = check_world(exchange.context(), route.fingerprint)) return wrong;
  if (auto wrong = check_store(exchange.context(), route.store)) return wrong;
  http::Response response{200, kBytes};
  append_edited_columns(response.body, exchange.context().edits->edited_columns(route.region));
  response.cache_control = revalidated_for(exchange.audience);
  tag(exchange.request(), response);
  return response;
}

}  // namespace talus::server::web
