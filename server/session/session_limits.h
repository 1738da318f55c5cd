// What a session needs of the configuration.
#pragma once

#include "config/config.h"

namespace talus::server {

using SessionLimits = Limits;

}  // namespace talus::server
