#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/client.h>

#include "commands.h"
#include "request_timeout.h"

namespace talus::cli {
namespace {

tl::expected<MaterialId, std::string> material_named(const client::WorldInfo& world, const std::string& flag,
                                                     const std::string& name) {
  std::string names;
  for (const client::Material& material : world.materials) {
    if (material.name == name) return material.id;
    names += (names.empty() ? "" : ", ") + material.name;
  }
  return tl::unexpected{flag + ": this world has no material '" + name + "'; it has " + names};
}

tl::expected<client::Edit, std::string> edit_of(const EditOptions& options, const client::WorldInfo& world) {
  client::Fill fill{options.from, options.to, std::nullopt, std::nullopt};
  for (const auto axis : {&VoxelPos::x, &VoxelPos::y, &VoxelPos::z}) {
    if (fill.first.*axis > fill.last.*axis) std::swap(fill.first.*axis, fill.last.*axis);
  }
  if (!options.material.empty()) {
    const auto material = material_named(world, "--material", options.material);
    if (!material) return tl::unexpected{material.error()};
    fill.material = *material;
  }
  if (!options.only.empty()) {
    const auto only = material_named(world, "--only", options.only);
    if (!only) return tl::unexpected{only.error()};
    fill.only = *only;
  }
  client::Edit edit;
  edit.fills.push_back(fill);
  edit.subject = options.subject;
  return edit;
}

}  // namespace

asio::awaitable<CommandResult> edit(ConnectTarget target, EditOptions options) {
  const auto executor = co_await asio::this_coro::executor;
  client::Client client{executor, target.options};
  const RequestTimeout timeout{executor, *target.options.clock, client,
                               RequestTimeout::Seconds{options.timeout_seconds}};
  const auto world = co_await client.connect(target.server.host, std::to_string(target.server.port));
  if (!world) co_return tl::unexpected{timeout.explain(world.error())};
  auto edit = edit_of(options, *world);
  if (!edit) co_return tl::unexpected{edit.error()};
  const auto done = co_await client.edit(*std::move(edit));
  if (!done) co_return tl::unexpected{timeout.explain(done.error())};
  std::cout << done->changed << (done->changed == 1 ? " voxel" : " voxels") << " changed, revision "
            << done->revision << '\n';
  co_return CommandResult{};
}

}  // namespace talus::cli
