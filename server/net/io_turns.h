// Shares an io thread's time among flows, however many connections they have. What a client sends costs the
// thread units, of a few microseconds each: a request by HTTP, or a frame, takes one, and large ones more; a
// step of a TLS handshake takes more than a turn. A flow goes on at once until it has used kTurn units of the
// round. Then its connections wait in a queue of their own, and flows with such a queue take turns: each goes
// on for kTurn units of the next round. What a flow used beyond, it pays in further rounds.
//
// So what comes from a client waits for one turn of each other flow at most, or two after a step of its own
// handshake, and a thread with one flow never waits (deficit round robin; Shreedhar and Varghese, 1995).
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <unordered_map>

#include <asio/any_io_executor.hpp>
#include <asio/execution_context.hpp>

#include "limits/flows/flow_ids.h"

namespace talus::server {

/// One for each io_context (asio::use_service), used by the thread that runs it.
class IoTurns final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;

  /// Units that a flow may use in a round; the last piece may exceed them.
  static constexpr std::uint64_t kTurn = 32;
  /// Units of a step of a TLS handshake, which decrypts or signs.
  static constexpr std::uint64_t kHandshakeStep = 2 * kTurn;
  /// Bytes that cost a unit: of input, or of an answer that is not sent at once.
  static constexpr std::size_t kInputBytes = 128;
  static constexpr std::size_t kAnswerBytes = std::size_t{8} * 1024;
  /// Units of a frame, a request's head, or a read with so many bytes of WebSocket's own.
  [[nodiscard]] static constexpr std::uint64_t input_cost(std::size_t bytes) {
    return 1 + bytes / kInputBytes;
  }

  /// A connection that may wait for a turn of its flow, once at a time.
  class Waiter {
   public:
    virtual ~Waiter() = default;
    /// Go on, as long as go_on() lets it, and wait() again for what is left.
    virtual void take_turn() = 0;
  };

  explicit IoTurns(asio::execution_context& context) : service{context} {}

  /// Returns true and charges the flow if it may go on with a piece of this cost, at least 1; false if the
  /// piece has to wait().
  [[nodiscard]] bool go_on(FlowId flow, std::uint64_t cost = 1);
  /// Charges the flow for more than was known before the piece.
  void charge(FlowId flow, std::uint64_t cost) { settled(flow).used += cost; }
  /// The piece cost less by this.
  void give_back(FlowId flow, std::uint64_t cost) {
    Flow& of = settled(flow);
    of.used -= of.used < cost ? of.used : cost;
  }
  /// Calls waiter->take_turn() in a turn of the flow, from a handler of `executor`, which belongs to the
  /// context. Throws std::bad_alloc without effect.
  void wait(FlowId flow, std::shared_ptr<Waiter> waiter, const asio::any_io_executor& executor);

 private:
  struct Flow {
    std::uint64_t used = 0;   // units, less those of the rounds before
    std::uint64_t round = 0;  // in which `used` is right
    bool queued = false;      // in a round
    std::list<std::shared_ptr<Waiter>> waiters;
  };
  // As many flows are kept before those that neither wait nor owe anything are forgotten.
  static constexpr std::size_t kKept = 1024;

  void shutdown() noexcept override;
  [[nodiscard]] Flow& settled(FlowId flow);
  void settle(Flow& flow) const;
  void forget();
  void post(const asio::any_io_executor& executor);
  /// Gives one flow its turn; what came meanwhile is served before the next one's.
  void give_turn(const asio::any_io_executor& executor);

  std::unordered_map<FlowId, Flow> flows_;
  std::list<FlowId> this_round_;  // in the order of their turns
  std::list<FlowId> next_round_;
  std::uint64_t round_ = 0;
  std::size_t forget_at_ = kKept;  // flows
  bool posted_ = false;            // give_turn() waits or runs
  std::optional<FlowId> has_turn_;
};

}  // namespace talus::server
