#include "sockets.h"

namespace talus::c_api {

Sockets::Sockets() = default;
Sockets::~Sockets() = default;

}  // namespace talus::c_api
