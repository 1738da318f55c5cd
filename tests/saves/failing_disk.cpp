#include "failing_disk.h"

#include <signal.h>
#include <unistd.h>

#include <sqlite3.h>

namespace {

FailingDisk::Failure failure_now;
int fails_at = 0;
int changes_so_far = 0;
sqlite3_vfs* system_files = nullptr;
sqlite3_vfs failing_files;

/// SQLITE_OK if this change may be made.
int change() {
  ++changes_so_far;
  if (fails_at == 0 || changes_so_far < fails_at) return SQLITE_OK;
  if (failure_now == FailingDisk::Failure::killed) kill(getpid(), SIGKILL);
  return failure_now == FailingDisk::Failure::full ? SQLITE_FULL : SQLITE_IOERR_WRITE;
}

struct File {
  sqlite3_file base;
  sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

File* of(sqlite3_file* file) {
  return reinterpret_cast<File*>(file);
}
const sqlite3_io_methods* methods(sqlite3_file* file) {
  return of(file)->real()->pMethods;
}

const sqlite3_io_methods kMethods{
    1,
    [](sqlite3_file* file) { return methods(file)->xClose(of(file)->real()); },
    [](sqlite3_file* file, void* into, int bytes, sqlite3_int64 at) {
      return methods(file)->xRead(of(file)->real(), into, bytes, at);
    },
    [](sqlite3_file* file, const void* from, int bytes, sqlite3_int64 at) {
      const int may = change();
      return may == SQLITE_OK ? methods(file)->xWrite(of(file)->real(), from, bytes, at) : may;
    },
    [](sqlite3_file* file, sqlite3_int64 size) {
      const int may = change();
      return may == SQLITE_OK ? methods(file)->xTruncate(of(file)->real(), size) : may;
    },
    [](sqlite3_file* file, int flags) {
      const int may = change();
      return may == SQLITE_OK ? methods(file)->xSync(of(file)->real(), flags) : may;
    },
    [](sqlite3_file* file, sqlite3_int64* size) { return methods(file)->xFileSize(of(file)->real(), size); },
    [](sqlite3_file* file, int lock) { return methods(file)->xLock(of(file)->real(), lock); },
    [](sqlite3_file* file, int lock) { return methods(file)->xUnlock(of(file)->real(), lock); },
    [](sqlite3_file* file, int* out) { return methods(file)->xCheckReservedLock(of(file)->real(), out); },
    [](sqlite3_file* file, int what, void* value) {
      return methods(file)->xFileControl(of(file)->real(), what, value);
    },
    [](sqlite3_file* file) { return methods(file)->xSectorSize(of(file)->real()); },
    [](sqlite3_file* file) { return methods(file)->xDeviceCharacteristics(of(file)->real()); },
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr};

int open_file(sqlite3_vfs* /*vfs*/, const char* name, sqlite3_file* file, int flags, int* out) {
  const int result = system_files->xOpen(system_files, name, of(file)->real(), flags, out);
  file->pMethods = result == SQLITE_OK ? &kMethods : nullptr;
  return result;
}

int remove_file(sqlite3_vfs* /*vfs*/, const char* name, int sync) {
  const int may = change();
  return may == SQLITE_OK ? system_files->xDelete(system_files, name, sync) : may;
}

}  // namespace

FailingDisk::FailingDisk(Failure failure, int at) {
  failure_now = failure;
  fails_at = at;
  changes_so_far = 0;
  system_files = sqlite3_vfs_find("unix");
  failing_files = *system_files;
  failing_files.zName = "failing";
  failing_files.szOsFile += static_cast<int>(sizeof(File));
  failing_files.xOpen = open_file;
  failing_files.xDelete = remove_file;
  sqlite3_vfs_register(&failing_files, 1);
}

FailingDisk::~FailingDisk() {
  sqlite3_vfs_unregister(&failing_files);
  sqlite3_vfs_register(system_files, 1);
}

int FailingDisk::changes() {
  return changes_so_far;
}

void FailingDisk::mend() {
  fails_at = 0;
}
