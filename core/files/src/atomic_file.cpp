#include <unistd.h>

#include <string>
#include <utility>

#include <talus/files/atomic_file.h>

namespace talus::files {
namespace {

namespace fs = std::filesystem;

/// Target of `path` after following symlinks, whether or not it exists.
fs::path followed(fs::path path) {
  constexpr int kMaxLinks = 40;
  std::error_code error;
  for (int links = 0; links < kMaxLinks && fs::is_symlink(path, error); ++links) {
    const fs::path target = fs::read_symlink(path, error);
    path = path.parent_path() / target;
  }
  return path;
}

/// Calls take(path) with new names in `directory` until the name is not taken. The names are short, because
/// the target's may already have the maximum length.
template <typename Take>
auto with_new_name(const fs::path& directory, const Take& take) {
  constexpr int kMaxNames = 1000;
  const std::string prefix = ".talus." + std::to_string(::getpid()) + '.';
  for (int number = 0;; ++number) {
    auto taken = take(directory / (prefix + std::to_string(number) + ".partial"));
    if (taken || taken.error() != std::errc::file_exists || number == kMaxNames) return taken;
  }
}

}  // namespace

tl::expected<AtomicFile, FileError> AtomicFile::create(const fs::path& target, FileLayer& layer) {
  const auto refused = [&](const char* reason) { return tl::unexpected{FileError{target, reason, {}}}; };
  fs::path file = followed(target);
  std::error_code ignored;  // writing fails too then, and reports the reason
  const auto type = fs::symlink_status(file, ignored).type();
  if (type == fs::file_type::directory) return refused("is a directory; give a file name");
  if (!file.has_filename()) return refused("is not a file name; give one");
  if (type != fs::file_type::regular && type != fs::file_type::not_found && type != fs::file_type::none) {
    return refused("is not a regular file");
  }
  AtomicFile atomic{layer, target, std::move(file), -1};
  const auto directory = layer.open_directory(atomic.directory_path());
  if (!directory) return atomic.cannot_write(directory.error());
  atomic.directory_ = *directory;
  const auto temporary = atomic.create_temporary();
  if (!temporary) return atomic.cannot_write(temporary.error());
  atomic.file_ = *temporary;
  return atomic;
}

AtomicFile::AtomicFile(FileLayer& layer, fs::path given, fs::path target, int directory)
    : layer_{&layer}, given_{std::move(given)}, target_{std::move(target)}, directory_{directory} {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : layer_{other.layer_},
      given_{std::move(other.given_)},
      target_{std::move(other.target_)},
      temporary_{std::exchange(other.temporary_, std::nullopt)},
      file_{std::exchange(other.file_, -1)},
      directory_{std::exchange(other.directory_, -1)} {}

AtomicFile::~AtomicFile() {
  if (file_ >= 0) layer_->close(file_);
  if (directory_ >= 0) layer_->close(directory_);
  if (temporary_) layer_->remove(*temporary_);
}

tl::unexpected<FileError> AtomicFile::cannot_write(std::error_code code) const {
  return tl::unexpected{FileError{given_, "cannot write: " + code.message(), code}};
}

fs::path AtomicFile::directory_path() const {
  return target_.has_parent_path() ? target_.parent_path() : fs::path{"."};
}

FileLayer::Result<int> AtomicFile::create_temporary() {
  if (const auto unnamed = layer_->create_unnamed(directory_path())) return unnamed;
  return with_new_name(directory_path(), [&](const fs::path& path) {
    auto created = layer_->create_new(path);
    if (created) temporary_ = path;
    return created;
  });
}

tl::expected<void, FileError> AtomicFile::write_at(std::uint64_t offset,
                                                   std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const auto written = layer_->write(file_, offset, bytes);
    if (!written) return cannot_write(written.error());
    bytes = bytes.subspan(*written);
    offset += *written;
  }
  return {};
}

tl::expected<void, FileError> AtomicFile::resize(std::uint64_t bytes) const {
  const auto resized = layer_->resize(file_, bytes);
  if (!resized) return cannot_write(resized.error());
  return {};
}

tl::expected<void, FileError> AtomicFile::commit() {
  // The bytes must reach the disk before the name does.
  if (const auto synced = layer_->sync(file_); !synced) return cannot_write(synced.error());
  if (!temporary_) {
    // A rename needs a name, and naming cannot replace a file.
    const auto named = with_new_name(directory_path(), [&](const fs::path& path) {
      auto result = layer_->name(file_, path);
      if (result) temporary_ = path;
      return result;
    });
    if (!named) return cannot_write(named.error());
  }
  if (const auto renamed = layer_->rename(*temporary_, target_); !renamed)
    return cannot_write(renamed.error());
  temporary_.reset();
  if (const auto synced = sync_directory(); !synced) return cannot_write(synced.error());
  return {};
}

FileLayer::Result<void> AtomicFile::sync_directory() const {
  auto synced = layer_->sync(directory_);
  // Some file systems do not support this, and have no alternative.
  if (!synced && synced.error() == std::errc::invalid_argument) return {};
  return synced;
}

tl::expected<void, FileError> write_file(const fs::path& path, std::span<const std::byte> bytes,
                                         FileLayer& layer) {
  auto file = AtomicFile::create(path, layer);
  if (!file) return tl::unexpected{file.error()};
  if (auto written = file->write_at(0, bytes); !written) return written;
  return file->commit();
}

tl::expected<void, FileError> write_file(const fs::path& path, std::string_view text, FileLayer& layer) {
  return write_file(path, std::as_bytes(std::span{text}), layer);
}

}  // namespace talus::files
