#include "store_command/backup.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>
#include <xxhash.h>

#include "store/store_builder.h"
#include "store/store_swap.h"
#include "store/whole_store.h"
#include "store_command/copied_file.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTitle = "talus backup 1";
constexpr std::string_view kManifest = "manifest";
constexpr std::size_t kMaxManifestBytes = std::size_t{16} << 20U;

ContentHash hash_of(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return {hash.low64, hash.high64};
}

/// The next line of `text`, which is taken off; nothing at its end, or where it is cut.
std::optional<std::string_view> next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

/// What follows "NAME " in the next line.
std::optional<std::string_view> next_field(std::string_view& text, std::string_view name) {
  const auto line = next_line(text);
  if (!line || !line->starts_with(name) || line->size() <= name.size() || (*line)[name.size()] != ' ') {
    return std::nullopt;
  }
  return line->substr(name.size() + 1);
}

template <typename Number>
bool read_number(std::optional<std::string_view> text, Number& number) {
  if (!text) return false;
  const auto [stop, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  return error == std::errc{} && stop == text->data() + text->size();
}

bool read_hash(std::optional<std::string_view> text, ContentHash& hash) {
  const auto read = text ? parse_hash(*text) : std::nullopt;
  if (read) hash = *read;
  return read.has_value();
}

/// Files of a store: two, and those of the database.
bool is_sound_name(std::string_view name) {
  if (name == "acknowledged" || name == "store.toml") return true;
  constexpr std::string_view kDatabase = "db/";
  if (!name.starts_with(kDatabase)) return false;
  name.remove_prefix(kDatabase.size());
  return !name.empty() && name.front() != '.' && std::ranges::all_of(name, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  });
}

/// "HASH BYTES NAME".
std::optional<BackupManifest::File> read_file_line(std::string_view text) {
  BackupManifest::File file;
  const std::size_t first = text.find(' ');
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t second = text.find(' ', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  file.name = text.substr(second + 1);
  if (!read_hash(text.substr(0, first), file.hash) ||
      !read_number(text.substr(first + 1, second - first - 1), file.bytes) || !is_sound_name(file.name)) {
    return std::nullopt;
  }
  return file;
}

tl::unexpected<std::string> no_backup(const fs::path& path, std::string_view why) {
  return tl::unexpected{fmt::format("backup {}: {}", path.string(), why)};
}

/// Files of a database that say which others it has.
bool lists_files(std::string_view name) {
  return name == "db/CURRENT" || name.starts_with("db/MANIFEST-");
}

/// Those of the store in `path`, the newest of its log last. No hashes yet.
tl::expected<std::vector<BackupManifest::File>, std::string> database_files(const fs::path& path) {
  std::vector<BackupManifest::File> files;
  std::error_code code;
  for (fs::directory_iterator at{path / "db", code}, end; !code && at != end; at.increment(code)) {
    const std::string name = "db/" + at->path().filename().string();
    // Others come and go.
    if (at->path().filename() == "LOCK" || name.ends_with(".dbtmp") || !is_sound_name(name)) continue;
    files.push_back({name, at->file_size(code), {}});
  }
  if (code) return no_backup(path, code.message());
  std::ranges::sort(files, {}, [](const BackupManifest::File& file) {
    return std::pair{file.name.ends_with(".log"), std::string_view{file.name}};
  });
  return files;
}

}  // namespace

std::uint64_t BackupManifest::bytes() const {
  std::uint64_t all = 0;
  for (const File& file : files) all = file.bytes > UINT64_MAX - all ? UINT64_MAX : all + file.bytes;
  return all;
}

std::string encode(const BackupManifest& manifest) {
  std::string text = fmt::format(
      "{}\nstore_id {}\nfingerprint {}\nposition {}\nrevision {}\ntime_ms {}\nhash {}\n", kTitle,
      to_string(manifest.identity.store_id), to_string(manifest.identity.fingerprint), manifest.head.position,
      manifest.head.revision, manifest.head.time_ms, edits::to_string(manifest.head.hash));
  for (const BackupManifest::File& file : manifest.files) {
    text += fmt::format("file {} {} {}\n", to_string(file.hash), file.bytes, file.name);
  }
  text += fmt::format("end {}\n", to_string(hash_of(text)));
  return text;
}

tl::expected<BackupManifest, std::string> decode_manifest(std::string_view text) {
  const auto damaged = [] { return tl::unexpected{std::string{"its manifest is damaged"}}; };
  const std::string_view whole = text;
  const auto title = next_line(text);
  if (!title) return damaged();
  if (*title != kTitle) {
    if (!title->starts_with("talus backup ")) return damaged();
    return tl::unexpected{
        fmt::format("it is a \"{}\"; this talusd reads \"{}\"; use a newer talusd", *title, kTitle)};
  }
  BackupManifest manifest;
  ContentHash hash;
  const bool head = read_hash(next_field(text, "store_id"), manifest.identity.store_id) &&
                    read_hash(next_field(text, "fingerprint"), manifest.identity.fingerprint) &&
                    read_number(next_field(text, "position"), manifest.head.position) &&
                    read_number(next_field(text, "revision"), manifest.head.revision) &&
                    read_number(next_field(text, "time_ms"), manifest.head.time_ms) &&
                    read_hash(next_field(text, "hash"), hash);
  if (!head) return damaged();
  manifest.head.hash = {hash.low, hash.high};
  while (text.starts_with("file ")) {
    const auto line = next_field(text, "file");
    const auto file = line ? read_file_line(*line) : std::nullopt;
    if (!file) return damaged();
    manifest.files.push_back(*file);
  }
  // There is one way to write each.
  if (encode(manifest) != whole) return damaged();
  std::set<std::string_view> names;
  for (const BackupManifest::File& file : manifest.files) {
    if (!names.insert(file.name).second) return damaged();
  }
  return manifest;
}

tl::expected<BackupManifest, std::string> write_backup(const fs::path& path, const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code) && !fs::is_empty(target, code)) {
    return no_backup(target,
                     code ? code.message() : "the directory is not empty; give one that is, or a new name");
  }
  fs::create_directories(target / "db", code);
  if (code) return no_backup(target, code.message());
  const auto found = database_files(path);
  if (!found) return tl::unexpected{found.error()};
  std::uint64_t bytes = 0;
  for (const BackupManifest::File& file : *found) bytes += file.bytes;
  if (const auto enough = check_space(target, bytes); !enough) return tl::unexpected{enough.error()};
  ProgressBar progress{"backup", "bytes"};
  progress.expect(bytes);
  BackupManifest manifest;
  const auto copy = [&](std::vector<BackupManifest::File> files,
                        bool lists) -> tl::expected<void, std::string> {
    for (BackupManifest::File& file : files) {
      if (lists_files(file.name) != lists) continue;
      const auto copied = copy_file(path / file.name, target / file.name, UINT64_MAX, progress);
      if (!copied) return tl::unexpected{copied.error()};
      file.bytes = copied->bytes;
      file.hash = copied->hash;
      manifest.files.push_back(std::move(file));
    }
    return {};
  };
  // A server may write meanwhile: what says which files there are comes first, so that they are among those
  // that are copied then.
  if (const auto copied = copy(*found, true); !copied) return tl::unexpected{copied.error()};
  const auto rest = database_files(path);
  if (!rest) return tl::unexpected{rest.error()};
  if (const auto copied = copy(*rest, false); !copied) return tl::unexpected{copied.error()};
  {
    const auto store = ReadOnlyStore::open(target);
    if (!store) return tl::unexpected{store.error()};
    const StoreMeta& meta = (*store)->meta();
    manifest.identity = {meta.store_id, meta.fingerprint};
    manifest.head = meta.head;
    if (const auto written = write_store_files(target, meta); !written) {
      return tl::unexpected{written.error()};
    }
  }
  std::ranges::sort(manifest.files, {}, &BackupManifest::File::name);
  for (const char* const name : {"acknowledged", "store.toml"}) {
    const auto read = hash_file(target / name, progress);
    if (!read) return tl::unexpected{read.error()};
    manifest.files.push_back({name, read->bytes, read->hash});
  }
  if (const auto synced = sync_directory(target / "db"); !synced) return tl::unexpected{synced.error()};
  // From here on it is a backup.
  if (const auto written = files::write_file(target / kManifest, std::string_view{encode(manifest)});
      !written) {
    return tl::unexpected{written.error().message()};
  }
  return manifest;
}

tl::expected<BackupManifest, std::string> read_manifest(const fs::path& backup) {
  std::error_code code;
  if (!fs::is_directory(backup, code)) return no_backup(backup, "there is no such directory");
  if (fs::is_symlink(backup / "db", code)) return no_backup(backup, "db is a link; give another one");
  if (!fs::exists(backup / kManifest, code)) {
    return no_backup(backup, "it has no manifest: it is no backup, or was not finished; give another one");
  }
  const auto text = files::read_regular_file(backup / kManifest, kMaxManifestBytes);
  if (!text) return tl::unexpected{text.error().message()};
  auto manifest = decode_manifest(*text);
  if (!manifest) return no_backup(backup, fmt::format("{}; give another one", manifest.error()));
  return manifest;
}

tl::expected<Restored, std::string> restore_backup(const fs::path& backup, const DataDirectory& directory,
                                                   bool replace) {
  auto manifest = read_manifest(backup);
  if (!manifest) return tl::unexpected{manifest.error()};
  if (directory.has_store() && !replace) {
    return tl::unexpected{
        fmt::format("data {}: it holds a store; give --replace to move that aside, or another --data",
                    directory.path().string())};
  }
  if (const auto enough = check_space(directory.path(), manifest->bytes()); !enough) {
    return tl::unexpected{enough.error()};
  }
  const auto staging = make_staging(directory.path());
  if (!staging) return tl::unexpected{staging.error()};
  std::error_code code;
  fs::create_directory(*staging / "db", code);
  if (code) return tl::unexpected{fmt::format("{}: {}", staging->string(), code.message())};
  ProgressBar progress{"restore", "bytes"};
  progress.expect(manifest->bytes());
  for (const BackupManifest::File& file : manifest->files) {
    const auto copied = copy_file(backup / file.name, *staging / file.name, file.bytes, progress);
    if (!copied) return tl::unexpected{copied.error()};
    if (!copied->all || copied->bytes != file.bytes || copied->hash != file.hash) {
      return no_backup(
          backup,
          fmt::format("{} is damaged: it is not what its manifest says; give another one", file.name));
    }
  }
  {
    const auto store = ReadOnlyStore::open(*staging);
    if (!store) return tl::unexpected{store.error()};
    if ((*store)->meta().head != manifest->head) {
      return no_backup(backup,
                       "its database is not at the position that its manifest says; give another one");
    }
  }
  const ContentHash id = random_store_id();
  if (const auto given = give_identity(*staging, id); !given) return tl::unexpected{given.error()};
  if (const auto synced = sync_directory(*staging / "db"); !synced) return tl::unexpected{synced.error()};
  auto replaced = swap_in(directory.path());
  if (!replaced) return tl::unexpected{replaced.error()};
  return Restored{*std::move(manifest), id, *std::move(replaced)};
}

}  // namespace talus::server
