#include "cluster/jetstream/discarded_messages.h"

#include <string>

#include <catch2/catch.hpp>

namespace talus::server::jetstream {
namespace {

NatsMessage message_of(std::size_t bytes) {
  const std::string data(bytes, 'x');
  natsMsg* made = nullptr;
  REQUIRE(natsMsg_Create(&made, "a", nullptr, data.data(), static_cast<int>(data.size())) == NATS_OK);
  return NatsMessage{made};
}

TEST_CASE("messages that are done with are freed many at once, and large ones soon") {
  REQUIRE(nats_Open(-1) == NATS_OK);  // as a connection does
  DiscardedMessages discarded;
  for (std::size_t i = 1; i < DiscardedMessages::kMaxMessages; ++i) discarded.add(message_of(10));
  CHECK(discarded.size() == DiscardedMessages::kMaxMessages - 1);
  discarded.add(message_of(10));
  CHECK(discarded.size() == 0);
  discarded.add(message_of(10));
  CHECK(discarded.size() == 1);
  discarded.add(message_of(DiscardedMessages::kMaxBytes));
  CHECK(discarded.size() == 0);
}

}  // namespace
}  // namespace talus::server::jetstream
