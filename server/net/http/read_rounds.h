// Schedules the next read of connections of one io_context that have answered all their input. One posted
// handler serves many connections: one for each would cost a fifth of the user-space work of an answer.
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

/// One for each io_context (asio::use_service); called only on its thread.
class ReadRounds final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;

  class Reader {
   public:
    virtual ~Reader() = default;
    /// Must not throw: other readers follow.
    virtual void read() noexcept = 0;
  };

  explicit ReadRounds(asio::execution_context& context) : service{context} {}

  /// Calls `reader->read()` on `executor`, which belongs to the context, after the requests waiting now.
  /// Throws if out of memory; then nothing is scheduled.
  void enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor) {
    if (rounds_.empty() || rounds_.back().size() == kMostAtOnce) {
      asio::post(executor, [this] { go_round(); });
      rounds_.push_back(std::move(spare_));
    }
    rounds_.back().push_back(std::move(reader));
  }

 private:
  using Round = std::vector<std::shared_ptr<Reader>>;
  static constexpr std::size_t kMostAtOnce = 256;  // other handlers of the thread run in between

  void go_round() {
    if (rounds_.empty()) return;  // out of memory when it was entered
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
  Round spare_;               // memory of an earlier round
};

}  // namespace talus::server::http
