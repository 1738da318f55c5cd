#include "cluster/checkpoint/checkpoint_tar.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <xxhash.h>

#include <talus/store/read_only_store.h>
#include <talus/store/store_builder.h>

namespace talus::server {
namespace {

namespace fs = std::filesystem;
using Status = tl::expected<void, std::string>;

constexpr std::size_t kTarPieceBytes = std::size_t{256} << 10U;
constexpr std::uint64_t kTarBlock = 512;
/// Maximum of eleven octal digits, in the year 2242.
constexpr std::int64_t kLatestTarTime = (std::int64_t{1} << 33U) - 1;

tl::unexpected<std::string> tar_failure(const fs::path& file, int error) {
  return tl::unexpected{fmt::format("{}: {}", file.string(), std::generic_category().message(error))};
}

std::uint64_t tar_bytes_of(std::uint64_t file_bytes) {
  return kTarBlock + (file_bytes + kTarBlock - 1) / kTarBlock * kTarBlock;
}

}  // namespace

std::uint64_t tar_bytes(const store::BackupManifest& manifest) {
  std::uint64_t bytes = 2 * kTarBlock + tar_bytes_of(encode(manifest).size());
  for (const store::BackupManifest::File& file : manifest.files) bytes += tar_bytes_of(file.bytes);
  return bytes;
}

/// Makes libarchive write into a string.
class CheckpointTar::Writer {
 public:
  Writer(std::string& out, std::int64_t time_s)
      : archive_{::archive_write_new(), ::archive_write_free}, time_s_{time_s} {
    if (archive_ == nullptr) throw std::bad_alloc{};
    ::archive_write_set_format_ustar(archive_.get());
    ::archive_write_set_bytes_per_block(archive_.get(), 0);
    const auto append = [](archive*, void* into, const void* bytes, std::size_t size) {
      static_cast<std::string*>(into)->append(static_cast<const char*>(bytes), size);
      return static_cast<la_ssize_t>(size);
    };
    ::archive_write_open(archive_.get(), &out, nullptr, append, nullptr);
  }

  [[nodiscard]] bool begin(const std::string& name, std::uint64_t bytes) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry{::archive_entry_new(),
                                                                         ::archive_entry_free};
    if (entry == nullptr) throw std::bad_alloc{};
    ::archive_entry_set_pathname(entry.get(), name.c_str());
    ::archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes));
    ::archive_entry_set_filetype(entry.get(), AE_IFREG);
    ::archive_entry_set_perm(entry.get(), 0640);
    ::archive_entry_set_mtime(entry.get(), static_cast<time_t>(time_s_), 0);
    return ::archive_write_header(archive_.get(), entry.get()) == ARCHIVE_OK;
  }
  [[nodiscard]] bool add(std::string_view bytes) {
    return ::archive_write_data(archive_.get(), bytes.data(), bytes.size()) ==
           static_cast<la_ssize_t>(bytes.size());
  }
  [[nodiscard]] bool end_file() { return ::archive_write_finish_entry(archive_.get()) == ARCHIVE_OK; }
  [[nodiscard]] bool end() { return ::archive_write_close(archive_.get()) == ARCHIVE_OK; }
  [[nodiscard]] std::string error() const {
    const char* const said = ::archive_error_string(archive_.get());
    return said == nullptr ? "the tar cannot be written" : said;
  }

 private:
  std::unique_ptr<archive, int (*)(archive*)> archive_;
  std::int64_t time_s_;
};

/// A regular file of the checkpoint, hashed while it is read.
class CheckpointTar::InputFile {
 public:
  InputFile(const fs::path& path, store::BackupManifest::File& about)
      : about_{about},
        left_{about.bytes},
        file_{::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)},
        error_{file_ < 0 ? errno : 0},
        hash_{XXH3_createState(), XXH3_freeState} {
    if (hash_ == nullptr) throw std::bad_alloc{};
    XXH3_128bits_reset(hash_.get());
    if (file_ >= 0) ::posix_fadvise(file_, 0, 0, POSIX_FADV_SEQUENTIAL);
  }
  ~InputFile() {
    if (file_ >= 0) ::close(file_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] std::uint64_t left() const { return left_; }
  [[nodiscard]] int error() const { return error_; }
  /// Reads up to the size of `into` or the bytes left. Returns the number read; 0 on failure, see error().
  [[nodiscard]] std::size_t read(std::vector<char>& into) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left_, into.size()));
    ssize_t got = 0;
    do {
      got = ::read(file_, into.data(), wanted);
    } while (got < 0 && errno == EINTR);
    if (got <= 0) {
      error_ = got < 0 ? errno : EIO;  // it has shrunk
      return 0;
    }
    XXH3_128bits_update(hash_.get(), into.data(), static_cast<std::size_t>(got));
    left_ -= static_cast<std::uint64_t>(got);
    return static_cast<std::size_t>(got);
  }
  void end() {
    const XXH128_hash_t hash = XXH3_128bits_digest(hash_.get());
    about_.hash = {hash.low64, hash.high64};
  }

 private:
  store::BackupManifest::File& about_;
  std::uint64_t left_;
  int file_;
  int error_;
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> hash_;
};

CheckpointTar::CheckpointTar(fs::path directory) : directory_{std::move(directory)} {}

CheckpointTar::~CheckpointTar() {
  remove_directory();
}

void CheckpointTar::remove_directory() {
  file_.reset();
  if (directory_.empty()) return;
  std::error_code ignored;  // the next process that opens the data directory retries
  fs::remove_all(directory_, ignored);
  directory_.clear();
}

tl::expected<std::unique_ptr<CheckpointTar>, std::string> CheckpointTar::open(fs::path directory) {
  std::unique_ptr<CheckpointTar> tar{new CheckpointTar{std::move(directory)}};
  {
    const auto store = store::ReadOnlyStore::open(tar->directory_);
    if (!store) return tl::unexpected{store.error()};
    const store::StoreMeta& meta = (*store)->meta();
    if (auto written = store::write_store_files(tar->directory_, meta); !written) {
      return tl::unexpected{written.error()};
    }
    tar->manifest_.identity = {meta.store_id, meta.fingerprint};
    tar->manifest_.head = meta.head;
  }
  if (auto listed = tar->list_files(); !listed) return tl::unexpected{listed.error()};
  tar->size_ = tar_bytes(tar->manifest_);
  tar->writer_ = std::make_unique<Writer>(
      tar->piece_, std::clamp<std::int64_t>(tar->manifest_.head.time_ms / 1000, 0, kLatestTarTime));
  return tar;
}

Status CheckpointTar::list_files() {
  std::vector<std::string> names;
  std::error_code code;
  for (fs::directory_iterator at{directory_ / "db", code}, end; !code && at != end; at.increment(code)) {
    const std::string name = "db/" + at->path().filename().string();
    if (name != "db/LOCK" && store::is_store_file(name)) names.push_back(name);
  }
  if (code) return tl::unexpected{fmt::format("{}: {}", directory_.string(), code.message())};
  std::ranges::sort(names);
  names.insert(names.begin(), {"store.toml", "acknowledged"});
  for (std::string& name : names) {
    struct stat about {};
    const fs::path path = directory_ / name;
    if (::lstat(path.c_str(), &about) != 0) return tar_failure(path, errno);
    if (!S_ISREG(about.st_mode)) {
      return tl::unexpected{
          fmt::format("{}: it is not a regular file; a store has only regular files", path.string())};
    }
    manifest_.files.push_back({std::move(name), static_cast<std::uint64_t>(about.st_size), {}});
  }
  return {};
}

tl::expected<std::string_view, std::string> CheckpointTar::next() {
  piece_.clear();
  while (!ended_ && piece_.size() < kTarPieceBytes) {
    if (file_ != nullptr) {
      if (auto read = read_piece(); !read) return tl::unexpected{read.error()};
    } else if (next_file_ < manifest_.files.size()) {
      if (auto begun = begin_file(); !begun) return tl::unexpected{begun.error()};
    } else {
      const std::string text = encode(manifest_);
      if (!writer_->begin(std::string{store::kManifestName}, text.size()) || !writer_->add(text) ||
          !writer_->end_file() || !writer_->end()) {
        return tl::unexpected{writer_->error()};
      }
      ended_ = true;
    }
  }
  if (piece_.empty()) remove_directory();  // here, where waiting for the disk is allowed
  return std::string_view{piece_};
}

Status CheckpointTar::begin_file() {
  store::BackupManifest::File& about = manifest_.files[next_file_++];
  const fs::path path = directory_ / about.name;
  file_ = std::make_unique<InputFile>(path, about);
  if (file_->error() != 0) return tar_failure(path, file_->error());
  if (!writer_->begin(about.name, about.bytes)) return tl::unexpected{writer_->error()};
  return {};
}

Status CheckpointTar::read_piece() {
  if (file_->left() > 0) {
    std::vector<char> bytes(std::size_t{64} << 10U);
    const std::size_t got = file_->read(bytes);
    if (got == 0) return tar_failure(directory_ / manifest_.files[next_file_ - 1].name, file_->error());
    if (!writer_->add({bytes.data(), got})) return tl::unexpected{writer_->error()};
  }
  if (file_->left() > 0) return {};
  file_->end();
  file_.reset();
  if (!writer_->end_file()) return tl::unexpected{writer_->error()};
  return {};
}

}  // namespace talus::server
