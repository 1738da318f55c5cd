#include "web/heights_answers.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "chunks/heights_query.h"
#include "net/http/query.h"
#include "player/session/heights_check.h"
#include "runtime/log/escape.h"
#include "web/documents.h"

namespace talus::server::web {
namespace {

using wire::ErrorCode;

/// Appends the number of the field with this name; returns false if the world does not have it.
bool add_field(const WorldInfo& world, std::string_view name, std::vector<std::uint8_t>& numbers) {
  const auto found = std::find(world.fields.begin(), world.fields.end(), name);
  if (found == world.fields.end()) return false;
  numbers.push_back(static_cast<std::uint8_t>(found - world.fields.begin()));
  return true;
}

/// Returns the query of the route, or the name of a field that the world does not have.
tl::expected<HeightsQuery, std::string> query_of(const HeightsRoute& route, const WorldInfo& world) {
  HeightsQuery query{route.columns, route.looks, {}};
  for (const std::string& names : route.fields) {
    if (add_field(world, names, query.fields)) continue;
    for (const std::string_view name : http::split(names, ',', 64)) {
      if (!add_field(world, name, query.fields)) return tl::make_unexpected(std::string{name});
    }
  }
  return query;
}

/// Returns the function that writes the answer. Writing tens of thousands of numbers takes milliseconds, for
/// which other connections should not wait.
HeightsBody body_of(const HeightsRoute& route, const HeightsQuery& query, const WorldInfo& world) {
  const auto width = static_cast<std::size_t>(route.width);
  if (route.npy) return [width](const HeightsResult& found) { return heights_npy(width, found); };
  HeightsForm form{width, {}, {}};
  for (const std::uint8_t field : query.fields) form.fields.push_back(world.fields[field]);
  if (route.looks) form.looks = world.looks;
  return [form = std::move(form)](const HeightsResult& found) { return heights_document(form, found); };
}

}  // namespace

Answer answer_now(Exchange& exchange, const HeightsRoute& route) {
  const SessionContext& shared = exchange.shared();
  const auto query = query_of(route, shared.world);
  if (!query) {
    return error_response(
        400, ErrorCode::out_of_range,
        fmt::format("fields: this world has no '{}'; /v1/world lists them", escaped(query.error(), 40)));
  }
  if (route.columns.size() > shared.limits.heights_per_request) {
    return error_response(400, ErrorCode::too_large,
                          fmt::format("columns: at most {} at once", shared.limits.heights_per_request));
  }
  if (const auto checked = check_query(*query, shared.limits, shared.world.fields.size()); !checked) {
    return error_response(400, checked.error().code, checked.error().text);
  }
  return std::nullopt;
}

asio::awaitable<http::Response> answer_later(Exchange& exchange, const HeightsRoute& route) {
  constexpr std::size_t kColumnBytes = 64;
  const SessionContext& shared = exchange.shared();
  auto query = query_of(route, shared.world);
  const std::size_t bytes = route.columns.size() * (kColumnBytes + 2 * sizeof(float) * query->fields.size());
  if (!exchange.takes_work(bytes)) co_return no_memory();
  exchange.hold(bytes);
  query->body = body_of(route, *query, shared.world);
  auto found = co_await exchange.start_fetch().heights(*std::move(query), exchange.deadline());
  if (!found) co_return fetch_failed(found.error(), shared.memory);
  co_return http::Response{200, route.npy ? "application/octet-stream" : kJson, std::move(found->body)};
}

}  // namespace talus::server::web
