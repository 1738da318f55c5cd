// The operator's list of blocked addresses and token subjects (config/access/list_file.h):
//
//     203.0.113.9          an address
//     2001:db8:1:2::/64    a network
//     subject NAME         tokens with this subject
//
// NAME is the subject itself, or the form shown by the log and "talusd top", with \xNN for bytes that are not
// printable ASCII. A name that ends in "..." was truncated and is an error; if the subject really ends so,
// write its last dot as \x2e.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <asio/ip/address.hpp>
#include <tl/expected.hpp>

namespace talus::server {

class BlockedFlows {
 public:
  /// An error is one line that begins with the number of the wrong line.
  [[nodiscard]] static tl::expected<BlockedFlows, std::string> parse(std::string_view text);
  /// An error is one line that begins with the file.
  [[nodiscard]] static tl::expected<BlockedFlows, std::string> read(const std::filesystem::path& file);

  class Line {
   public:
    explicit Line(std::size_t number) : number_{number} {}
    [[nodiscard]] std::size_t number() const { return number_; }
    /// True on the first call: the line blocked its first client. Callable from any thread.
    [[nodiscard]] bool meet() const { return !met_.exchange(true); }

   private:
    std::size_t number_;
    mutable std::atomic<bool> met_{false};
  };

  /// Returns the matching line with the longest prefix; null if none blocks the address. An IPv4 address
  /// equals the same address mapped into IPv6.
  [[nodiscard]] const Line* find(const asio::ip::address& address) const;
  [[nodiscard]] const Line* find_subject(const std::string& subject) const;
  /// Number of distinct entries.
  [[nodiscard]] std::size_t size() const;

 private:
  /// Returns why the line is wrong; empty if it is right.
  [[nodiscard]] std::string add(std::string_view line, std::size_t number);

  // By prefix length, longest first; IPv4 is mapped into IPv6.
  std::map<unsigned short, std::map<asio::ip::address_v6, Line>, std::greater<>> networks_;
  std::unordered_map<std::string, Line> subjects_;
};

}  // namespace talus::server
