#include "net/connection_rate_limiter.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <span>

#include "net/admission.h"

namespace talus::server {
namespace {

/// The finalizer of MurmurHash3, applied to both halves.
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

ConnectionRateLimiter::ConnectionRateLimiter(std::uint64_t per_second, std::uint64_t burst,
                                             std::uint64_t seed)
    : seed_{seed}, entries_(kSets * kEntriesPerSet) {
  change(per_second, burst);
}

void ConnectionRateLimiter::change(std::uint64_t per_second, std::uint64_t burst) {
  const std::lock_guard lock{mutex_};
  interval_ = std::chrono::duration_cast<Clock::duration>(std::chrono::seconds{1}) /
              static_cast<Clock::duration::rep>(per_second);
  burst_ = interval_ * static_cast<Clock::duration::rep>(burst);
}

Clock::duration ConnectionRateLimiter::admit(const asio::ip::address& address, Clock::time_point now) {
  const Key key = halves(counted_as(address));
  const std::uint64_t hash = mixed(mixed(seed_ ^ key[0]) ^ key[1]);
  const std::lock_guard lock{mutex_};
  const std::span set = std::span{entries_}.subspan(hash % kSets * kEntriesPerSet, kEntriesPerSet);
  auto entry = std::find_if(set.begin(), set.end(), [&](const Entry& each) { return each.address == key; });
  if (entry == set.end()) {
    entry = std::min_element(set.begin(), set.end(), [](const Entry& a, const Entry& b) {
      return a.theoretical_arrival < b.theoretical_arrival;
    });
    *entry = {key, now};
  }
  const auto arrival = std::max(entry->theoretical_arrival, now) + interval_;
  if (arrival > now + burst_) return arrival - (now + burst_);
  entry->theoretical_arrival = arrival;
  return Clock::duration::zero();
}

}  // namespace talus::server
