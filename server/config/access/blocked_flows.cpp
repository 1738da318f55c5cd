#include "config/access/blocked_flows.h"

#include <functional>
#include <utility>

#include <asio/ip/network_v6.hpp>

#include "config/access/list_file.h"
#include "config/networks.h"
#include "runtime/log/escape.h"

namespace talus::server {

tl::expected<BlockedFlows, std::string> BlockedFlows::parse(std::string_view text) {
  BlockedFlows blocked;
  const auto add = [&](std::string_view line, std::size_t number) { return blocked.add(line, number); };
  return parse_list(text, add).map([&] { return std::move(blocked); });
}

tl::expected<BlockedFlows, std::string> BlockedFlows::read(const std::filesystem::path& file) {
  BlockedFlows blocked;
  const auto add = [&](std::string_view line, std::size_t number) { return blocked.add(line, number); };
  return read_list(file, add).map([&] { return std::move(blocked); });
}

std::string BlockedFlows::add(std::string_view line, std::size_t number) {
  std::string_view rest = line;
  if (take_word(rest) == "subject") {
    if (rest.empty()) return "no NAME after subject";
    // A truncated display name would block no client.
    if (rest.ends_with("...")) {
      return "the name was cut at \"...\"; take the whole subject from /flows.json, or write the last dot as "
             "\\x2e";
    }
    std::string subject{rest};
    if (rest.ends_with("..\\x2e")) subject.replace(subject.rfind('\\'), std::string::npos, ".");
    subjects_.try_emplace(std::move(subject), number);
    return {};
  }
  const auto network = parse_network(line);
  if (!network) {
    return network.error() + "; write 203.0.113.9, 203.0.113.0/24, 2001:db8:1:2::/64 or subject NAME";
  }
  networks_[network->prefix_length()].try_emplace(network->address(), number);
  return {};
}

const BlockedFlows::Line* BlockedFlows::find(const asio::ip::address& address) const {
  if (networks_.empty()) return nullptr;
  const asio::ip::address_v6 host = mapped(address);
  for (const auto& [length, networks] : networks_) {
    const auto found = networks.find(asio::ip::network_v6{host, length}.canonical().address());
    if (found != networks.end()) return &found->second;
  }
  return nullptr;
}

const BlockedFlows::Line* BlockedFlows::find_subject(const std::string& subject) const {
  if (subjects_.empty()) return nullptr;
  auto found = subjects_.find(subject);
  if (found == subjects_.end()) found = subjects_.find(escaped(subject, subject.size()));
  return found == subjects_.end() ? nullptr : &found->second;
}

std::size_t BlockedFlows::size() const {
  std::size_t size = subjects_.size();
  for (const auto& [length, networks] : networks_) size += networks.size();
  return size;
}

}  // namespace talus::server
