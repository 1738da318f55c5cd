// Who is not served: addresses, and subjects of signed tokens. A list that the operator keeps
// (config/access/list_file.h):
//
//     203.0.113.9          an address
//     2001:db8:1:2::/64    a network
//     subject NAME         whose tokens have this subject
//
// NAME is the subject itself, or what the log and "talusd top" show: with \xNN for what is not printable
// ASCII. A name that ends in "..." was cut where it was shown, and is an error; of a subject that ends so the
// last dot is written \x2e.
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
  /// An error is one line that begins with the number of the line that is wrong.
  [[nodiscard]] static tl::expected<BlockedFlows, std::string> parse(std::string_view text);
  /// An error is one line that begins with the file.
  [[nodiscard]] static tl::expected<BlockedFlows, std::string> read(const std::filesystem::path& file);

  class Line {
   public:
    explicit Line(std::size_t number) : number_{number} {}
    [[nodiscard]] std::size_t number() const { return number_; }
    /// Whether this is the first call: somebody came whom the line blocks. Any thread.
    [[nodiscard]] bool meet() const { return !met_.exchange(true); }

   private:
    std::size_t number_;
    mutable std::atomic<bool> met_{false};
  };

  /// Null where no line blocks it. Of several lines the one with the longest prefix. An IPv4 address and the
  /// same address mapped into IPv6 are equal.
  [[nodiscard]] const Line* find(const asio::ip::address& address) const;
  [[nodiscard]] const Line* find_subject(const std::string& subject) const;
  /// Different entries.
  [[nodiscard]] std::size_t size() const;

 private:
  /// Why the line is wrong; empty where it is right.
  [[nodiscard]] std::string add(std::string_view line, std::size_t number);

  // By length of the prefix, the longest first; IPv4 mapped into IPv6.
  std::map<unsigned short, std::map<asio::ip::address_v6, Line>, std::greater<>> networks_;
  std::unordered_map<std::string, Line> subjects_;
};

}  // namespace talus::server
