// Gets whole columns of chunks, from the world's lowest to its highest.
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
  /// As generated, or, where `edited`, with their edits.
  ColumnFetch(Exchange& exchange, bool edited)
      : exchange_{exchange},
        source_{exchange.chunks(edited)},
        edits_{edited ? exchange.context().edits : nullptr},
        fetch_{exchange.start_fetch(edited)} {}

  /// Appends the column of `key` to `body`; an answer where it cannot be had. `held`: bytes that the request
  /// holds beside.
  [[nodiscard]] asio::awaitable<Answer> append(ChunkKey key, std::string& body, std::size_t held);
  /// So many were made so far, those of a column that failed among them.
  [[nodiscard]] std::size_t chunks() const { return chunks_; }
  /// The greatest revision that any of them has.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  Exchange& exchange_;
  ChunkSource& source_;
  const EditedLand* const edits_;  // null: none are wanted
  Fetch& fetch_;
  std::size_t chunks_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace talus::server::web
