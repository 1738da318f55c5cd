// Servers put their stores aside if most servers reported a different state in the log. Such reports may be
// false, so a rule is needed in case every store is put aside: each server reports on its operators' port how
// far its store has read the stream; the one that has read most goes on with its store, and the others take
// it from there. Whichever state it has, all then have the same. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

/// A store that its server must not use.
struct AsideStore {
  std::uint64_t sequence = 0;   // last applied message of the stream
  std::int64_t created_ns = 0;  // creation time of the stream
  std::uint32_t server = 0;     // the server's number
  bool operator==(const AsideStore&) const = default;
};

/// Header of a server's reply to a request for a checkpoint.
inline constexpr const char* kAsideHeader = "Talus-Aside";
/// "40 1700000000000000000 5f3a9c00"
[[nodiscard]] std::string to_string(const AsideStore& store);
[[nodiscard]] std::optional<AsideStore> parse_aside(std::string_view text);

/// Answers of the peers, each asked once.
struct Round {
  std::size_t peers = 0;
  std::size_t silent = 0;           // do not answer
  std::vector<AsideStore> aside{};  // peers that must not use their stores
};

/// True if the server of `own` goes on: every answering peer has put its store aside, none has read more, and
/// they are more than half of all peers. If `patient`, silent peers are waited for.
[[nodiscard]] bool goes_on(const AsideStore& own, const Round& round, bool patient);

}  // namespace talus::server
