#include <windows.h>

#include <fcntl.h>
#include <io.h>

#include <array>
#include <cstdlib>

#include "talus/files/standard_descriptors.h"

namespace talus::files {
namespace {

UINT console_code_page = 0;

void restore_code_page() {
  ::SetConsoleOutputCP(console_code_page);
}

BOOL WINAPI on_control(DWORD /*event*/) {
  restore_code_page();
  return FALSE;  // ends the process, which runs no function of atexit() then
}

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
  std::atexit(restore_code_page);
  ::SetConsoleCtrlHandler(on_control, TRUE);
}

}  // namespace talus::files
