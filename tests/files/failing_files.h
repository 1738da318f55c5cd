// Files of which one call fails, or comes up short, as disks do.
#pragma once

#include <algorithm>
#include <set>

#include <talus/files/file_layer.h>

namespace talus::files {

/// The system's files, but for one call. Counts the files that are open.
class FailingFiles final : public FileLayer {
 public:
  static constexpr std::errc kError = std::errc::no_space_on_device;

  /// The call after `calls` others fails.
  void fail_after(int calls) { calls_left_ = calls; }
  /// Reads and writes move at most so many bytes.
  void limit_transfers(std::size_t bytes) { max_bytes_ = bytes; }
  /// As a file system that has no files without names.
  void refuse_unnamed() { unnamed_ = false; }

  void refuse_to_sync_directories() { syncs_directories_ = false; }

  [[nodiscard]] bool has_failed() const { return calls_left_ < 0; }
  [[nodiscard]] std::size_t open_files() const { return open_.size(); }

  Result<int> open_to_read(const std::filesystem::path& path, WaitPolicy wait) override {
    return opened([&] { return system_files().open_to_read(path, wait); });
  }
  Result<int> open_directory(const std::filesystem::path& path) override {
    auto directory = opened([&] { return system_files().open_directory(path); });
    if (directory) directories_.insert(*directory);
    return directory;
  }
  Result<int> create_unnamed(const std::filesystem::path& directory) override {
    if (!unnamed_) return tl::unexpected{std::make_error_code(std::errc::operation_not_supported)};
    return opened([&] { return system_files().create_unnamed(directory); });
  }
  Result<int> create_new(const std::filesystem::path& path) override {
    return opened([&] { return system_files().create_new(path); });
  }
  Result<mode_t> mode(int file) override {
    if (fails()) return failure();
    return system_files().mode(file);
  }
  Result<std::size_t> read(int file, std::span<std::byte> into) override {
    if (fails()) return failure();
    return system_files().read(file, into.first(std::min(into.size(), max_bytes_)));
  }
  Result<std::size_t> write(int file, std::uint64_t offset, std::span<const std::byte> bytes) override {
    if (fails()) return failure();
    return system_files().write(file, offset, bytes.first(std::min(bytes.size(), max_bytes_)));
  }
  Result<void> resize(int file, std::uint64_t bytes) override {
    if (fails()) return failure();
    return system_files().resize(file, bytes);
  }
  Result<void> sync(int file) override {
    if (fails()) return failure();
    if (!syncs_directories_ && directories_.contains(file)) {
      return tl::unexpected{std::make_error_code(std::errc::invalid_argument)};
    }
    return system_files().sync(file);
  }
  Result<void> name(int file, const std::filesystem::path& path) override {
    if (fails()) return failure();
    return system_files().name(file, path);
  }
  Result<void> rename(const std::filesystem::path& from, const std::filesystem::path& to) override {
    if (fails()) return failure();
    return system_files().rename(from, to);
  }
  void remove(const std::filesystem::path& path) override { system_files().remove(path); }
  void close(int file) override {
    open_.erase(file);
    directories_.erase(file);
    system_files().close(file);
  }

 private:
  [[nodiscard]] bool fails() { return calls_left_-- == 0; }
  [[nodiscard]] static tl::unexpected<std::error_code> failure() {
    return tl::unexpected{std::make_error_code(kError)};
  }
  template <typename Open>
  Result<int> opened(const Open& open) {
    if (fails()) return failure();
    auto file = open();
    if (file) open_.insert(*file);
    return file;
  }

  int calls_left_ = 1'000'000;
  std::size_t max_bytes_ = 1'000'000;
  bool unnamed_ = true;
  bool syncs_directories_ = true;
  std::set<int> open_;
  std::set<int> directories_;
};

}  // namespace talus::files
