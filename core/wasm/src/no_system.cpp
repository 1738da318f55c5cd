// In place of all that libc and libc++ would ask a system for: there is none. What cannot go on calls the
// host, which does not return: it throws the instance away.
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <new>

extern "C" {

/// The module's only import besides its memory.
[[noreturn]] __attribute__((import_module("talus"), import_name("failed"))) void talus_failed(
    int out_of_memory);

void abort() {
  talus_failed(0);
}
void _Exit(int) {
  talus_failed(0);
}
[[noreturn]] void __cxa_pure_virtual() {
  talus_failed(0);
}
int __cxa_atexit(void (*)(void*), void*, void*) {
  return 0;  // it never ends
}
char* getenv(const char*) {
  return nullptr;
}

// What is imported otherwise, by those names, for files and clocks that nobody opens or reads: EBADF, ENOSYS.
#define TALUS_REFUSED(name, code, ...)                                 \
  std::int32_t __imported_wasi_snapshot_preview1_##name(__VA_ARGS__) { \
    return code;                                                       \
  }
TALUS_REFUSED(fd_close, 8, std::int32_t)
TALUS_REFUSED(fd_fdstat_get, 8, std::int32_t, std::int32_t)
TALUS_REFUSED(fd_read, 8, std::int32_t, std::int32_t, std::int32_t, std::int32_t)
TALUS_REFUSED(fd_seek, 8, std::int32_t, std::int64_t, std::int32_t, std::int32_t)
TALUS_REFUSED(fd_write, 8, std::int32_t, std::int32_t, std::int32_t, std::int32_t)
#undef TALUS_REFUSED

}  // extern "C"

namespace {

void* allocated(std::size_t bytes) {
  void* const memory = std::malloc(bytes == 0 ? 1 : bytes);
  if (memory == nullptr) talus_failed(1);
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) {
  return allocated(bytes);
}
void* operator new[](std::size_t bytes) {
  return allocated(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(bytes);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

// What libc++ calls where it would throw. A vector longer than memory is the one way to it.
_LIBCPP_BEGIN_NAMESPACE_STD
[[noreturn]] void __libcpp_verbose_abort(const char*, ...) {
  talus_failed(1);
}
_LIBCPP_END_NAMESPACE_STD
