#include "net/admission.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace talus::server {

asio::ip::address counted_as(const asio::ip::address& address) {
  if (address.is_v4()) return address;
  const asio::ip::address_v6 v6 = address.to_v6();
  if (v6.is_v4_mapped()) return asio::ip::make_address_v4(asio::ip::v4_mapped, v6);
  auto bytes = v6.to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
  return asio::ip::address_v6{bytes};
}

FlowId flow_of(const asio::ip::address& counted, const FlowIds& flows) {
  return counted.is_v4() ? flows.of_address(counted.to_v4().to_bytes())
                         : flows.of_address(counted.to_v6().to_bytes());
}

Admission::Admission(std::size_t max, std::size_t max_per_address, std::chrono::milliseconds memory,
                     const Clock& clock)
    : max_{max}, max_per_address_{max_per_address}, memory_{memory}, clock_{clock} {}

Admission::Slot::Slot(Slot&& other) noexcept
    : admission_{std::exchange(other.admission_, nullptr)},
      counted_{std::move(other.counted_)},
      rates_{std::move(other.rates_)} {}

Admission::Slot::~Slot() {
  if (admission_ != nullptr) admission_->leave(counted_);
}

tl::expected<Admission::Slot, std::string> Admission::enter(const asio::ip::address& address) {
  const asio::ip::address counted = counted_as(address);
  const std::lock_guard lock{mutex_};
  if (connections_ >= max_) {
    return tl::make_unexpected(fmt::format("this server has {} connections, all it takes", max_));
  }
  forget();
  Address& here = by_address_[counted];
  if (here.connections >= max_per_address_) {
    return tl::make_unexpected(fmt::format(
        "your address has {} connections, all that this server takes from one", max_per_address_));
  }
  ++here.connections;
  ++connections_;
  return Slot{*this, counted, here.rates};
}

std::size_t Admission::connections() const {
  const std::lock_guard lock{mutex_};
  return connections_;
}

void Admission::leave(const asio::ip::address& counted) {
  const std::lock_guard lock{mutex_};
  --connections_;
  Address& here = by_address_.at(counted);
  if (--here.connections == 0) {
    here.forget_at = clock_.now() + memory_;
    if (!std::exchange(here.listed, true)) left_.push_back(counted);
  }
  forget();
}

void Admission::forget() {
  for (; !left_.empty(); left_.pop_front()) {
    const auto first = by_address_.find(left_.front());
    if (first->second.connections > 0) {
      first->second.listed = false;
    } else if (first->second.forget_at <= clock_.now() || left_.size() > kMaxRemembered) {
      by_address_.erase(first);
    } else {
      return;
    }
  }
}

std::size_t Admission::addresses() const {
  const std::lock_guard lock{mutex_};
  return by_address_.size();
}

}  // namespace talus::server
