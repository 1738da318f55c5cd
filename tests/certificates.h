// Certificates for a test's servers, made when the test runs.
#pragma once

#include <string>

/// PEM. Each has a key of its own, vouches for itself, and is good for an hour.
struct TestCertificate {
  std::string certificate;
  std::string key;
};

struct ssl_ctx_st;  // OpenSSL's SSL_CTX

/// Makes a server's context show the certificate.
void use_certificate(ssl_ctx_st* context, const TestCertificate& certificate);

/// For localhost and 127.0.0.1 unless another name is given; `hours` below 0: ended so long ago.
[[nodiscard]] TestCertificate make_certificate(long serial, const std::string& name = "localhost",
                                               int hours = 1, const char* curve = "P-256");
