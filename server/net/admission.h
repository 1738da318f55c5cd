// How many connections there are, in all and from each address. Callable from any thread.
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

/// Whom an address counts as: an IPv4 address (also one mapped into IPv6) stands for itself, an IPv6
/// address for its /64 network, which is what one customer commonly has.
[[nodiscard]] asio::ip::address counted_as(const asio::ip::address& address);

/// The flow of all that counts as one address.
[[nodiscard]] FlowUsePtr flow_of(const asio::ip::address& counted, FlowUses& flows);

class Admission {
 public:
  /// Addresses without a connection whose rates are remembered, so that coming back does not fill them.
  static constexpr std::size_t kMaxRemembered = 4096;

  struct Limits {
    std::size_t connections = 0;  // in all
    std::size_t per_address = 0;
    std::chrono::milliseconds memory{};  // of an address after its last connection: as long as rates fill
    RateSet rates{};                     // of an address
  };
  /// `clock` outlives it.
  Admission(const Limits& limits, const Clock& clock);

  /// Who is in stays. Each address gets new buckets with what is left in the old: Slot::rates() has them.
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
    /// Whom its address counts as.
    [[nodiscard]] const asio::ip::address& counted() const { return counted_; }
    /// Shared with the address's other connections.
    [[nodiscard]] AddressBucketsPtr rates() const { return admission_->rates_of(counted_); }

   private:
    Admission* admission_;
    asio::ip::address address_;
    asio::ip::address counted_;
  };

  /// A slot, or a line that says which limit is reached.
  [[nodiscard]] tl::expected<Slot, std::string> enter(const asio::ip::address& address) {
    return enter(address, /*of_proxy=*/false);
  }
  /// For a connection on which a proxy speaks for many clients: not one of its address's.
  [[nodiscard]] tl::expected<Slot, std::string> enter_proxy(const asio::ip::address& address) {
    return enter(address, /*of_proxy=*/true);
  }

  [[nodiscard]] std::size_t connections() const;
  /// With a connection, or remembered.
  [[nodiscard]] std::size_t addresses() const;

 private:
  struct Address {
    AddressBucketsPtr rates;
    std::size_t connections = 0;
    Clock::time_point forget_at{};  // while without connections
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
  std::deque<asio::ip::address> left_;  // without a connection, each once; some are back
};

}  // namespace talus::server
