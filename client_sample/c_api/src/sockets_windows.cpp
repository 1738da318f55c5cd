#include "sockets.h"

#include <winsock2.h>

#include <system_error>

#include <asio/detail/winsock_init.hpp>

namespace talus::c_api {
namespace {

// WSAStartup() must not be called while a DLL is loaded, as Asio's global objects would; this one comes
// before them.
[[gnu::init_priority(101)]] asio::detail::winsock_init<>::manual not_by_asio;

}  // namespace

Sockets::Sockets() {
  WSADATA data{};
  if (const int error = ::WSAStartup(MAKEWORD(2, 2), &data); error != 0) {
    throw std::system_error{error, std::system_category(), "WSAStartup"};
  }
}

Sockets::~Sockets() {
  ::WSACleanup();
}

}  // namespace talus::c_api
