// A file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "failure.h"

namespace talus::tools {

/// Writes go to a temporary file in the target's directory, without a name where the file system can, so that
/// a killed process leaves nothing; commit() renames it over the target. Without
/// commit() the destructor removes the temporary and the target stays as it was. write_at() may be called
/// from many threads at once.
class AtomicFile {
 public:
  /// Refuses targets that exist and are no regular files, so that a device is never renamed over.
  [[nodiscard]] static Expected<AtomicFile> create(const std::filesystem::path& target);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Bytes between what has been written read as zero.
  [[nodiscard]] Expected<void> write_at(std::uint64_t offset, std::span<const std::byte> bytes) const;
  /// Cuts the file, or lengthens it with zeros.
  [[nodiscard]] Expected<void> resize(std::uint64_t bytes) const;
  [[nodiscard]] Expected<void> commit();

  [[nodiscard]] const std::filesystem::path& target() const { return target_; }

 private:
  AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

}  // namespace talus::tools
