// "talusd cluster": creates the stream that the servers of one world share, diagnoses what keeps them from
// it, and shows its state.
#pragma once

#include <functional>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/content_hash.h>

#include "cluster/message.h"
#include "config/load.h"

namespace talus::server {

/// Makes the first message (revision 0) of a stream for the settings' world and that store. An error is one
/// line.
using MakeGenesis =
    std::function<tl::expected<cluster::Genesis, std::string>(const Config&, const ContentHash& store_id)>;

/// Runs the command and returns the exit status.
[[nodiscard]] int cluster_command(int argc, const char* const* argv, const Environment& environment,
                                  const MakeGenesis& make_genesis);

}  // namespace talus::server
