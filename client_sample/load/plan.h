// Data shared by all clients of a run: created before the first client, and constant.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <asio/ip/tcp.hpp>
#include <glm/vec3.hpp>

#include <talus/client/tls.h>
#include <talus/client/view.h>
#include <talus/client/world_info.h>

#include "edit_journal.h"
#include "movement.h"
#include "options.h"
#include "published.h"

namespace talus::load {

struct Plan {
  Options options;
  asio::ip::tcp::endpoint server;                  // the first server
  std::vector<asio::ip::tcp::endpoint> servers{};  // all servers, of one world
  tls::Context tls;                                // null: no TLS
  client::WorldInfo world;
  std::shared_ptr<const Trace> trace;      // if the mix uses one
  std::vector<glm::dvec3> origins;         // start of each group, on its ground
  std::vector<ChunkKey> fixed_set;         // requests mode: chunks that contain a surface
  std::shared_ptr<EditJournal> journal{};  // null: not recorded
  std::shared_ptr<Published> published{};  // null: the server sends all chunks
  std::string not_published{};             // why, if --generate was given

  /// The View of a player at this position.
  [[nodiscard]] client::View view_at(VoxelPos centre, const glm::dvec3& direction) const {
    client::View view{centre, glm::vec3{direction}, options.radius, options.vertical, {}};
    if (options.horizon != 0) {
      view.rings = client::rings_between(options.radius, options.horizon);
      view.horizon = true;
    }
    return view;
  }
};

}  // namespace talus::load
