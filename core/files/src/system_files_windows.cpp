#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include <talus/files/file_layer.h>

namespace talus::files {
namespace {

namespace fs = std::filesystem;

constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;  // as POSIX does
constexpr std::size_t kMaxTransfer = std::size_t{1} << 30;

/// The last error as POSIX's, if there is one like it: callers ask for file_exists, and texts are the same
/// everywhere.
tl::unexpected<std::error_code> last_failure() {
  const std::error_code error{static_cast<int>(::GetLastError()), std::system_category()};
  const std::error_condition like = error.default_error_condition();
  if (like.category() != std::generic_category()) return tl::unexpected{error};
  return tl::unexpected{std::error_code{like.value(), std::generic_category()}};
}

tl::unexpected<std::error_code> failure(int error) {
  return tl::unexpected{std::error_code{error, std::generic_category()}};
}

FileLayer::Result<void> done(BOOL result) {
  if (result == 0) return last_failure();
  return {};
}

HANDLE handle_of(int file) {
  return reinterpret_cast<HANDLE>(::_get_osfhandle(file));
}

FileLayer::Result<int> opened(const fs::path& path, DWORD access, DWORD creation, DWORD flags, int mode) {
  const HANDLE handle = ::CreateFileW(path.c_str(), access, kShareAll, nullptr, creation, flags, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return last_failure();
  const int file = ::_open_osfhandle(reinterpret_cast<intptr_t>(handle), mode | _O_BINARY | _O_NOINHERIT);
  if (file >= 0) return file;
  ::CloseHandle(handle);
  return failure(EMFILE);
}

bool is_directory(int file) {
  BY_HANDLE_FILE_INFORMATION information{};
  return ::GetFileInformationByHandle(handle_of(file), &information) != 0 &&
         (information.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

OVERLAPPED at(std::uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32U);
  return place;
}

class SystemFiles final : public FileLayer {
 public:
  /// Opens directories too, so that mode() tells what they are.
  Result<int> open_to_read(const fs::path& path, WaitPolicy /*wait*/) override {
    return opened(path, GENERIC_READ, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, _O_RDONLY);
  }

  Result<int> open_directory(const fs::path& path) override {
    auto file = opened(path, GENERIC_READ, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, _O_RDONLY);
    if (!file || is_directory(*file)) return file;
    close(*file);
    return failure(ENOTDIR);
  }

  Result<int> create_unnamed(const fs::path& /*directory*/) override { return failure(ENOTSUP); }

  Result<int> create_new(const fs::path& path) override {
    return opened(path, GENERIC_READ | GENERIC_WRITE, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, _O_RDWR);
  }

  Result<mode_t> mode(int file) override {
    if (is_directory(file)) return mode_t{S_IFDIR | S_IRUSR};
    const bool regular = ::GetFileType(handle_of(file)) == FILE_TYPE_DISK;
    return static_cast<mode_t>((regular ? S_IFREG : S_IFCHR) | S_IRUSR | S_IWUSR);
  }

  Result<std::size_t> read(int file, std::span<std::byte> into) override {
    if (is_directory(file)) return failure(EISDIR);
    DWORD bytes = 0;
    const auto most = static_cast<DWORD>(std::min(into.size(), kMaxTransfer));
    if (::ReadFile(handle_of(file), into.data(), most, &bytes, nullptr) != 0) return bytes;
    if (::GetLastError() == ERROR_BROKEN_PIPE) return std::size_t{0};  // the writer has ended
    return last_failure();
  }

  Result<std::size_t> write(int file, std::uint64_t offset, std::span<const std::byte> bytes) override {
    OVERLAPPED place = at(offset);
    DWORD written = 0;
    const auto most = static_cast<DWORD>(std::min(bytes.size(), kMaxTransfer));
    if (::WriteFile(handle_of(file), bytes.data(), most, &written, &place) == 0) return last_failure();
    if (written == 0) return failure(ENOSPC);
    return written;
  }

  Result<void> resize(int file, std::uint64_t bytes) override {
    FILE_END_OF_FILE_INFO end{};
    end.EndOfFile.QuadPart = static_cast<LONGLONG>(bytes);
    return done(::SetFileInformationByHandle(handle_of(file), FileEndOfFileInfo, &end, sizeof end));
  }

  /// rename() waits for the names by itself; a directory cannot be flushed.
  Result<void> sync(int file) override {
    if (is_directory(file)) return {};
    return done(::FlushFileBuffers(handle_of(file)));
  }

  Result<void> name(int /*file*/, const fs::path& /*path*/) override { return failure(ENOTSUP); }

  Result<void> rename(const fs::path& from, const fs::path& to) override {
    return done(::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH));
  }

  void remove(const fs::path& path) override { ::DeleteFileW(path.c_str()); }
  void close(int file) override { ::_close(file); }
};

}  // namespace

FileLayer& system_files() {
  static SystemFiles files;
  return files;
}

}  // namespace talus::files
