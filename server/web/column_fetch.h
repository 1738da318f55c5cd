// Fetches whole columns of chunks, from the bottom of the world to its top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <asio/awaitable.hpp>

#include "chunks/chunk_source.h"
#include "chunks/edited_land.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/fetch.h"

namespace talus::server::web {

/// For one request.
class ColumnFetch {
 public:
  ColumnFetch(Exchange& exchange, Version version)
      : exchange_{exchange},
        version_{version},
        edits_{version == Version::edited ? exchange.context().edits : nullptr},
        fetch_{exchange.start_fetch()} {}

  /// Appends the column of `key` to `body`, or returns an error. `held`: bytes that the request holds in
  /// addition.
  [[nodiscard]] asio::awaitable<Answer> append(ChunkKey key, std::string& body, std::size_t held);
  /// Number of chunks generated so far, including the chunks of a failed column.
  [[nodiscard]] std::size_t chunks() const { return chunks_; }
  /// Greatest revision of the chunks.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  Exchange& exchange_;
  const Version version_;
  const EditedLand* const edits_;  // null: without edits
  Fetch& fetch_;
  std::size_t chunks_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace talus::server::web
