#include "token.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>

#include <CLI/CLI.hpp>

namespace talus::cli {
namespace {

constexpr std::size_t kMostBytes = 4096;  // what the protocol takes

}  // namespace

void add_token_options(CLI::App& app, TokenWords& words) {
  // A flag takes the place of both variables, so they are looked at where no flag was.
  auto* file = app.add_option("--token-file", words.file,
                              "File with what the server's operator gave out, or $TALUS_TOKEN_FILE");
  auto* token = app.add_option(
      "--token", words.token,
      "The same as a word, which all users of this machine can see, or $TALUS_TOKEN, which they cannot");
  file->excludes(token);
  app.callback([&words, file, token] {
    if (file->count() != 0 || token->count() != 0) return;
    if (const char* text = std::getenv("TALUS_TOKEN")) words.token = text;
    if (const char* name = std::getenv("TALUS_TOKEN_FILE"); name != nullptr && words.token.empty())
      words.file = name;
  });
}

tl::expected<std::string, std::string> token_of(const TokenWords& words) {
  if (words.file.empty()) return words.token;
  const auto wrong = [&](std::string_view what) {
    return tl::unexpected{"--token-file " + words.file + ": " + std::string{what}};
  };
  std::ifstream in{words.file, std::ios::binary};
  std::array<char, kMostBytes + 3> bytes{};
  in.read(bytes.data(), bytes.size());
  if (!in.is_open() || in.bad()) return wrong(std::string{"cannot be read: "} + std::strerror(errno));
  std::string_view text{bytes.data(), static_cast<std::size_t>(in.gcount())};
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  if (text.empty() || text.size() > kMostBytes) {
    return wrong("holds no token; give a file with 1 to " + std::to_string(kMostBytes) + " bytes");
  }
  return std::string{text};
}

}  // namespace talus::cli
