#include <chrono>
#include <iostream>

#include <talus/client/chunk_store.h>
#include <talus/client/client.h>
#include <asio/io_context.hpp>

int main() {
  int status = 1;  // until all chunks are there
  asio::io_context io;
  talus::client::ChunkStore store{256 << 20};  // bytes of voxels that it may hold
  talus::client::Events events;
  events.on_chunk = [&](const talus::client::ReceivedChunk& chunk) { store.put(chunk); };
  events.on_left_view = [&](const talus::ChunkKey& key) { store.erase(key); };
  const talus::client::Options options;  // a token, TLS, limits
  talus::client::Client client{io.get_executor(), options, events};

  talus::client::View view;  // by default 8 chunks to each side, 4 up and 4 down
  client.connect("localhost", "4780", [&](const auto& world) {
    if (!world) {
      std::cerr << world.error().message << '\n';
      return;
    }
    view.centre = world->spawn;
    (void)client.set_view(view);  // again whenever the player moves
  });

  while (!io.stopped()) {                       // the game's loop
    io.run_for(std::chrono::milliseconds{16});  // callbacks run in here
    // Mesh and draw what the store holds. This example ends when the View is complete.
    const auto wanted = static_cast<std::size_t>(talus::client::ViewShape{view}.count());
    if (client.connected() && store.size() == wanted) {
      std::cout << store.size() << " chunks, " << client.stats().received_bytes << " bytes received\n";
      status = 0;
      client.close();
    }
  }
  return status;
}
