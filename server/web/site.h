// The files that talusd serves outside /v1: the viewer. Read whole at the start, so that requests never
// access the file system. Immutable: any number of threads may read.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/files/file_layer.h>

#include "net/http/response.h"

namespace talus::server::web {

class Site {
 public:
  static constexpr std::size_t kMaxFiles = 1000;
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
  static constexpr int kMaxDepth = 8;  // folders

  /// An encoding of a file, as sent over the wire.
  struct Form {
    std::string_view encoding;  // Content-Encoding; empty: not encoded
    std::string bytes;
    http::EntityTag etag;
  };
  struct File {
    std::string_view content_type;
    bool hashed = false;      // its name changes with its content
    std::vector<Form> forms;  // br, gzip, plain: the ones that exist

    /// Returns the first form that Accept-Encoding allows, or the last, which every client accepts.
    [[nodiscard]] const Form& form_for(std::string_view accept_encoding) const;
  };

  /// Reads the whole directory except names that begin with a dot. FILE.br and FILE.gz are the compressed
  /// forms of FILE. Links must not lead out of the directory. The error is one line.
  [[nodiscard]] static tl::expected<std::shared_ptr<const Site>, std::string> read(
      const std::filesystem::path& directory, files::FileLayer& layer = files::system_files());

  /// Finds a file by a request's path; a path that ends in '/' means its index.html. Returns null if not
  /// found.
  [[nodiscard]] const File* find(std::string_view path) const;
  /// Returns true if the site contains WebAssembly.
  [[nodiscard]] bool has_wasm() const { return has_wasm_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t files() const { return files_.size(); }

 private:
  std::map<std::string, File, std::less<>> files_;  // by path: "assets/x.js"
  std::size_t bytes_ = 0;
  bool has_wasm_ = false;
};

}  // namespace talus::server::web
