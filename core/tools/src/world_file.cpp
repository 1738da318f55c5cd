#include "world_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

#include <talus/height_files/height_files.h>
#include <talus/toml/toml_bounds.h>

#include "regular_file.h"

namespace talus::tools {

Expected<WorldText> read_world_text(const std::string& path) {
  if (path.empty()) return WorldText{std::string{terrain::default_world_toml()}, "the built-in world"};
  if (const auto file = check_regular_file(path); !file) {
    return failed(file.error().message + "; --world takes a world.toml file");
  }
  errno = 0;
  std::ifstream file{path, std::ios::binary};
  if (!file) return failed(path + ": cannot read the world file: " + std::strerror(errno));
  // One byte past the bound is enough for the parser to refuse it.
  std::string text(kMaxTomlBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad()) return failed(path + ": cannot read the world file: " + std::strerror(errno));
  return WorldText{std::move(text), path};
}

Expected<terrain::World> load_world(const std::string& path) {
  if (path.empty()) return terrain::default_world();
  const auto text = read_world_text(path);
  if (!text) return tl::make_unexpected(text.error());
  auto world = terrain::World::parse(text->toml, text->source, height_files::beside(path));
  if (!world) return failed(std::move(world.error().message));
  return std::move(*world);
}

}  // namespace talus::tools
