// Servers whose stores must not be used, as most voices of the log have another state, and what becomes of
// them where no server is left with another: voices of the log may be false. Each says at its operators' port
// how far its store has read the stream. Where all peers have put theirs aside, the one that has read most
// goes on with it, and the others take it from there: whichever state it has, all have the same. Pure.
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
  std::uint64_t sequence = 0;   // of the last message of the stream that is applied
  std::int64_t created_ns = 0;  // when the stream was made
  std::uint32_t server = 0;     // its number
  bool operator==(const AsideStore&) const = default;
};

/// The header in which a server says it, where it is asked for a checkpoint.
inline constexpr const char* kAsideHeader = "Talus-Aside";
/// "40 1700000000000000000 5f3a9c00"
[[nodiscard]] std::string to_string(const AsideStore& store);
[[nodiscard]] std::optional<AsideStore> parse_aside(std::string_view text);

/// What peers answered, each asked once.
struct Round {
  std::size_t peers = 0;
  std::size_t silent = 0;           // do not answer at all
  std::vector<AsideStore> aside{};  // said that theirs must not be used
};

/// Whether the server of `own` is the one that goes on: of those that answer each has put its store aside,
/// none has read more, and they are most of all peers. `patient`: silent ones may come yet, and are waited
/// for.
[[nodiscard]] bool goes_on(const AsideStore& own, const Round& round, bool patient);

}  // namespace talus::server
