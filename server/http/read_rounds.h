// Lets connections of one io_context read that have answered all that came. One posted handler does it for
// all who wait: one each would cost a fifth of what answering costs outside the kernel.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/execution_context.hpp>
#include <asio/post.hpp>

namespace talus::server::http {

/// One for each io_context (asio::use_service), on whose only thread it is called.
class ReadRounds final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;

  class Reader {
   public:
    virtual ~Reader() = default;
    /// Throws nothing: others wait behind it.
    virtual void read() noexcept = 0;
  };

  explicit ReadRounds(asio::execution_context& context) : service{context} {}

  /// `reader` reads after those whose requests wait now, on `executor`, which is of the context. Throws where
  /// there is no memory, and then it does not.
  void enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor) {
    if (waiting_.empty()) asio::post(executor, [this] { go_round(); });
    waiting_.push_back(std::move(reader));
  }

 private:
  void go_round() {
    reading_.swap(waiting_);
    for (const auto& reader : reading_) reader->read();
    reading_.clear();
  }
  void shutdown() noexcept override {
    waiting_.clear();
    reading_.clear();
  }

  std::vector<std::shared_ptr<Reader>> waiting_;
  std::vector<std::shared_ptr<Reader>> reading_;  // of go_round()
};

}  // namespace talus::server::http
