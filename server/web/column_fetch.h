// Gets whole columns of chunks, from the world's lowest to its highest.
#pragma once

#include <cstddef>
#include <string>

#include <asio/awaitable.hpp>

#include "chunks/chunk_source.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/fetch.h"

namespace talus::server::web {

/// For one request.
class ColumnFetch {
 public:
  explicit ColumnFetch(Exchange& exchange) : exchange_{exchange}, fetch_{exchange.start_fetch()} {}

  /// Appends the column of `key` to `body`; an answer where it cannot be had. `held`: bytes that the request
  /// holds beside.
  [[nodiscard]] asio::awaitable<Answer> append(ChunkKey key, std::string& body, std::size_t held);
  /// So many were made so far, those of a column that failed among them.
  [[nodiscard]] std::size_t chunks() const { return chunks_; }

 private:
  Exchange& exchange_;
  Fetch& fetch_;
  std::size_t chunks_ = 0;
};

}  // namespace talus::server::web
