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

Admission::Admission(std::size_t most, std::size_t most_per_address)
    : most_{most}, most_per_address_{most_per_address} {}

Admission::Place::Place(Place&& other) noexcept
    : admission_{std::exchange(other.admission_, nullptr)}, counted_{std::move(other.counted_)} {}

Admission::Place::~Place() {
  if (admission_ != nullptr) admission_->leave(counted_);
}

tl::expected<Admission::Place, std::string> Admission::enter(const asio::ip::address& address) {
  const asio::ip::address counted = counted_as(address);
  const std::lock_guard lock{mutex_};
  if (connections_ >= most_) {
    return tl::make_unexpected(fmt::format("this server has {} connections, all it takes", most_));
  }
  std::size_t& here = by_address_[counted];
  if (here >= most_per_address_) {
    return tl::make_unexpected(fmt::format(
        "your address has {} connections, all that this server takes from one", most_per_address_));
  }
  ++here;
  ++connections_;
  return Place{*this, counted};
}

std::size_t Admission::connections() const {
  const std::lock_guard lock{mutex_};
  return connections_;
}

void Admission::leave(const asio::ip::address& counted) {
  const std::lock_guard lock{mutex_};
  --connections_;
  const auto found = by_address_.find(counted);
  if (--found->second == 0) by_address_.erase(found);
}

}  // namespace talus::server
