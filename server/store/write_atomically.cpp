#include "store/write_atomically.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "store/descriptor.h"

namespace talus::server {
namespace {

bool write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

int write_synced(const std::filesystem::path& file, std::string_view content) {
  const Descriptor out{::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
  const bool done = out.get() >= 0 && write_all(out.get(), content) && ::fsync(out.get()) == 0;
  return done ? 0 : errno;
}

}  // namespace

int write_atomically(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::path beside = file;
  beside += ".new";
  if (const int failed = write_synced(beside, content); failed != 0) return failed;
  if (std::rename(beside.c_str(), file.c_str()) != 0) return errno;
  // The new name is on disk only once its directory is.
  const Descriptor directory{::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  return directory.get() >= 0 && ::fsync(directory.get()) == 0 ? 0 : errno;
}

}  // namespace talus::server
