#include <asio/io_context.hpp>
#include <string_view>
#include <vector>

#include <talus/client/client.h>
#include <talus/protocol/message.h>
#include <talus/version.h>
#include <talus/voxel/codec.h>

int main() {
  asio::io_context io;
  std::vector<std::byte> payload;
  talus::encode(talus::Chunk::uniform(talus::kWater), payload);
  const auto frame = talus::protocol::make_frame([](auto& b) { return talus::wire::CreatePing(b, 1); });
  const bool version = std::string_view{TALUS_VERSION_STRING}.starts_with(WANTED);
  return version && talus::decode(payload).has_value() && talus::protocol::read_message(frame).has_value()
             ? 0
             : 1;
}
