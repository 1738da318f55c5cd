#include <windows.h>

#include <fcntl.h>
#include <io.h>

#include <array>
#include <cstdlib>

#include "talus/files/standard_descriptors.h"

namespace talus::files {
namespace {

UINT console_code_page = 0;

}  // namespace

void open_closed_standard_descriptors() {
  constexpr std::array kModes{_O_RDONLY, _O_RDONLY, _O_WRONLY};
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if (::_get_osfhandle(descriptor) == -1) {
      if (::_wopen(L"NUL", kModes[static_cast<std::size_t>(descriptor)] | _O_BINARY) == -1) return;
    } else {
      ::_setmode(descriptor, _O_BINARY);
    }
  }
  console_code_page = ::GetConsoleOutputCP();
  if (console_code_page == 0 || ::SetConsoleOutputCP(CP_UTF8) == 0) return;
  std::atexit([] { ::SetConsoleOutputCP(console_code_page); });
}

}  // namespace talus::files
