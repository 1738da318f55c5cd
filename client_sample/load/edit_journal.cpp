#include "edit_journal.h"

#include <cerrno>
#include <cinttypes>
#include <cstring>

namespace talus::load {

tl::expected<std::shared_ptr<EditJournal>, std::string> EditJournal::open(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "ae");
  if (file == nullptr) return tl::unexpected{path + ": cannot be written: " + std::strerror(errno)};
  return std::shared_ptr<EditJournal>{new EditJournal{path, file}};
}

void EditJournal::add(std::uint64_t revision, VoxelPos at, MaterialId material) {
  // One call writes one line, from any thread; flush() reports errors.
  (void)std::fprintf(file_.get(), "%" PRIu64 " %" PRId64 " %" PRId64 " %" PRId64 " %u\n", revision, at.x,
                     at.y, at.z, static_cast<unsigned>(to_integer(material)));
}

tl::expected<void, std::string> EditJournal::flush() {
  if (std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0) return {};
  return tl::unexpected{path_ + ": cannot be written: " + std::strerror(errno)};
}

}  // namespace talus::load
