// Priority of generator threads among the other threads of the process.
#pragma once

namespace talus::server {

/// Raises the calling thread's niceness to kBackgroundNiceness, so that threads that serve sockets go first
/// if both want a core: what is cached must not wait for what is being generated.
inline constexpr int kBackgroundNiceness = 5;
void lower_priority();

}  // namespace talus::server
