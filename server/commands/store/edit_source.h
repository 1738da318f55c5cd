// The files that `talusd store import` takes: those of `talusd store export`, and saves of single players.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>

#include "commands/store/portable_file.h"

namespace talus::server {

class EditSource {
 public:
  virtual ~EditSource() = default;
  [[nodiscard]] virtual const PortableHeader& header() const = 0;
  /// The chunks by rising x, z, y, then nullopt, once all of them are verified.
  [[nodiscard]] virtual tl::expected<std::optional<PortableChunk>, std::string> next() = 0;
  /// Bytes read so far, for a progress bar.
  [[nodiscard]] virtual std::uint64_t bytes_read() const = 0;
  /// The world, if the file has it.
  [[nodiscard]] virtual const terrain::World* world() const { return nullptr; }
};

/// An error is one line without the file's name; `now_ms`, since 1970, dates what has no date.
[[nodiscard]] tl::expected<std::unique_ptr<EditSource>, std::string> open_edits(
    const std::filesystem::path& file, std::int64_t now_ms);

}  // namespace talus::server
