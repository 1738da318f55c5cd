// Lets connections of one io_context read that have answered all that came. One posted handler does it for
// many who wait: one each would cost a fifth of what answering costs outside the kernel.
#pragma once

#include <cstddef>
#include <deque>
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
    if (rounds_.empty() || rounds_.back().size() == kMostAtOnce) {
      asio::post(executor, [this] { go_round(); });
      rounds_.push_back(std::move(spare_));
    }
    rounds_.back().push_back(std::move(reader));
  }

 private:
  using Round = std::vector<std::shared_ptr<Reader>>;
  static constexpr std::size_t kMostAtOnce = 256;  // what else the thread has to do comes in between

  void go_round() {
    if (rounds_.empty()) return;  // there was no memory for it
    Round round = std::move(rounds_.front());
    rounds_.pop_front();
    for (const auto& reader : round) reader->read();
    round.clear();
    spare_ = std::move(round);
  }
  void shutdown() noexcept override {
    rounds_.clear();
    spare_.clear();
  }

  std::deque<Round> rounds_;  // each has a posted handler
  Round spare_;               // memory of one before
};

}  // namespace talus::server::http
