#include "access/key_file.h"

#include <openssl/crypto.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include <talus/files/secret_file.h>

#include "log/escape.h"

namespace talus::server {
namespace {

constexpr std::size_t kMostBytes = 8192;  // of any file that is taken for a key

std::string_view without_line_end(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::optional<std::string> too_open(const std::filesystem::path& file, mode_t mode) {
  if ((mode & (S_IROTH | S_IWOTH | S_IWGRP)) == 0) return std::nullopt;
  return fmt::format("{}: may be read or changed by others (mode {:03o}); chmod 600 it, or 640",
                     escaped(file.string(), 500), mode & 0777U);
}

}  // namespace

std::optional<std::string> open_to_others(const std::filesystem::path& file) {
  struct stat about {};
  return ::stat(file.c_str(), &about) == 0 ? too_open(file, about.st_mode) : std::nullopt;
}

Secret::~Secret() {
  OPENSSL_cleanse(bytes_.data(), bytes_.size());
}

tl::expected<KeyFile, std::string> read_key_file(const std::filesystem::path& file, KeyBounds bounds) {
  const auto wrong = [&](const std::string& what) {
    return tl::make_unexpected(fmt::format("{}: {}", escaped(file.string(), 500), what));
  };
  const auto read = files::SecretFile::read(file, kMostBytes);
  if (!read)
    return wrong(read.error().reason + "; give a file with the secret in it that talusd's user may read");
  const std::string_view bytes = without_line_end(read->text());
  if (bytes.size() < bounds.least_bytes || bytes.size() > bounds.most_bytes) {
    return wrong(fmt::format("has {} bytes; {} to {} are right, as of \"openssl rand -base64 32\"",
                             bytes.size(), bounds.least_bytes, bounds.most_bytes));
  }
  return KeyFile{Secret{bytes}, too_open(file, read->mode())};
}

}  // namespace talus::server
