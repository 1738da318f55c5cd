#include "published.h"

#include <atomic>
#include <future>
#include <utility>

namespace talus::load {

tl::expected<std::shared_ptr<Published>, std::string> Published::open(
    std::shared_ptr<const client::WorldFiles> files) {
  auto published = std::make_shared<Published>();
  using World = tl::expected<std::shared_ptr<client::LocalWorld>, client::ChunkMaker::OpenFailure>;
  const auto opened = std::make_shared<std::promise<World>>();
  auto world = opened->get_future();
  published->source_->open(std::move(files), std::make_shared<const std::atomic<bool>>(false),
                           [opened](World made) { opened->set_value(std::move(made)); });
  World made = world.get();
  if (!made) return tl::unexpected{made.error().message};
  published->world_ = *std::move(made);
  return published;
}

void Published::make_mixed(std::vector<ChunkKey> keys,
                           std::function<void(std::vector<client::MadeChunk>)> done) {
  world_->make(std::move(keys), std::make_shared<const std::atomic<bool>>(false),
               [done = std::move(done)](tl::expected<std::vector<client::MadeChunk>, std::string> made) {
                 if (!made) return;
                 std::erase_if(*made, [](const client::MadeChunk& each) { return each.chunk->is_uniform(); });
                 done(*std::move(made));
               });
}

void Published::stop() {
  source_.reset();
}

}  // namespace talus::load
