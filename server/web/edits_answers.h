// Answers for the edited columns of a region over HTTP. Source: PROTOCOL.md, "Edited land".
#pragma once

#include "net/http/response.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// Never returns nullopt.
[[nodiscard]] Answer answer_now(Exchange& exchange, const EditsRoute& route);

}  // namespace talus::server::web
