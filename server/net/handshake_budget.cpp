#include "net/handshake_budget.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "net/admission.h"

namespace talus::server {
namespace {

/// The finalizer of MurmurHash3, over both halves.
std::uint64_t mixed(std::uint64_t value) {
  value = (value ^ value >> 33) * 0xFF51AFD7ED558CCDULL;
  value = (value ^ value >> 33) * 0xC4CEB9FE1A85EC53ULL;
  return value ^ value >> 33;
}

using Key = std::array<std::uint64_t, 2>;

Key halves(const asio::ip::address& counted) {
  const auto bytes = counted.is_v4()
                         ? asio::ip::make_address_v6(asio::ip::v4_mapped, counted.to_v4()).to_bytes()
                         : counted.to_v6().to_bytes();
  return std::bit_cast<Key>(bytes);
}

}  // namespace

HandshakeBudget::HandshakeBudget(std::uint64_t per_second, std::uint64_t burst, std::uint64_t seed)
    : interval_{std::chrono::duration_cast<Clock::duration>(std::chrono::seconds{1}) /
                static_cast<Clock::rep>(per_second)},
      depth_{interval_ * static_cast<Clock::rep>(burst)},
      seed_{seed},
      buckets_(kSets * kPlaces) {}

HandshakeBudget::Clock::duration HandshakeBudget::take(const asio::ip::address& address,
                                                       Clock::time_point now) {
  const Key key = halves(counted_as(address));
  const std::uint64_t hash = mixed(mixed(seed_ ^ key[0]) ^ key[1]);
  const std::lock_guard lock{mutex_};
  const std::span places = std::span{buckets_}.subspan(hash % kSets * kPlaces, kPlaces);
  auto bucket =
      std::find_if(places.begin(), places.end(), [&](const Bucket& each) { return each.address == key; });
  if (bucket == places.end()) {
    bucket = std::min_element(places.begin(), places.end(),
                              [](const Bucket& a, const Bucket& b) { return a.full < b.full; });
    *bucket = {key, now};
  }
  const Clock::time_point full = std::max(bucket->full, now) + interval_;
  if (full > now + depth_) return full - (now + depth_);
  bucket->full = full;
  return Clock::duration::zero();
}

}  // namespace talus::server
