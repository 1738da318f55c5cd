// How many connections there are, in all and from each address. Callable from any thread.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include <asio/ip/address.hpp>
#include <tl/expected.hpp>

namespace talus::server {

/// Whom an address counts as: an IPv4 address (also one mapped into IPv6) stands for itself, an IPv6
/// address for its /64 network, which is what one customer commonly has.
[[nodiscard]] asio::ip::address counted_as(const asio::ip::address& address);

class Admission {
 public:
  Admission(std::size_t most, std::size_t most_per_address);

  /// A connection's place; leaving it is giving it back. Must not outlive its Admission.
  class Place {
   public:
    Place(Admission& admission, const asio::ip::address& counted)
        : admission_{&admission}, counted_{counted} {}
    Place(Place&& other) noexcept;
    Place& operator=(Place&&) = delete;
    ~Place();

   private:
    Admission* admission_;
    asio::ip::address counted_;
  };

  /// A place, or a line that says which limit is reached.
  [[nodiscard]] tl::expected<Place, std::string> enter(const asio::ip::address& address);

  [[nodiscard]] std::size_t connections() const;

 private:
  void leave(const asio::ip::address& counted);

  const std::size_t most_;
  const std::size_t most_per_address_;
  mutable std::mutex mutex_;
  std::size_t connections_ = 0;
  std::map<asio::ip::address, std::size_t> by_address_;
};

}  // namespace talus::server
