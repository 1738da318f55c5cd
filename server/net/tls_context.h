// The server's certificate, key and TLS rules, as an OpenSSL context.
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
  bool valid_now = false;    // by the certificate's dates alone, when it was loaded
};

/// Reads a certificate with its chain, and its key, both PEM. TLS 1.3 only. No session tickets: a returning
/// client makes a full handshake, which costs a signature, and the server keeps no secret that could decrypt
/// earlier traffic. Tests the key by a handshake in memory, which takes one or two milliseconds. An error
/// names the file, the fault, and the remedy.
[[nodiscard]] tl::expected<TlsIdentity, std::string> load_tls(const std::filesystem::path& certificate,
                                                              const std::filesystem::path& key,
                                                              std::chrono::sys_seconds now);

}  // namespace talus::server
