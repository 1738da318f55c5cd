#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <optional>

#include <asio/co_spawn.hpp>
#include <asio/experimental/as_tuple.hpp>
#include <asio/steady_timer.hpp>
#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/client.h>

#include <talus/files/path_text.h>
#include <talus/progress/progress_bar.h>
#include "commands.h"
#include "heights_of.h"
#include "map_picture.h"
#include "output.h"
#include "request_timeout.h"

namespace talus::cli {
namespace {

// Requests the chunks at the ground of every square of an extent, then upwards until there is air above.
class Survey {
 public:
  Survey(const asio::any_io_executor& executor, client::Client& client, const client::WorldInfo& world,
         RequestTimeout& timeout)
      : client_{client}, world_{world}, timeout_{timeout}, surface_{world.materials}, changed_{executor} {}

  asio::awaitable<tl::expected<SurfaceMap, std::string>> run(Extent extent) {
    const std::int64_t first_x = floor_div(extent.x, kChunkSize);
    const std::int64_t first_z = floor_div(extent.z, kChunkSize);
    const std::int64_t last_x = floor_div(extent.x + extent.width - 1, kChunkSize);
    const std::int64_t last_z = floor_div(extent.z + extent.depth - 1, kChunkSize);
    const std::int64_t squares = (last_x - first_x + 1) * (last_z - first_z + 1);
    ProgressBar progress{"map", "chunks"};
    // 64 bits, to count past the world's last chunk.
    std::int64_t x = first_x;
    std::int64_t z = first_z;
    while (!error_ && (z <= last_z || open_ > 0)) {
      // Enough to keep the server busy; more would only queue here.
      for (; open_ < kMaxOpen && z <= last_z; x == last_x ? (x = first_x, ++z) : ++x) {
        start_square(static_cast<std::int32_t>(x), static_cast<std::int32_t>(z));
      }
      co_await change();
      progress.show(static_cast<double>(finished_) / static_cast<double>(squares),
                    client_.stats().chunk_frames);
    }
    if (error_) co_return tl::unexpected{*error_};
    co_return std::move(surface_);
  }

  /// After an error: waits for the last answer, which close() delivers.
  asio::awaitable<void> finish() {
    while (open_ > 0) co_await change();
  }

 private:
  static constexpr int kMaxOpen = 256;

  asio::awaitable<void> change() {
    changed_.expires_at(std::chrono::steady_clock::time_point::max());
    co_await changed_.async_wait(asio::experimental::as_tuple(asio::use_awaitable));
  }

  void start_square(std::int32_t x, std::int32_t z) {
    ++open_;
    std::vector<client::Column> columns;
    for (int dz = 0; dz < kChunkSize; ++dz) {
      for (int dx = 0; dx < kChunkSize; ++dx) {
        columns.push_back({std::int64_t{x} * kChunkSize + dx, std::int64_t{z} * kChunkSize + dz});
      }
    }
    const std::size_t at_once = columns.size();
    asio::co_spawn(changed_.get_executor(), heights_of(client_, timeout_, std::move(columns), at_once),
                   [this, x, z](const std::exception_ptr& thrown, const Heights& heights) {
                     if (thrown) std::rethrow_exception(thrown);
                     start_chunks(x, z, heights);
                   });
  }

  void start_chunks(std::int32_t x, std::int32_t z, const Heights& heights) {
    if (!heights) return fail(heights.error());
    const auto [low, high] = std::minmax_element(heights->begin(), heights->end());
    for (std::int32_t y = row_of_ground(*low); y <= row_of_ground(*high); ++y) {
      start_chunk({{x, y, z}, Lod{}});
    }
    finish_one();
  }

  // Chunk row of the topmost solid voxel y below a height: the highest with 256 y + 128 < height. Limited to
  // the world's rows, whatever the server answers.
  [[nodiscard]] std::int32_t row_of_ground(std::int32_t height_fx) const {
    const std::int64_t voxel = ((std::int64_t{height_fx} + 127) >> 8) - 1;
    const std::int64_t inside = std::max(std::min(voxel, world_.max_y), world_.min_y - 1);
    return static_cast<std::int32_t>(floor_div(inside, kChunkSize));
  }

  void start_chunk(const ChunkKey& key) {
    ++open_;
    ++open_chunks_[key.coord.x][key.coord.z];
    (void)client_.get(key, std::nullopt, [this, key](const auto& received) {
      if (!received) return fail(received.error());
      surface_.add(key, *received->chunk);
      if (--open_chunks_[key.coord.x][key.coord.z] == 0) climb(key);
      timeout_.restart();
      finish_one();
    });
  }

  // Called when all requested chunks of a square have arrived: continues upwards unless there is air above.
  void climb(const ChunkKey& key) {
    const auto above = surface_.next_row_up(key.coord.x, key.coord.z);
    if (above && std::int64_t{*above} * kChunkSize <= world_.max_y) {
      start_chunk({{key.coord.x, *above, key.coord.z}, Lod{}});
    } else {
      ++finished_;
    }
  }

  void fail(const client::ClientError& error) {
    if (!error_) error_ = timeout_.explain(error);
    finish_one();
  }

  void finish_one() {
    --open_;
    changed_.cancel();
  }

  client::Client& client_;
  const client::WorldInfo& world_;
  RequestTimeout& timeout_;
  SurfaceMap surface_;
  asio::steady_timer changed_;
  std::map<std::int32_t, std::map<std::int32_t, int>> open_chunks_;
  int open_ = 0;
  std::int64_t finished_ = 0;
  std::optional<std::string> error_;
};

}  // namespace

asio::awaitable<CommandResult> map(ConnectTarget target, MapOptions options) {
  if (const auto checked = check_output(options.output); !checked) co_return checked;
  const auto executor = co_await asio::this_coro::executor;
  client::Client client{executor, target.options};
  RequestTimeout timeout{executor, *target.options.clock, client,
                         RequestTimeout::Seconds{options.timeout_seconds}};
  const auto world = co_await client.connect(target.server.host, std::to_string(target.server.port));
  if (!world) co_return tl::unexpected{timeout.explain(world.error())};

  const auto center = options.center.value_or(client::Column{world->spawn.x, world->spawn.z});
  const auto extent = extent_around(center.x, center.z, options.width, options.depth);
  if (!extent) co_return tl::unexpected{"the map leaves the world: " + extent.error().message};
  Survey survey{executor, client, *world, timeout};
  const auto surface = co_await survey.run(*extent);
  client.close();
  co_await survey.finish();
  if (!surface) co_return tl::unexpected{surface.error()};

  const auto written = write_png(draw_map(*surface, world->materials, *extent, {}), options.output);
  if (!written) co_return written;
  std::cout << files::to_text(options.output) << ": " << extent->width << " x " << extent->depth
            << " columns, "
            << "received " << client.stats().chunk_frames << " chunks in " << client.stats().received_bytes
            << " bytes\n";
  co_return CommandResult{};
}

}  // namespace talus::cli
