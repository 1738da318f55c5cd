#include <talus/store/store_identity.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <random>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <talus/files/secret_file.h>
#include <talus/toml/toml_bounds.h>
#include <toml++/toml.h>

namespace talus::store {

ContentHash random_store_id() {
  std::random_device device;
  const auto half = [&device] { return (std::uint64_t{device()} << 32U) | device(); };
  return {half(), half()};
}

std::optional<ContentHash> parse_hash(std::string_view text) {
  constexpr std::size_t kHalfDigits = 16;
  if (text.size() != 2 * kHalfDigits) return std::nullopt;
  ContentHash hash;
  for (const auto& [half, at] : {std::pair{&hash.high, std::size_t{0}}, std::pair{&hash.low, kHalfDigits}}) {
    const char* const begin = text.data() + at;
    const auto [stop, error] = std::from_chars(begin, begin + kHalfDigits, *half, 16);
    if (error != std::errc{} || stop != begin + kHalfDigits) return std::nullopt;
  }
  return hash;
}

std::string store_text(const StoreIdentity& identity) {
  return fmt::format(
      "# Written by talusd. Do not edit or delete files here: they belong to this store id and this world.\n"
      "store_id = \"{}\"\n"
      "fingerprint = \"{}\"\n",
      to_string(identity.store_id), to_string(identity.fingerprint));
}

tl::expected<StoreIdentity, std::string> read_store_identity(const std::filesystem::path& file) {
  const auto read = files::SecretFile::read(file, kMaxTomlBytes);
  if (!read) {
    return tl::make_unexpected(fmt::format("{}: {}; give --data a directory that talusd alone uses",
                                           file.string(), read.error().reason));
  }
  std::optional<ContentHash> id;
  std::optional<ContentHash> world;
  try {
    const bool sound = !find_toml_fault(read->text());
    const toml::table table = sound ? toml::parse(read->text()) : toml::table{};
    const auto hash = [&](std::string_view key) {
      return parse_hash(table[key].value<std::string>().value_or(""));
    };
    id = hash("store_id");
    world = hash("fingerprint");
  } catch (const toml::parse_error&) {
    // Reported below as missing keys: only a file written by talusd is valid.
  }
  if (id && world) return StoreIdentity{*id, *world};
  return tl::make_unexpected(fmt::format(
      "{}: was not written by talusd; it needs store_id and fingerprint, each of 32 hexadecimal digits",
      file.string()));
}

}  // namespace talus::store
