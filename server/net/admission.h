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

#include "clock/clock.h"
#include "flows/flow_ids.h"
#include "rates/rates.h"

namespace talus::server {

/// Whom an address counts as: an IPv4 address (also one mapped into IPv6) stands for itself, an IPv6
/// address for its /64 network, which is what one customer commonly has.
[[nodiscard]] asio::ip::address counted_as(const asio::ip::address& address);

/// The flow of all that counts as one address.
[[nodiscard]] FlowId flow_of(const asio::ip::address& counted, const FlowIds& flows);

class Admission {
 public:
  /// Addresses without a connection whose rates are remembered, so that coming back does not fill them.
  static constexpr std::size_t kMaxRemembered = 4096;

  /// An address is remembered for `memory` after its last connection: as long as its rates need to fill.
  /// `clock` outlives it.
  Admission(std::size_t max, std::size_t max_per_address, std::chrono::milliseconds memory,
            const Clock& clock);

  /// Counts as one connection until it is destroyed. Must not outlive its Admission.
  class Slot {
   public:
    Slot(Admission& admission, const asio::ip::address& counted, AddressBucketsPtr rates)
        : admission_{&admission}, counted_{counted}, rates_{std::move(rates)} {}
    Slot(Slot&& other) noexcept;
    Slot& operator=(Slot&&) = delete;
    ~Slot();

    /// Whom its address counts as.
    [[nodiscard]] const asio::ip::address& counted() const { return counted_; }
    /// Shared with the address's other connections.
    [[nodiscard]] const AddressBucketsPtr& rates() const { return rates_; }

   private:
    Admission* admission_;
    asio::ip::address counted_;
    AddressBucketsPtr rates_;
  };

  /// A slot, or a line that says which limit is reached.
  [[nodiscard]] tl::expected<Slot, std::string> enter(const asio::ip::address& address);

  [[nodiscard]] std::size_t connections() const;
  /// With a connection, or remembered.
  [[nodiscard]] std::size_t addresses() const;

 private:
  struct Address {
    std::size_t connections = 0;
    AddressBucketsPtr rates = std::make_shared<AddressBuckets>();
    Clock::time_point forget_at{};  // while without connections
    bool listed = false;            // in left_
  };

  void leave(const asio::ip::address& counted);
  void forget();

  const std::size_t max_;
  const std::size_t max_per_address_;
  const std::chrono::milliseconds memory_;
  const Clock& clock_;
  mutable std::mutex mutex_;
  std::size_t connections_ = 0;
  std::map<asio::ip::address, Address> by_address_;
  std::deque<asio::ip::address> left_;  // without a connection, each once; some are back
};

}  // namespace talus::server
