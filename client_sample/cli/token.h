// What a client shows a server that does not let everyone in.
#pragma once

#include <string>

#include <tl/expected.hpp>

namespace CLI {
class App;
}

namespace talus::cli {

/// As the user gave it: each may be empty.
struct TokenWords {
  std::string token;
  std::string file;
};

/// Adds --token-file (TALUS_TOKEN_FILE) and --token (TALUS_TOKEN); what is not a flag is not in the list of
/// processes. Flags win over variables.
void add_token_options(CLI::App& app, TokenWords& words);

/// The token, or the file's content without the end of its line; empty where neither is given. One line says
/// what is wrong with the file.
[[nodiscard]] tl::expected<std::string, std::string> token_of(const TokenWords& words);

}  // namespace talus::cli
