// Wakes the sessions of one io_context that have mail. The thread that answers a batch of edits answers many
// sessions at once. One posted handler serves all of them: one for each would cost that thread an allocation,
// a lock that the context's thread also takes, and usually a system call.
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
  /// Sessions served by one handler before other handlers of the context run.
  static constexpr std::size_t kAtOnce = 32;

  class Reader {
   public:
    virtual ~Reader() = default;
    /// Called on the context's thread.
    virtual void read_mail() = 0;
  };

  explicit MailRounds(asio::execution_context& context) : service{context} { now_.reserve(kAtOnce); }

  /// From any thread: has `reader` read its mail soon, on `executor`, which belongs to the context. Throws if
  /// out of memory; then `reader` is not entered, and one entered by another thread at that moment is served
  /// with the next.
  void enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor);

 private:
  void shutdown() noexcept override;
  /// Serves all entered readers, including readers entered meanwhile, which then need no handler of their
  /// own.
  void go_round(const asio::any_io_executor& executor);
  /// Moves up to `most` of the oldest readers to now_. Returns false if there are none left; the next enter()
  /// then posts.
  [[nodiscard]] bool take(std::size_t most);

  std::mutex mutex_;
  std::vector<std::shared_ptr<Reader>> readers_;
  bool posted_ = false;                       // a handler that serves them
  std::vector<std::shared_ptr<Reader>> now_;  // of go_round(); has capacity kAtOnce
};

}  // namespace talus::server
