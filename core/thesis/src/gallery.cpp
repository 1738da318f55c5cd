#include "gallery.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "gallery_figures.h"
#include "palette.h"
#include "world_variant.h"

namespace talus::tools {

Expected<void> write_gallery(const WorldText& text, const std::string& only,
                             const std::filesystem::path& directory, int threads, ProgressBar& progress) {
  const auto world = world_variant(text, {});
  if (!world) return tl::make_unexpected(world.error());
  const auto meant = [&](const Figure& figure) {
    return std::string_view{figure.file}.find(only) != std::string_view::npos &&
           (!figure.of_caves || world->has_caves());
  };
  if (std::none_of(gallery_figures().begin(), gallery_figures().end(), meant)) {
    return wrong_use("--only " + only +
                     ": no figure of this world has that in its name; they are gallery-NN-*.png, " +
                     "gallery-levels.png, and gallery-caves.png of worlds with caves");
  }
  std::error_code made;
  std::filesystem::create_directories(directory, made);
  if (made) return failed(directory.string() + ": cannot make the directory: " + made.message());
  std::vector<Figure> figures;
  std::vector<PngFile> files;
  std::uint64_t pixel_rows = 0;
  for (const Figure& figure : gallery_figures()) {
    if (!meant(figure)) continue;
    figures.push_back(figure);
    auto file = PngFile::create(directory / figure.file);
    if (!file) return tl::make_unexpected(file.error());
    files.push_back(std::move(*file));
    pixel_rows += static_cast<std::uint64_t>(figure.pixel_rows);
  }
  progress.expect(pixel_rows);
  const GalleryContext context{text, *world, threads, progress};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto image = figures[i].draw(context);
    if (!image) return tl::make_unexpected(image.error());
    if (auto written = write(files[i], to_palette(*image)); !written) return written;
  }
  return {};
}

}  // namespace talus::tools
