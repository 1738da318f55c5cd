// A file of a FileLayer that closes itself.
#pragma once

#include <utility>

#include <talus/files/file_layer.h>

namespace talus::files {

class OpenFile {
 public:
  OpenFile(FileLayer& layer, int file) : layer_{&layer}, file_{file} {}
  OpenFile(OpenFile&& other) noexcept : layer_{other.layer_}, file_{std::exchange(other.file_, -1)} {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile() {
    if (file_ >= 0) layer_->close(file_);
  }

  [[nodiscard]] int get() const { return file_; }

 private:
  FileLayer* layer_;
  int file_;
};

}  // namespace talus::files
