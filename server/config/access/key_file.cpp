#include "config/access/key_file.h"

#include <openssl/crypto.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include <talus/files/secret_file.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

constexpr std::size_t kMaxFileBytes = 8192;  // for every key file

std::string_view without_newline(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

/// Names bytes that text editors add and clients do not send; nullptr without such bytes.
const char* added_by_editor(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) return "begins with a byte order mark; save it as UTF-8 without one";
  const bool is_pem = bytes.starts_with("-----BEGIN");  // readers of PEM ignore lines that follow the key
  if (!is_pem && (bytes.ends_with('\n') || bytes.ends_with('\r'))) {
    return "has empty lines at its end; end it after the secret";
  }
  return nullptr;
}

/// Detects files that were zero-filled or never written. Does not judge short passwords.
bool holds_no_secret(std::string_view bytes) {
  constexpr std::size_t kShort = 16;
  const bool blank = bytes.find_first_not_of(std::string_view{"\0 \t\r\n", 5}) == std::string_view::npos;
  return blank || (bytes.size() >= kShort && bytes.find_first_not_of(bytes[0]) == std::string_view::npos);
}

std::optional<std::string> permission_warning(const std::filesystem::path& file, mode_t mode) {
  if ((mode & (S_IROTH | S_IWOTH | S_IWGRP)) == 0) return std::nullopt;
  return fmt::format("{}: other users may read or change it (mode {:03o}); run chmod 600 or chmod 640 on it",
                     escaped(file.string(), 500), mode & 0777U);
}

}  // namespace

std::optional<std::string> open_to_others(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? permission_warning(file, status.st_mode) : std::nullopt;
}

Secret::~Secret() {
  OPENSSL_cleanse(bytes_.data(), bytes_.size());
}

tl::expected<KeyFile, std::string> read_key_file(const std::filesystem::path& file, KeyBounds bounds) {
  const auto wrong = [&](const std::string& what) {
    return tl::make_unexpected(fmt::format("{}: {}", escaped(file.string(), 500), what));
  };
  const auto read = files::SecretFile::read(file, kMaxFileBytes);
  if (!read)
    return wrong(read.error().reason +
                 "; name a file that holds the secret and that the user of talusd may read");
  const std::string_view bytes = bounds.is_binary ? read->text() : without_newline(read->text());
  if (bytes.size() < bounds.min_bytes || bytes.size() > bounds.max_bytes) {
    const std::string lengths = bounds.min_bytes == bounds.max_bytes
                                    ? fmt::to_string(bounds.min_bytes)
                                    : fmt::format("{} to {}", bounds.min_bytes, bounds.max_bytes);
    return wrong(fmt::format("has {} bytes; it must have {}, as {}", bytes.size(), lengths, bounds.as));
  }
  if (holds_no_secret(bytes)) {
    return wrong(fmt::format(
        "has no secret: it is blank, or one character again and again; give it one, as {}", bounds.as));
  }
  if (const char* added = bounds.is_binary ? nullptr : added_by_editor(bytes)) return wrong(added);
  return KeyFile{Secret{bytes}, permission_warning(file, read->mode())};
}

}  // namespace talus::server
