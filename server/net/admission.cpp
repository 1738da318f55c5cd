#include "net/admission.h"

#include <algorithm>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "net/address_text.h"

namespace talus::server {

asio::ip::address counted_as(const asio::ip::address& address) {
  const asio::ip::address own = unmapped(address);
  if (own.is_v4()) return own;
  auto bytes = own.to_v6().to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
  return asio::ip::address_v6{bytes};
}

FlowId flow_id_of(const asio::ip::address& counted, const FlowIds& ids) {
  return counted.is_v4() ? ids.of_address(counted.to_v4().to_bytes())
                         : ids.of_address(counted.to_v6().to_bytes());
}

FlowUsePtr flow_of(const asio::ip::address& counted, FlowUses& flows) {
  const std::string text = counted.to_string();
  return counted.is_v4() ? flows.of_address(counted.to_v4().to_bytes(), text)
                         : flows.of_address(counted.to_v6().to_bytes(), text + "/64");
}

Admission::Admission(const Limits& limits, const Clock& clock) : clock_{clock}, limits_{limits} {}

void Admission::change(const Limits& limits) {
  const std::lock_guard lock{mutex_};
  limits_ = limits;
  for (auto& [counted, here] : by_address_) {
    if (here.rates->rates == limits.rates) continue;
    here.rates = std::make_shared<AddressBuckets>(*here.rates, limits.rates, clock_.now());
  }
}

Admission::Slot::Slot(Admission& admission, const asio::ip::address& address, bool takes_place)
    : address_{address}, counted_{counted_as(address)} {
  if (!takes_place) return;
  part_ = std::make_unique<FlowShares::Part>(admission.places_, admission.flow_of(counted_), 1,
                                             admission.clock_.now());
}

Admission::Slot::Slot(Slot&& other) noexcept
    : admission_{std::exchange(other.admission_, nullptr)},
      address_{other.address_},
      counted_{other.counted_},
      part_{std::move(other.part_)} {}

Admission::Slot::~Slot() {
  if (admission_ == nullptr) return;
  const bool held_place = part_ != nullptr;
  part_.reset();
  admission_->leave(counted_, held_place);
}

void Admission::Slot::take_place(Slot& proxy) {
  part_ = std::move(proxy.part_);
  part_->move_to(admission_->flow_of(counted_));
}

tl::expected<Admission::Slot, std::string> Admission::enter(const asio::ip::address& address, Caller caller) {
  const asio::ip::address counted = counted_as(address);
  const std::lock_guard lock{mutex_};
  forget();
  auto known = by_address_.find(counted);
  if (caller != Caller::proxy && known != by_address_.end() &&
      known->second.connections >= limits_.per_address) {
    return tl::make_unexpected(fmt::format(
        "your address has {} connections, this server's limit for one address", known->second.connections));
  }
  const bool takes_place = caller != Caller::request;
  if (takes_place && !has_place_for(counted)) {
    return tl::make_unexpected(fmt::format("this server has {} connections, its limit", limits_.connections));
  }
  Slot slot{*this, address, takes_place};
  if (known == by_address_.end()) {
    known = by_address_.emplace(counted, Address{std::make_shared<AddressBuckets>(limits_.rates)}).first;
  }
  ++known->second.connections;
  if (takes_place) ++connections_;
  slot.admission_ = this;
  return slot;
}

bool Admission::has_place_for(const asio::ip::address& counted) {
  if (connections_ >= limits_.connections + kMaxClosing) return false;
  return places_.size() < limits_.connections ||
         places_.make_room(flow_of(counted), 1, limits_.connections / kFlows, clock_.now());
}

std::size_t Admission::connections() const {
  const std::lock_guard lock{mutex_};
  return connections_;
}

AddressBucketsPtr Admission::rates_of(const asio::ip::address& counted) const {
  const std::lock_guard lock{mutex_};
  return by_address_.at(counted).rates;
}

void Admission::leave(const asio::ip::address& counted, bool held_place) noexcept {
  const std::lock_guard lock{mutex_};
  if (held_place) --connections_;
  Address& here = by_address_.at(counted);
  if (--here.connections == 0) {
    const auto now = clock_.now();
    here.forget_at = now + std::max<Clock::duration>(limits_.memory, here.rates->saved_up_in(now));
    try {
      if (!here.listed) left_.push_back(counted);
      here.listed = true;
    } catch (const std::bad_alloc&) {
      by_address_.erase(counted);  // at once: its rates start full again
    }
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
