#include <windows.h>

#include <fcntl.h>
#include <io.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>

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

// To a console msvcrt writes each byte by itself, which would divide the characters of UTF-8.
void write_whole_characters() {
  if (::_isatty(1) != 0) {
    std::setvbuf(stdout, nullptr, _IOFBF, BUFSIZ);
    std::cout << std::unitbuf;
  }
  if (::_isatty(2) != 0) std::setvbuf(stderr, nullptr, _IOFBF, BUFSIZ);  // std::cerr flushes it
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
  write_whole_characters();
  console_code_page = ::GetConsoleOutputCP();
  if (console_code_page == 0 || ::SetConsoleOutputCP(CP_UTF8) == 0) return;
  std::atexit(restore_code_page);
  ::SetConsoleCtrlHandler(on_control, TRUE);
}

}  // namespace talus::files
