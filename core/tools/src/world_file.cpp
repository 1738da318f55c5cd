#include <talus/tools/world_file.h>

#include <string>
#include <system_error>
#include <utility>

#include <talus/files/path_text.h>
#include <talus/files/read_file.h>
#include <talus/toml/toml_bounds.h>
#include <talus/world_files/world_files.h>

namespace talus::tools {

Expected<WorldText> read_world_text(const std::string& path) {
  if (path.empty()) return WorldText{std::string{terrain::classic_world_toml()}, "the classic world"};
  auto text = files::read_regular_file(files::to_path(path), kMaxTomlBytes);
  if (text) return WorldText{*std::move(text), path};
  const files::FileError& error = text.error();
  if (!error.code) return failed(error.message() + "; --world takes a world.toml file");
  if (error.code == std::errc::file_too_large) return failed(error.message());
  return failed(path + ": cannot read the world file: " + error.code.message());
}

Expected<terrain::World> load_world(const std::string& path) {
  if (path.empty()) return terrain::default_world();
  const auto text = read_world_text(path);
  if (!text) return tl::make_unexpected(text.error());
  auto world = terrain::World::parse(text->toml, text->source, world_files::beside(files::to_path(path)));
  if (!world) return failed(std::move(world.error().message));
  return std::move(*world);
}

}  // namespace talus::tools
