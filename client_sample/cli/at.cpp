#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/client.h>
#include <talus/protocol/limits.h>

#include "commands.h"
#include "request_timeout.h"

namespace talus::cli {
namespace {

constexpr double kGroundUnits = 256;  // units of Heights per voxel

void print(const client::Column& column, std::size_t i, const client::ColumnPlaces& places,
           const client::WorldInfo& world, const std::vector<std::string>& fields) {
  std::cout << std::setprecision(6) << "column " << column.x << ',' << column.z << "\n  ground "
            << places.heights_fx[i] / kGroundUnits << " voxels above y = 0\n";
  if (!places.looks.empty() && places.looks[i] != 0)
    std::cout << "  look " << world.looks[places.looks[i]] << '\n';
  std::cout << std::setprecision(4);
  for (std::size_t field = 0; field < fields.size(); ++field) {
    std::cout << "  " << fields[field] << ' ' << places.values[i * fields.size() + field] << '\n';
  }
}

}  // namespace

asio::awaitable<CommandResult> at(ConnectTarget target, AtOptions options) {
  const auto executor = co_await asio::this_coro::executor;
  client::Client client{executor, target.options};
  const RequestTimeout timeout{executor, *target.options.clock, client,
                               RequestTimeout::Seconds{options.timeout_seconds}};
  const auto world = co_await client.connect(target.server.host, std::to_string(target.server.port));
  if (!world) co_return tl::unexpected{timeout.explain(world.error())};

  std::vector<std::string> fields = world->fields;
  fields.resize(std::min<std::size_t>(fields.size(), protocol::kMaxFieldsPerRequest));
  const auto places = co_await client.get_places(options.columns, fields);
  if (!places) co_return tl::unexpected{timeout.explain(places.error())};
  for (std::size_t i = 0; i < options.columns.size(); ++i)
    print(options.columns[i], i, *places, *world, fields);
  co_return CommandResult{};
}

}  // namespace talus::cli
