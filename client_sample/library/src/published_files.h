// Fetches the files of a published world, part by part. No I/O of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/client/chunk_maker.h>

#include "requests.h"

namespace talus::client {

class PublishedFiles {
 public:
  static constexpr std::size_t kMaxNameBytes = 1024;
  static constexpr std::size_t kMaxFiles = 256;
  static constexpr std::uint64_t kMaxWorldFileBytes = std::uint64_t{1} << 20;
  /// Of all files together: the largest height map fits.
  static constexpr std::uint64_t kMaxBytes = (std::uint64_t{1} << 28) + (std::uint64_t{2} << 20);

  [[nodiscard]] const std::shared_ptr<const WorldFiles>& files() const { return files_; }
  void keep(std::shared_ptr<const WorldFiles> files) { files_ = std::move(files); }

  /// Begins with the file of this name. Returns why it cannot be fetched; empty: it can.
  [[nodiscard]] std::string begin(const std::string& name);
  /// The next part to be requested.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint64_t offset() const { return bytes_.size(); }
  /// Takes the part requested. True if the file is complete, and among files(); an error is one line.
  [[nodiscard]] tl::expected<bool, std::string> take(const FileRequest::Part& part);

 private:
  std::shared_ptr<const WorldFiles> files_ = std::make_shared<const WorldFiles>();
  std::uint64_t total_ = 0;  // bytes of files_ and bytes_
  std::string name_;
  std::vector<std::byte> bytes_;
  std::uint64_t size_ = 0;  // of the file, once a part came
};

}  // namespace talus::client
