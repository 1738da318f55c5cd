#include "web/world_files.h"

#include <utility>

#include <fmt/format.h>

#include "web/columns_body.h"
#include "web/documents.h"
#include "web/entity_tag.h"

namespace talus::server::web {
namespace {

http::Response file_response(Exchange& exchange, const FileRoute& route, const WorldFiles::File& file) {
  http::Response response{200, route.name.empty() ? "application/toml" : kBytes};
  response.cache_control = immutable_for(exchange.audience);
  response.kept = file.bytes;
  tag(exchange.request(), response, file.tag);
  return response;
}

}  // namespace

std::string world_file_path(ContentHash fingerprint) {
  return fmt::format("/v1/{}/world.toml", to_string(fingerprint));
}

WorldFiles::WorldFiles(std::shared_ptr<const PublishedWorld> world) : world_{std::move(world)} {
  files_.emplace("", File{world_->spec, entity_tag(world_->spec)});
  for (const auto& [name, bytes] : world_->files) files_.emplace(name, File{bytes, entity_tag(bytes)});
}

const WorldFiles::File* WorldFiles::find(std::string_view name) const {
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : &found->second;
}

Answer answer_now(Exchange& exchange, const FileRoute& route) {
  const WebContext& context = exchange.context();
  if (auto wrong = check_world(context, route.fingerprint)) return wrong;
  const WorldFiles::File* const file =
      context.world_files == nullptr ? nullptr : context.world_files->find(route.name);
  if (file == nullptr) {
    return error_response(404, wire::ErrorCode::malformed,
                          context.world_files == nullptr
                              ? "no such path: this server's world is not published"
                              : "no such path: the world's file names no such file");
  }
  if (exchange.requester().next_chunk(exchange.began()) > exchange.began()) return std::nullopt;
  return file_response(exchange, route, *file);
}

// For clients over their rates.
asio::awaitable<http::Response> answer_later(Exchange& exchange, const FileRoute& route) {
  if (auto wrong = co_await exchange.requester().wait_for_rates(exchange.executor())) {
    co_return *std::move(wrong);
  }
  co_return file_response(exchange, route, *exchange.context().world_files->find(route.name));
}

}  // namespace talus::server::web
