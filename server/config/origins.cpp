#include "config/origins.h"

#include <utility>

#include <fmt/format.h>

namespace talus::server {

void Origins::set(std::string_view key, std::string origin) {
  origins_.insert_or_assign(std::string{key}, std::move(origin));
}

void Origins::forget(std::string_view key) {
  if (const auto found = origins_.find(key); found != origins_.end()) origins_.erase(found);
}

std::string Origins::locate(std::string_view line) const {
  const auto found = origins_.find(line.substr(0, line.find_first_of(": ")));
  return found == origins_.end() ? std::string{line} : fmt::format("{}: {}", found->second, line);
}

}  // namespace talus::server
