/* Windows: loading talus.dll must not start the system's sockets, which talus_connect() does. */
#include <winsock2.h>

int main(void) {
  if (LoadLibraryA("talus.dll") == NULL) return 1;
  return socket(AF_INET, SOCK_STREAM, 0) == INVALID_SOCKET && WSAGetLastError() == WSANOTINITIALISED ? 0 : 2;
}
