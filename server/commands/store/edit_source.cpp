#include "commands/store/edit_source.h"

#include <utility>

#include <talus/edits/runs.h>
#include <talus/files/file_layer.h>
#include <talus/saves/save.h>

namespace talus::server {
namespace {

namespace fs = std::filesystem;

/// Reads a file sequentially in large pieces.
class InputFile {
 public:
  explicit InputFile(const fs::path& path)
      : file_{files::system_files().open_to_read(path, files::FileLayer::WaitPolicy::never)} {}
  ~InputFile() {
    if (file_) files::system_files().close(*file_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  tl::expected<std::size_t, std::string> read(std::span<std::byte> into) {
    if (!file_) return tl::unexpected{"cannot be read: " + file_.error().message()};
    std::size_t done = 0;
    while (done < into.size()) {
      const auto got = files::system_files().read(*file_, into.subspan(done));
      if (!got) return tl::unexpected{"cannot be read: " + got.error().message()};
      if (*got == 0) break;
      done += *got;
    }
    bytes_ += done;
    return done;
  }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  files::FileLayer::Result<int> file_;
  std::uint64_t bytes_ = 0;
};

class PortableSource final : public EditSource {
 public:
  explicit PortableSource(const fs::path& file) : input_{file} {}
  tl::expected<void, std::string> open() {
    auto reader = PortableReader::open([this](std::span<std::byte> into) { return input_.read(into); });
    if (!reader) return tl::unexpected{std::move(reader.error())};
    reader_.emplace(*std::move(reader));
    return {};
  }
  [[nodiscard]] const PortableHeader& header() const override { return reader_->header(); }
  [[nodiscard]] tl::expected<std::optional<PortableChunk>, std::string> next() override {
    return reader_->next();
  }
  [[nodiscard]] std::uint64_t bytes_read() const override { return input_.bytes(); }

 private:
  InputFile input_;
  std::optional<PortableReader> reader_;
};

/// A save has no dates and no store's id.
class SaveSource final : public EditSource {
 public:
  SaveSource(saves::SaveFile file, std::shared_ptr<const terrain::World> world, std::int64_t now_ms)
      : file_{std::move(file)}, world_{std::move(world)} {
    header_.fingerprint = world_->fingerprint();
    header_.head.revision = file_.state().revision;
    header_.head.time_ms = now_ms;
    header_.head.hash = file_.state().hash;
    header_.materials = file_.world().materials;
  }
  [[nodiscard]] const PortableHeader& header() const override { return header_; }
  [[nodiscard]] const terrain::World* world() const override { return world_.get(); }
  [[nodiscard]] std::uint64_t bytes_read() const override { return bytes_read_; }
  [[nodiscard]] tl::expected<std::optional<PortableChunk>, std::string> next() override {
    const auto chunk = file_.next_chunk();
    if (!chunk) return tl::unexpected{chunk.error().message};
    if (!*chunk) {
      if (hash_ == header_.head.hash) return std::nullopt;
      return tl::unexpected<std::string>{"is damaged: the hash of its edits is wrong; restore a backup"};
    }
    auto voxels = edits::decode_runs((*chunk)->runs);
    if (!voxels || voxels->empty()) {
      return tl::unexpected{"is damaged: the edits of chunk " + to_string((*chunk)->chunk) +
                            " cannot be read; restore a backup"};
    }
    bytes_read_ += (*chunk)->runs.size();
    hash_.add((*chunk)->chunk, *voxels);
    return PortableChunk{(*chunk)->chunk, *std::move(voxels)};
  }

 private:
  saves::SaveFile file_;
  std::shared_ptr<const terrain::World> world_;
  PortableHeader header_;
  edits::StateHash hash_;
  std::uint64_t bytes_read_ = 0;
};

/// The message of a save's error begins with the file.
std::string without_file(const saves::SaveError& error, const fs::path& file) {
  return error.message.substr(std::min(error.message.size(), file.string().size() + 2));
}

}  // namespace

tl::expected<std::unique_ptr<EditSource>, std::string> open_edits(const fs::path& file, std::int64_t now_ms) {
  if (!saves::is_database(file)) {
    auto source = std::make_unique<PortableSource>(file);
    if (auto opened = source->open(); !opened) return tl::unexpected{std::move(opened.error())};
    return source;
  }
  auto save = saves::SaveFile::open(file, saves::Access::read);
  if (!save) return tl::unexpected{without_file(save.error(), file)};
  auto world = saves::world_of(*save);
  if (!world) return tl::unexpected{without_file(world.error(), file)};
  return std::make_unique<SaveSource>(*std::move(save), *std::move(world), now_ms);
}

}  // namespace talus::server
