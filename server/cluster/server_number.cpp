#include "cluster/server_number.h"

#include <charconv>
#include <random>
#include <string>

#include <fmt/format.h>

#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>

namespace talus::server::cluster {

std::uint32_t server_number(const std::filesystem::path& directory) {
  constexpr std::size_t kMaxNumberBytes = 16;
  const std::filesystem::path file = directory / "server_number";
  if (const auto text = files::read_regular_file(file, kMaxNumberBytes)) {
    std::uint32_t number = 0;
    const char* const end = text->data() + text->size();
    const auto [stop, error] = std::from_chars(text->data(), end, number, 16);
    if (error == std::errc{} && std::string{stop, end} == "\n") return number;
  }
  const std::uint32_t drawn = std::random_device{}();
  // If it cannot be written, this start counts as another server.
  (void)files::write_file(file, fmt::format("{:08x}\n", drawn));
  return drawn;
}

}  // namespace talus::server::cluster
