#include "world_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace talus::tools {

Expected<terrain::World> load_world(const std::string& path) {
  if (path.empty()) return terrain::default_world();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return failed(path + ": is a directory; --world takes a world.toml file");
  }
  errno = 0;
  std::ifstream file{path, std::ios::binary};
  if (!file) return failed(path + ": cannot read the world file: " + std::strerror(errno));
  const std::string text{std::istreambuf_iterator<char>{file}, {}};
  if (file.bad()) return failed(path + ": cannot read the world file: " + std::strerror(errno));
  auto world = terrain::World::parse(text, path);
  if (!world) return failed(std::move(world.error().message));
  return std::move(*world);
}

}  // namespace talus::tools
