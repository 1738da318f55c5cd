// A published world's files, as HTTP serves them. Immutable.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <talus/voxel/content_hash.h>

#include "net/http/response.h"
#include "player/session/published_world.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// Path of the spec: "/v1/{fingerprint}/world.toml".
[[nodiscard]] std::string world_file_path(ContentHash fingerprint);

class WorldFiles {
 public:
  /// `world` is not null.
  explicit WorldFiles(std::shared_ptr<const PublishedWorld> world);

  struct File {
    std::string_view bytes;
    http::EntityTag tag;
  };
  /// The spec if `name` is empty; null if there is no such file. Lives as long as this.
  [[nodiscard]] const File* find(std::string_view name) const;

 private:
  std::shared_ptr<const PublishedWorld> world_;
  std::map<std::string, File, std::less<>> files_;
};

[[nodiscard]] Answer answer_now(Exchange& exchange, const FileRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const FileRoute& route);

}  // namespace talus::server::web
