// The files that talusd serves beside /v1: the viewer. Read whole at the start, so that no request reaches
// the file system. Immutable: any number of threads may read.
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

  /// A form of a file, as it goes over the wire.
  struct Form {
    std::string_view encoding;  // Content-Encoding; empty: as it is
    std::string bytes;
    http::EntityTag etag;
  };
  struct File {
    std::string_view content_type;
    bool hashed = false;      // its name changes with its content
    std::vector<Form> forms;  // br, gzip, plain: as far as they are there

    /// The first form that Accept-Encoding takes; null: there is no such field. The last takes everybody.
    [[nodiscard]] const Form& form_for(const std::string* accept_encoding) const;
  };

  /// All of the directory but names that begin with a dot. FILE.br and FILE.gz beside FILE are its compressed
  /// forms. Links may not lead out of it. The error is one line.
  [[nodiscard]] static tl::expected<std::shared_ptr<const Site>, std::string> read(
      const std::filesystem::path& directory, files::FileLayer& layer = files::system_files());

  /// By a request's path; one that ends in '/' is that folder's index.html. Null: there is none.
  [[nodiscard]] const File* find(std::string_view path) const;
  /// Whether a file of it is WebAssembly.
  [[nodiscard]] bool has_wasm() const { return has_wasm_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t files() const { return files_.size(); }

 private:
  std::map<std::string, File, std::less<>> files_;  // by path: "assets/x.js"
  std::size_t bytes_ = 0;
  bool has_wasm_ = false;
};

}  // namespace talus::server::web
