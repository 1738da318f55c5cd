// Counts connections, in total and per address. Callable from any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <string>

#include <asio/ip/address.hpp>
#include <tl/expected.hpp>

#include "limits/flows/flow_uses.h"
#include "limits/rates/rates.h"
#include "runtime/clock.h"

namespace talus::server {

/// The address that limits and rates apply to: an IPv4 address (also one mapped into IPv6) itself; for an
/// IPv6 address its /64 network, which is commonly one customer's.
[[nodiscard]] asio::ip::address counted_as(const asio::ip::address& address);

/// The flow of a counted address.
[[nodiscard]] FlowUsePtr flow_of(const asio::ip::address& counted, FlowUses& flows);

class Admission {
 public:
  /// Maximum number of addresses without a connection whose rates are kept, so that reconnecting does not
  /// refill them.
  static constexpr std::size_t kMaxRemembered = 4096;

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
    Slot(Admission& admission, const asio::ip::address& address)
        : admission_{&admission}, address_{address}, counted_{counted_as(address)} {}
    Slot(Slot&& other) noexcept;
    Slot& operator=(Slot&&) = delete;
    ~Slot();

    [[nodiscard]] const asio::ip::address& address() const { return address_; }
    /// counted_as() of the address.
    [[nodiscard]] const asio::ip::address& counted() const { return counted_; }
    /// Shared with the address's other connections.
    [[nodiscard]] AddressBucketsPtr rates() const { return admission_->rates_of(counted_); }

   private:
    Admission* admission_;
    asio::ip::address address_;
    asio::ip::address counted_;
  };

  /// Returns a slot, or a line that names the limit reached.
  [[nodiscard]] tl::expected<Slot, std::string> enter(const asio::ip::address& address) {
    return enter(address, /*of_proxy=*/false);
  }
  /// For a proxy's connection that carries requests of many clients: the limit per address does not apply.
  [[nodiscard]] tl::expected<Slot, std::string> enter_proxy(const asio::ip::address& address) {
    return enter(address, /*of_proxy=*/true);
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

  [[nodiscard]] tl::expected<Slot, std::string> enter(const asio::ip::address& address, bool of_proxy);
  [[nodiscard]] AddressBucketsPtr rates_of(const asio::ip::address& counted) const;
  void leave(const asio::ip::address& counted) noexcept;
  void forget();

  const Clock& clock_;
  mutable std::mutex mutex_;
  Limits limits_;
  std::size_t connections_ = 0;
  std::map<asio::ip::address, Address> by_address_;
  std::deque<asio::ip::address> left_;  // addresses without a connection, each once; some have reconnected
};

}  // namespace talus::server
