// How a generator thread stands among the other threads of the process. Both functions change the calling
// thread alone.
#pragma once

namespace talus::server {

/// Raises the thread's niceness to kBackgroundNiceness, so that threads that serve sockets go first where
/// both want a core: what is cached must not wait for what is being generated.
inline constexpr int kBackgroundNiceness = 5;
void lower_priority();

/// Leaves all signals to the main thread, which knows what they mean.
void block_signals();

}  // namespace talus::server
