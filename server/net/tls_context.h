// The server's certificate and key, and the rules of TLS, as OpenSSL keeps them.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/tls/context.h>

namespace talus::server {

struct TlsIdentity {
  tls::Context context;
  std::string description;   // one line, for the log
  std::int64_t expires = 0;  // seconds since 1970
  bool valid_now = false;    // when it was loaded, of the certificate's dates alone
};

/// Reads a certificate with its chain, and its key, both PEM. TLS 1.3 alone. Without session tickets: a
/// client that comes back proves itself anew, which costs a signature, and the server keeps no secret that
/// would open what was said before. The key is tried by a handshake in memory, of a millisecond or two. An
/// error names the file, what is wrong with it, and what would be right.
[[nodiscard]] tl::expected<TlsIdentity, std::string> load_tls(const std::filesystem::path& certificate,
                                                              const std::filesystem::path& key,
                                                              std::chrono::sys_seconds now);

}  // namespace talus::server
