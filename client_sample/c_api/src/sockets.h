// What the system's sockets need before the first of a session, and after its last.
#pragma once

namespace talus::c_api {

/// Throws std::system_error if there are no sockets.
class Sockets {
 public:
  Sockets();
  ~Sockets();
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
};

}  // namespace talus::c_api
