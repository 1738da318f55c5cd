#include "world_probe.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include <asio/co_spawn.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include <talus/client/client.h>
#include <talus/local_source/local_source.h>

namespace talus::load {
namespace {

using client::Column;

constexpr std::int64_t kGroupsApart = 8192;  // voxels
constexpr std::chrono::seconds kProbeTimeout{30};

struct ProbeError {
  std::string line;
};

/// Groups on a square grid at a place that the seed selects, so that another seed gets fresh terrain.
std::vector<Column> group_columns(const Options& options, std::size_t groups) {
  Random random{options.seed, 0x6E0};
  const auto somewhere = [&] { return (static_cast<std::int64_t>(random.below(2048)) - 1024) * (1 << 20); };
  const Column corner{somewhere(), somewhere()};
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(groups))));
  std::vector<Column> columns;
  for (std::size_t group = 0; group < groups; ++group) {
    columns.push_back({corner.x + static_cast<std::int64_t>(group % side) * kGroupsApart,
                       corner.z + static_cast<std::int64_t>(group / side) * kGroupsApart});
  }
  return columns;
}

/// Centres of a square of chunks around the spawn.
std::vector<Column> fixed_columns(const client::WorldInfo& world, std::size_t chunks) {
  const auto side = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(chunks))));
  std::vector<Column> columns;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(chunks); ++i) {
    const auto middle = [side](std::int64_t around, std::int64_t at) {
      return (floor_div(around, kChunkSize) + at - side / 2) * kChunkSize + kChunkSize / 2;
    };
    columns.push_back({middle(world.spawn.x, i % side), middle(world.spawn.z, i / side)});
  }
  return columns;
}

asio::awaitable<std::vector<std::int32_t>> heights_of(client::Client& client,
                                                      const std::vector<Column>& columns) {
  // A world may allow few tiles per request: find an accepted size by halving.
  std::size_t most = client.world()->limits.heights_per_request;
  if (most == 0)
    throw ProbeError{"the server allows no heights in a request: limits.heights_per_request is 0"};
  std::vector<std::int32_t> heights;
  while (heights.size() < columns.size()) {
    const auto from = columns.begin() + static_cast<std::ptrdiff_t>(heights.size());
    const std::size_t count = std::min(most, columns.size() - heights.size());
    const auto some = co_await client.get_heights({from, from + static_cast<std::ptrdiff_t>(count)});
    if (some) {
      heights.insert(heights.end(), some->begin(), some->end());
    } else if (some.error().kind == client::ErrorKind::out_of_range && count > 1) {
      most = count / 2;
    } else {
      throw ProbeError{some.error().message};
    }
  }
  co_return heights;
}

/// After connecting: checks that the server accepts the options, and finds the players' places.
asio::awaitable<void> explore(client::Client& client, Plan& plan) {
  const Options& options = plan.options;
  const auto& limits = plan.world.limits;
  if (options.radius > limits.view_horizontal_radius || options.vertical > limits.view_vertical_radius) {
    throw ProbeError{"the server allows --radius up to " + std::to_string(limits.view_horizontal_radius) +
                     " and --vertical up to " + std::to_string(limits.view_vertical_radius)};
  }
  const client::View view = plan.view_at({}, {});
  if (view.horizon && !limits.view_horizon)
    throw ProbeError{"the server does not support a View with a --horizon"};
  const std::uint64_t chunks = client::ViewShape{view, plan.world.heights()}.uncut_count();
  if (chunks > limits.view_chunks) {
    throw ProbeError{"the server allows Views of " + std::to_string(limits.view_chunks) +
                     " chunks, and this one has " + std::to_string(chunks)};
  }
  if (options.in_flight > limits.requests_in_flight) {
    throw ProbeError{"the server allows --in-flight up to " + std::to_string(limits.requests_in_flight)};
  }
  const std::size_t groups =
      options.groups != 0 ? options.groups : options.players + options.slow + options.greedy;
  const auto columns = group_columns(options, std::max<std::size_t>(1, groups));
  const auto heights = co_await heights_of(client, columns);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    plan.origins.emplace_back(static_cast<double>(columns[i].x), std::floor(heights[i] / 256.0) + 2,
                              static_cast<double>(columns[i].z));
  }
  if (options.in_flight == 0) co_return;
  const auto middles = fixed_columns(plan.world, options.fixed_set);
  const auto grounds = co_await heights_of(client, middles);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const auto row = floor_div(floor_div(grounds[i], 256), kChunkSize);
    if (const auto key = checked_chunk(floor_div(middles[i].x, kChunkSize), row,
                                       floor_div(middles[i].z, kChunkSize), Lod{})) {
      plan.fixed_set.push_back(*key);
    }
  }
}

/// The client's state of the published world.
struct Opening {
  std::shared_ptr<const client::WorldFiles> files;
  std::string failure;

  [[nodiscard]] client::Events events() {
    client::Events events;
    events.on_world_files = [this](ContentHash, const auto& fetched) { files = fetched; };
    events.on_error = [this](const client::ClientError& error) { failure = error.message; };
    events.on_disconnect = [this](const client::ClientError& error, bool) { failure = error.message; };
    return events;
  }
};

/// The world's files are those that the client has just opened.
asio::awaitable<void> open_published(client::Client& client, const Opening& opening, Plan& plan) {
  while (opening.files == nullptr && opening.failure.empty() && client.connected()) {
    (void)co_await client.ping();
  }
  if (opening.files != nullptr) {
    auto published = Published::open(opening.files);
    if (!published) throw ProbeError{published.error()};
    plan.published = *std::move(published);
    co_return;
  }
  plan.not_published = opening.failure.empty() ? "the server ended the connection" : opening.failure;
  if (plan.options.generate == client::Generate::always) throw ProbeError{plan.not_published};
}

asio::awaitable<void> probe(asio::io_context& io, Plan& plan) {
  const Options& options = plan.options;
  asio::ip::tcp::resolver resolver{io};
  const auto found =
      resolver.resolve(options.connect.server.host, std::to_string(options.connect.server.port));
  client::Options connecting;
  connecting.token = options.connect.token;
  connecting.client_name = "talus-load " TALUS_VERSION;
  connecting.tls = options.connect.tls;
  connecting.websocket = options.connect.websocket;
  if (connecting.websocket.host.empty()) connecting.websocket.host = to_string(options.connect.server);
  plan.options.connect.websocket = connecting.websocket;
  if (options.connect.tls.on) {
    // Players connect to the address found, and expect the name given.
    if (connecting.tls.server_name.empty()) connecting.tls.server_name = options.connect.server.host;
    plan.options.connect.tls = connecting.tls;
    const auto context = client::make_tls_context(connecting.tls);
    if (!context) throw ProbeError{context.error().message};
    plan.tls = *context;
  }
  connecting.generate = options.generate;
  if (options.generate != client::Generate::never) {
    connecting.maker = std::make_shared<LocalSource>(LocalSourceOptions{1});
  }
  Opening opening;
  client::Client client{io.get_executor(), connecting, opening.events()};
  // The first address that answers is used for the players too.
  std::string why;
  for (const auto& entry : found) {
    const auto endpoint = entry.endpoint();
    const auto world =
        co_await client.connect(endpoint.address().to_string(), std::to_string(endpoint.port()));
    if (!world) {
      why = world.error().message;
      continue;
    }
    plan.server = endpoint;
    plan.servers = {endpoint};
    plan.world = *world;
    break;
  }
  for (const protocol::Endpoint& more : options.connect.more_servers) {
    plan.servers.push_back(resolver.resolve(more.host, std::to_string(more.port))->endpoint());
  }
  if (client.world() == nullptr || !client.connected()) {
    throw ProbeError{why.empty() ? "the server ended the connection right after Welcome" : why};
  }
  // Bounds the wait for a server that never answers.
  asio::steady_timer deadline{io, kProbeTimeout};
  bool late = false;
  std::string too_slow = "the server did not send the ground's heights at the players' places within 30 s";
  deadline.async_wait([&](std::error_code cancelled) {
    if (cancelled) return;
    late = true;
    client.close();
  });
  try {
    co_await explore(client, plan);
    if (options.generate != client::Generate::never && !plan.world.limits.view_base) {
      plan.not_published = "the server does not publish its world";
    } else if (options.generate != client::Generate::never) {
      too_slow = "the published world was not fetched and opened within 30 s";
      co_await open_published(client, opening, plan);
    }
  } catch (const ProbeError&) {
    if (late) throw ProbeError{too_slow};
    throw;
  }
  if (late && plan.published == nullptr) plan.not_published = too_slow;
}

}  // namespace

tl::expected<void, std::string> probe_world(Plan& plan) {
  asio::io_context io{1};
  std::exception_ptr thrown;
  asio::co_spawn(io, probe(io, plan), [&](const std::exception_ptr& exception) { thrown = exception; });
  io.run();
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const ProbeError& failed) {
    return tl::unexpected{failed.line};
  } catch (const std::system_error& error) {
    return tl::unexpected{to_string(plan.options.connect.server) + ": " + error.code().message()};
  }
  return {};
}

}  // namespace talus::load
