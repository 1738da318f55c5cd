#include "store/read_file.h"

#include <array>
#include <cerrno>
#include <fstream>

namespace talus::server {

tl::expected<std::string, int> read_file(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream in{file, std::ios::binary};
  if (!in.is_open()) return tl::make_unexpected(errno);
  std::string text;
  std::array<char, 4096> block{};
  // read() leaves a failure in the stream's state, where an iterator over its buffer would throw.
  do {
    in.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most_bytes) return tl::make_unexpected(EFBIG);
  } while (in);
  if (in.bad()) return tl::make_unexpected(errno);
  return text;
}

}  // namespace talus::server
