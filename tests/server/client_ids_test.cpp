// Who waits for chunks is told from all others.
#include "chunks/client_ids.h"

#include <set>

#include <catch2/catch.hpp>

using namespace talus::server;

TEST_CASE("ids of different kinds are never alike, whatever their numbers") {
  std::set<ClientId> ids;
  std::size_t given = 0;
  for (const auto kind : {ClientKind::session, ClientKind::look_ups, ClientKind::fetch, ClientKind::pregen}) {
    for (const std::uint64_t number : {0ULL, 1ULL, 2ULL, (1ULL << 40U) + 7, (1ULL << 62U) - 1}) {
      ids.insert(client_id(kind, number));
      ++given;
    }
  }
  CHECK(ids.size() == given);
}
