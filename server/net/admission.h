// Counts connections, in total and per address. Callable from any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include <asio/ip/address.hpp>
#include <tl/expected.hpp>

#include "limits/flows/flow_ids.h"
#include "limits/flows/flow_shares.h"
#include "limits/flows/flow_uses.h"
#include "limits/rates/rates.h"
#include "runtime/clock.h"

namespace talus::server {

/// Text of an error when a connection gives way to another address's.
inline constexpr std::string_view kNoPlace = "this server has all the connections that it may have";

/// The address that limits and rates apply to: an IPv4 address (also one mapped into IPv6) itself; for an
/// IPv6 address its /64 network, which is commonly one customer's.
[[nodiscard]] asio::ip::address counted_as(const asio::ip::address& address);

/// The flow of a counted address.
[[nodiscard]] FlowId flow_id_of(const asio::ip::address& counted, const FlowIds& ids);
[[nodiscard]] FlowUsePtr flow_of(const asio::ip::address& counted, FlowUses& flows);

class Admission {
 public:
  /// Maximum number of addresses without a connection whose rates are kept, so that reconnecting does not
  /// refill them.
  static constexpr std::size_t kMaxRemembered = 4096;

  /// Maximum number of connections above the limit: those that have given way, and still close.
  static constexpr std::size_t kMaxClosing = 64;
  /// A flow may always have the places divided by this.
  static constexpr std::size_t kFlows = 64;
  /// A handshake that takes longer than this gives way before others.
  static constexpr std::chrono::seconds kHandshakePatience{3};

  struct Limits {
    std::size_t connections = 0;  // in total
    std::size_t per_address = 0;
    std::chrono::milliseconds memory{};  // how long an address is kept after its last connection; longer if
                                         // its rates take longer to fill
    RateSet rates{};                     // per address
  };
  /// `clock` outlives it.
  Admission(const Limits& limits, const Clock& clock);

  /// Existing connections stay. Each address gets new buckets with the levels of the old ones: see
  /// Slot::rates().
  void change(const Limits& limits);

  /// Counts as one connection until it is destroyed. Must not outlive its Admission.
  class Slot {
   public:
    Slot(Slot&& other) noexcept;
    Slot& operator=(Slot&&) = delete;
    ~Slot();

    [[nodiscard]] const asio::ip::address& address() const { return address_; }
    /// counted_as() of the address.
    [[nodiscard]] const asio::ip::address& counted() const { return counted_; }
    /// Shared with the address's other connections.
    [[nodiscard]] AddressBucketsPtr rates() const { return admission_->rates_of(counted_); }

    /// From here on the connection may give way to other flows' by `give_way`.
    void set_give_way(FlowShares::GiveWay give_way) { part_->set_give_way(std::move(give_way)); }
    /// From here on the connection counts for the subject's flow.
    void move_to(std::string_view subject) { part_->move_to(admission_->ids_.of_subject(subject)); }
    /// For the slot of a request that becomes a session: takes the place of the proxy's connection.
    void take_place(Slot& proxy);
    /// The client sent something.
    void progress(Clock::time_point now) { part_->progress(now); }

   private:
    friend class Admission;
    Slot(Admission& admission, const asio::ip::address& address, bool takes_place);

    Admission* admission_ = nullptr;  // once it is counted
    asio::ip::address address_;
    asio::ip::address counted_;
    std::unique_ptr<FlowShares::Part> part_;  // null: it holds no place
  };

  /// The flow of a counted address, for places and handshakes: FlowUses has other ids.
  [[nodiscard]] FlowId flow_of(const asio::ip::address& counted) const { return flow_id_of(counted, ids_); }
  /// Places of handshakes in flight.
  [[nodiscard]] FlowShares& handshakes() { return handshakes_; }

  /// Returns a slot, or a line that names the limit reached.
  [[nodiscard]] tl::expected<Slot, std::string> enter(const asio::ip::address& address) {
    return enter(address, Caller::client);
  }
  /// For a proxy's connection that carries requests of many clients: the limit per address does not apply.
  [[nodiscard]] tl::expected<Slot, std::string> enter_proxy(const asio::ip::address& address) {
    return enter(address, Caller::proxy);
  }
  /// For one request by a proxy's connection, which holds the place.
  [[nodiscard]] tl::expected<Slot, std::string> enter_request(const asio::ip::address& address) {
    return enter(address, Caller::request);
  }

  [[nodiscard]] std::size_t connections() const;
  /// Number of addresses with a connection or remembered.
  [[nodiscard]] std::size_t addresses() const;

 private:
  struct Address {
    AddressBucketsPtr rates;
    std::size_t connections = 0;
    Clock::time_point forget_at{};  // if it has no connections
    bool listed = false;            // in left_
  };

  enum class Caller : std::uint8_t { client, proxy, request };
  [[nodiscard]] tl::expected<Slot, std::string> enter(const asio::ip::address& address, Caller caller);
  /// If all places are taken, a connection of another flow gives way.
  [[nodiscard]] bool has_place_for(const asio::ip::address& counted);
  [[nodiscard]] AddressBucketsPtr rates_of(const asio::ip::address& counted) const;
  void leave(const asio::ip::address& counted, bool held_place) noexcept;
  void forget();

  const Clock& clock_;
  const FlowIds ids_;
  FlowShares places_{Clock::duration::max()};  // the watchdog ends idle connections
  FlowShares handshakes_{kHandshakePatience};
  mutable std::mutex mutex_;
  Limits limits_;
  std::size_t connections_ = 0;  // that hold places, or have given way
  std::map<asio::ip::address, Address> by_address_;
  std::deque<asio::ip::address> left_;  // addresses without a connection, each once; some have reconnected
};

}  // namespace talus::server
