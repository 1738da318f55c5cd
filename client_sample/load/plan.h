// What all clients of a run know. Made before the first of them, and not changed then.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <asio/ip/tcp.hpp>
#include <glm/vec3.hpp>

#include <talus/client/tls.h>
#include <talus/client/view.h>
#include <talus/client/world_info.h>

#include "edit_journal.h"
#include "movement.h"
#include "options.h"

namespace talus::load {

struct Plan {
  Options options;
  asio::ip::tcp::endpoint server;                  // the first of them
  std::vector<asio::ip::tcp::endpoint> servers{};  // of one world
  tls::Context tls;                                // null: plain
  client::WorldInfo world;
  std::shared_ptr<const Trace> trace;      // where the mix has one
  std::vector<glm::dvec3> origins;         // where each group begins, on its ground
  std::vector<ChunkKey> fixed_set;         // requests mode: chunks with a surface in them
  std::shared_ptr<EditJournal> journal{};  // null: none is kept

  /// What a player there asks for.
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
