// How a thread that makes chunks stands among the others of the process.
#pragma once

namespace talus::server {

/// Makes the calling thread give way to those that serve sockets, and leave all signals to the main thread.
void be_in_background();

}  // namespace talus::server
