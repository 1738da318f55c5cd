#include <talus/store/backup_manifest.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <xxhash.h>

namespace talus::store {
namespace {

constexpr std::string_view kManifestTitle = "talus backup 1";

ContentHash hash_of_text(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return {hash.low64, hash.high64};
}

/// Removes and returns the next line of `text`; nullopt if no complete line is left.
std::optional<std::string_view> manifest_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

/// Returns the rest of the next line after "NAME ".
std::optional<std::string_view> manifest_field(std::string_view& text, std::string_view name) {
  const auto line = manifest_line(text);
  if (!line || !line->starts_with(name) || line->size() <= name.size() || (*line)[name.size()] != ' ') {
    return std::nullopt;
  }
  return line->substr(name.size() + 1);
}

template <typename Number>
bool manifest_number(std::optional<std::string_view> text, Number& number) {
  if (!text) return false;
  const auto [stop, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  return error == std::errc{} && stop == text->data() + text->size();
}

bool manifest_hash(std::optional<std::string_view> text, ContentHash& hash) {
  const auto read = text ? parse_hash(*text) : std::nullopt;
  if (read) hash = *read;
  return read.has_value();
}

/// Parses "HASH BYTES NAME".
std::optional<BackupManifest::File> read_file_line(std::string_view text) {
  BackupManifest::File file;
  const std::size_t first = text.find(' ');
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t second = text.find(' ', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  file.name = text.substr(second + 1);
  if (!manifest_hash(text.substr(0, first), file.hash) ||
      !manifest_number(text.substr(first + 1, second - first - 1), file.bytes) || !is_store_file(file.name)) {
    return std::nullopt;
  }
  return file;
}

}  // namespace

bool is_store_file(std::string_view name) {
  if (name == "acknowledged" || name == "store.toml") return true;
  constexpr std::string_view kDatabase = "db/";
  if (!name.starts_with(kDatabase)) return false;
  name.remove_prefix(kDatabase.size());
  return !name.empty() && name.front() != '.' && std::ranges::all_of(name, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  });
}

std::uint64_t BackupManifest::bytes() const {
  std::uint64_t all = 0;
  for (const File& file : files) all = file.bytes > UINT64_MAX - all ? UINT64_MAX : all + file.bytes;
  return all;
}

std::string encode(const BackupManifest& manifest) {
  std::string text = fmt::format(
      "{}\nstore_id {}\nfingerprint {}\nposition {}\nrevision {}\ntime_ms {}\nhash {}\n", kManifestTitle,
      to_string(manifest.identity.store_id), to_string(manifest.identity.fingerprint), manifest.head.position,
      manifest.head.revision, manifest.head.time_ms, edits::to_string(manifest.head.hash));
  for (const BackupManifest::File& file : manifest.files) {
    text += fmt::format("file {} {} {}\n", to_string(file.hash), file.bytes, file.name);
  }
  text += fmt::format("end {}\n", to_string(hash_of_text(text)));
  return text;
}

tl::expected<BackupManifest, std::string> decode_manifest(std::string_view text) {
  const auto damaged = [] { return tl::unexpected{std::string{"its manifest is damaged"}}; };
  const std::string_view whole = text;
  const auto title = manifest_line(text);
  if (!title) return damaged();
  if (*title != kManifestTitle) {
    if (!title->starts_with("talus backup ")) return damaged();
    return tl::unexpected{
        fmt::format("it is a \"{}\"; this talusd reads \"{}\"; use a newer talusd", *title, kManifestTitle)};
  }
  BackupManifest manifest;
  ContentHash hash;
  const bool head = manifest_hash(manifest_field(text, "store_id"), manifest.identity.store_id) &&
                    manifest_hash(manifest_field(text, "fingerprint"), manifest.identity.fingerprint) &&
                    manifest_number(manifest_field(text, "position"), manifest.head.position) &&
                    manifest_number(manifest_field(text, "revision"), manifest.head.revision) &&
                    manifest_number(manifest_field(text, "time_ms"), manifest.head.time_ms) &&
                    manifest_hash(manifest_field(text, "hash"), hash);
  if (!head) return damaged();
  manifest.head.hash = {hash.low, hash.high};
  while (text.starts_with("file ")) {
    const auto line = manifest_field(text, "file");
    const auto file = line ? read_file_line(*line) : std::nullopt;
    if (!file) return damaged();
    manifest.files.push_back(*file);
  }
  // Every manifest has exactly one encoding.
  if (encode(manifest) != whole) return damaged();
  std::set<std::string_view> names;
  for (const BackupManifest::File& file : manifest.files) {
    if (!names.insert(file.name).second) return damaged();
  }
  return manifest;
}

}  // namespace talus::store
