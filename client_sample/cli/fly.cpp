#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <unordered_set>

#include <asio/experimental/as_tuple.hpp>
#include <asio/steady_timer.hpp>
#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>
#include <glm/geometric.hpp>

#include <talus/client/chunk_store.h>
#include <talus/client/client.h>

#include <talus/files/path_text.h>
#include <talus/local_source/local_source.h>
#include <talus/progress/progress_bar.h>
#include "commands.h"
#include "flight.h"
#include "heights_of.h"
#include "map_picture.h"
#include "output.h"
#include "request_timeout.h"
#include "view_picture.h"
#include "view_waits.h"

namespace talus::cli {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kTick{25};
constexpr std::size_t kStoreBytes = std::size_t{1} << 30;
constexpr int kViewWidth = 1280;
constexpr int kViewHeight = 720;
constexpr double kGraceSeconds = 10;  // besides the flight: to plan it, and to complete the last view
constexpr std::size_t kColumnsAtOnce = 256;
constexpr double kLookDown = 0.16;  // slope below the horizon

// Data collected during the flight.
struct FlightData {
  client::ChunkStore store{kStoreBytes};
  std::optional<SurfaceMap> surface;
  ViewWaits waits;
  std::unordered_set<ChunkKey> in_view;
  std::vector<std::string> errors;
  std::optional<std::string> lost;
};

client::Events events_into(FlightData& gathered) {
  client::Events events;
  events.on_chunk = [&gathered](const client::ReceivedChunk& received) {
    gathered.waits.chunk_arrived(received.key, Clock::now());
    gathered.in_view.insert(received.key);
    gathered.store.put(received);
    gathered.surface->add(received.key, *received.chunk);
  };
  events.on_left_view = [&gathered](ChunkKey key) {
    gathered.in_view.erase(key);
    gathered.store.erase(key);
  };
  events.on_error = [&gathered](const client::ClientError& error) {
    gathered.errors.push_back(error.message);
  };
  events.on_disconnect = [&gathered](const client::ClientError& error, bool retrying) {
    if (retrying) {
      gathered.errors.push_back(error.message);
    } else {
      gathered.lost = error.message;
    }
  };
  return events;
}

// Level 1 reaches three times as far as level 0, level 2 twice as far as level 1 or kFarRadius, and each
// further level twice as far as the previous one, so that voxels stay small in the picture. Defaults adapt to
// the server; the server may reject the user's own values.
client::View view_shape(const FlyOptions& options, const client::ServerLimits& limits) {
  const int most = limits.view_horizontal_radius;
  const int radius = options.radius.value_or(std::min(FlyOptions::kRadius, most));
  const int far_radius = options.far_radius.value_or(std::min(FlyOptions::kFarRadius, most * 4));
  client::View view;
  view.horizontal_radius = static_cast<std::uint16_t>(radius);
  view.vertical_radius = std::min<std::uint16_t>(10, limits.view_vertical_radius);
  const int near = std::min({radius * 3, far_radius, most * 2});
  if (near > radius) view.rings.push_back({Lod::of(1), static_cast<std::uint16_t>(near)});
  int reach = near;
  int next = std::max(2 * near, FlyOptions::kFarRadius);
  for (int level = 2; level <= Lod::kMax && reach < far_radius; ++level, next *= 2) {
    reach = level == Lod::kMax ? far_radius : std::min(next, far_radius);
    view.rings.push_back({Lod::of(level), static_cast<std::uint16_t>(reach)});
  }
  view.horizon = limits.view_horizon && !view.rings.empty();
  return view;
}

class Flight {
 public:
  Flight(Course course, Altitude altitude) : course_{course}, altitude_{std::move(altitude)} {}

  [[nodiscard]] Camera camera_at(double distance) const {
    const glm::dvec2 place = course_.at(distance);
    const glm::dvec2 ahead = course_.direction(distance);
    return {{place.x, altitude_.at(distance), place.y},
            glm::normalize(glm::dvec3{ahead.x, -kLookDown, ahead.y}),
            62};
  }

 private:
  Course course_;
  Altitude altitude_;
};

asio::awaitable<client::Result<Flight>> plan(client::Client& client, const client::WorldInfo& world,
                                             const FlyOptions& options, RequestTimeout& timeout) {
  const client::Column from = options.from.value_or(client::Column{world.spawn.x, world.spawn.z});
  const glm::dvec2 start{static_cast<double>(from.x) + 0.5, static_cast<double>(from.z) + 0.5};
  const double length = options.seconds * options.speed;
  double heading = 0;
  if (options.heading) {
    heading = radians_of(*options.heading);
  } else {
    const auto around =
        co_await heights_of(client, timeout, candidate_columns(start, length), kColumnsAtOnce);
    if (!around) co_return tl::unexpected{around.error()};
    heading = choose_heading(*around);
  }
  const Course course{start, heading, length};
  const auto heights = co_await heights_of(client, timeout, course_columns(course), kColumnsAtOnce);
  if (!heights) co_return tl::unexpected{heights.error()};
  co_return Flight{course, Altitude{*heights, options.height}};
}

client::View view_from(const Camera& camera, client::View shape) {
  shape.centre = {static_cast<std::int64_t>(std::floor(camera.position.x)),
                  static_cast<std::int64_t>(std::floor(camera.position.y)),
                  static_cast<std::int64_t>(std::floor(camera.position.z))};
  shape.direction = glm::vec3{camera.direction};
  return shape;
}

bool same_chunk(const VoxelPos& a, const VoxelPos& b) {
  return floor_div(a.x, kChunkSize) == floor_div(b.x, kChunkSize) &&
         floor_div(a.y, kChunkSize) == floor_div(b.y, kChunkSize) &&
         floor_div(a.z, kChunkSize) == floor_div(b.z, kChunkSize);
}

void print_summary(const FlightData& gathered, const client::Stats& stats, double seconds) {
  const auto ms = [&](double part) { return gathered.waits.waits().percentile_ms(part); };
  std::cout << std::fixed << std::setprecision(1) << gathered.waits.waits().count() << " chunks in "
            << seconds << " s (" << static_cast<double>(gathered.waits.waits().count()) / seconds << "/s), "
            << static_cast<double>(stats.received_bytes) / 1e6 << " MB received ("
            << static_cast<double>(stats.received_bytes) /
                   static_cast<double>(std::max<std::uint64_t>(1, gathered.waits.waits().count()))
            << " bytes a chunk)\nfrom View to arrival: p50 " << ms(0.50) << " ms, p95 " << ms(0.95)
            << " ms, p99 " << ms(0.99) << " ms\nby wire " << stats.chunk_frames + stats.uniform_chunks
            << " chunks, made here " << stats.made_chunks << " (" << stats.proofs
            << " compared with the server's, " << stats.failed_proofs << " differed)\nbad chunks "
            << stats.bad_chunks << ", errors " << gathered.errors.size() << ", connections "
            << stats.connections << '\n';
  constexpr std::size_t kErrorsShown = 5;
  for (std::size_t i = 0; i < std::min(kErrorsShown, gathered.errors.size()); ++i) {
    std::cout << "  " << gathered.errors[i] << '\n';
  }
  std::cout.flush();  // drawing the view takes seconds
}

CommandResult save_pictures(const FlightData& gathered, const client::WorldInfo& world,
                            const FlyOptions& options, const Camera& camera, const client::View& view,
                            const std::vector<glm::dvec2>& path) {
  if (!options.output.empty()) {
    auto written = write_png(draw_map(*gathered.surface, world.materials, gathered.surface->extent(), path),
                             options.output);
    if (!written) return written;
    std::cout << "map " << files::to_text(options.output) << std::endl;
  }
  if (!options.view.empty()) {
    const int reach = view.rings.empty() ? view.horizontal_radius : view.rings.back().radius;
    std::optional<ProgressBar> progress{std::in_place, "draw", "rows"};
    progress->expect(kViewHeight);
    const Picture picture = draw_view(gathered.store, world.materials, camera,
                                      static_cast<double>(reach) * kChunkSize, kViewWidth, kViewHeight,
                                      [&](int rows) { progress->advance(static_cast<std::uint64_t>(rows)); });
    progress.reset();
    auto written = write_png(picture, options.view);
    if (!written) return written;
    std::cout << "view " << files::to_text(options.view) << '\n';
  }
  return {};
}

}  // namespace

asio::awaitable<CommandResult> fly(ConnectTarget target, FlyOptions options) {
  for (const auto& path : {options.output, options.view}) {
    if (const auto checked = check_output(path); !checked) co_return checked;
  }
  const auto executor = co_await asio::this_coro::executor;
  FlightData gathered;
  target.options.generate = options.generate;
  if (options.generate != client::Generate::never) target.options.maker = std::make_shared<LocalSource>();
  client::Client client{executor, target.options, events_into(gathered)};
  const auto world = co_await client.connect(target.server.host, std::to_string(target.server.port));
  if (!world) co_return tl::unexpected{world.error().message};
  gathered.surface.emplace(world->materials);
  RequestTimeout timeout{executor, *target.options.clock, client,
                         RequestTimeout::Seconds{options.seconds + kGraceSeconds}};
  const auto flight = co_await plan(client, *world, options, timeout);
  if (!flight) co_return tl::unexpected{timeout.explain(flight.error())};

  const client::View shape = view_shape(options, world->limits);
  std::optional<ProgressBar> progress{std::in_place, "fly", "chunks"};
  asio::steady_timer tick{executor};
  std::vector<glm::dvec2> path;
  std::optional<client::View> view;
  client::ViewShape covered;  // by `view`
  Camera camera;
  const auto begun = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  // After the flight the camera waits until everything in view has arrived, or the time is over.
  while (!gathered.lost && !timeout.has_expired()) {
    const double flown = std::min(elapsed(), options.seconds);
    camera = flight->camera_at(flown * options.speed);
    const auto wanted = view_from(camera, shape);
    if (!view || !same_chunk(view->centre, wanted.centre)) {
      covered = client::ViewShape{wanted, world->heights()};
      gathered.waits.view_set(covered, Clock::now());
      if (const auto set = client.set_view(wanted); !set) {
        co_return tl::unexpected{"--radius and --far: " + set.error().message};
      }
      view = wanted;
    }
    path.emplace_back(camera.position.x, camera.position.z);
    const auto missing = covered.count() - static_cast<std::int64_t>(gathered.in_view.size());
    if (flown >= options.seconds && missing <= 0) break;
    progress->show(elapsed() / options.seconds, gathered.waits.waits().count(),
                   std::to_string(missing) + " to come");
    tick.expires_after(kTick);
    co_await tick.async_wait(asio::experimental::as_tuple(asio::use_awaitable));
  }
  const double seconds = elapsed();
  progress.reset();  // erases its line before other output
  client.close();
  if (gathered.lost) co_return tl::unexpected{*gathered.lost};
  if (gathered.waits.waits().count() == 0) {
    co_return tl::unexpected{"no chunk came" + (gathered.errors.empty() ? "" : ": " + gathered.errors[0])};
  }
  print_summary(gathered, client.stats(), seconds);
  co_return save_pictures(gathered, *world, options, camera, *view, path);
}

}  // namespace talus::cli
