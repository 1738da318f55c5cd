// Wakes those of one io_context for whom mail has come. The thread that answers a batch of edits answers many
// sessions at once: one posted handler looks at all of them, where one each would cost that thread an
// allocation, a lock that the context's thread wants too, and mostly a system call.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/execution_context.hpp>

namespace talus::server {

/// One for each io_context (asio::use_service).
class MailRounds final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;
  /// So many are looked at by one handler; then others of the context have their turn.
  static constexpr std::size_t kAtOnce = 32;

  class Reader {
   public:
    virtual ~Reader() = default;
    /// On the context's thread.
    virtual void read_mail() = 0;
  };

  explicit MailRounds(asio::execution_context& context) : service{context} { now_.reserve(kAtOnce); }

  /// From any thread: `reader` reads its mail soon, on `executor`, which is of the context. Throws where
  /// there is no memory, and then it does not, and who entered at that very moment does with the next.
  void enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor);

 private:
  void shutdown() noexcept override;
  /// Reads for all who entered, also since it began, so that these need no handler of their own.
  void go_round(const asio::any_io_executor& executor);
  /// At most so many of those who entered first, to now_. False: there are none, and who enters next posts.
  [[nodiscard]] bool take(std::size_t most);

  std::mutex mutex_;
  std::vector<std::shared_ptr<Reader>> readers_;
  bool posted_ = false;                       // a handler that takes them
  std::vector<std::shared_ptr<Reader>> now_;  // of go_round(); has memory for kAtOnce
};

}  // namespace talus::server
