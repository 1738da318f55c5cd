#include "net/tls_context.h"

#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "certificates.h"
#include "runtime/clock.h"
#include "scratch_directory.h"

using namespace talus::server;

namespace {

auto load_now(const std::filesystem::path& certificate, const std::filesystem::path& key) {
  return load_tls(certificate, key, SystemClock{}.wall());
}

struct Files {
  ScratchDirectory scratch;
  TestCertificate own = make_certificate(1);
  std::string certificate = scratch.write("certificate.pem", own.certificate);
  std::string key = scratch.write("key.pem", own.key);

  /// The one line that says why not.
  [[nodiscard]] std::string refusal(const std::string& certificate_file, const std::string& key_file) const {
    const auto loaded = load_now(certificate_file, key_file);
    REQUIRE_FALSE(loaded.has_value());
    CHECK(std::count(loaded.error().begin(), loaded.error().end(), '\n') == 0);
    return loaded.error();
  }
};

}  // namespace

TEST_CASE("a certificate and its key make an identity") {
  const Files files;
  const auto loaded = load_now(files.certificate, files.key);
  REQUIRE(loaded.has_value());
  CHECK(loaded->valid_now);
  CHECK_THAT(loaded->description, Catch::Contains(files.certificate) && Catch::Contains("valid until"));
}

TEST_CASE("certificate, chain and key may stand in one file") {
  const Files files;
  const std::string all =
      files.scratch.write("all", files.own.key + files.own.certificate + make_certificate(2).certificate);
  CHECK(load_now(all, all).has_value());
}

TEST_CASE("one of certificate and key alone is refused, and says that both are needed") {
  const Files files;
  CHECK_THAT(files.refusal(files.certificate, ""),
             Catch::Contains(files.certificate) && Catch::Contains("tls.key is not"));
  CHECK_THAT(files.refusal("", files.key),
             Catch::Contains(files.key) && Catch::Contains("tls.certificate is not"));
}

TEST_CASE("a missing file is named, with why") {
  const Files files;
  CHECK_THAT(files.refusal("/nowhere/c.pem", files.key),
             Catch::StartsWith("tls.certificate /nowhere/c.pem: ") && Catch::Contains("No such file"));
  CHECK_THAT(files.refusal(files.certificate, "/nowhere/k.pem"),
             Catch::StartsWith("tls.key /nowhere/k.pem: "));
  CHECK_THAT(files.refusal("/dev/zero", files.key), Catch::Contains("not a regular file"));
  const std::string pipe = (files.scratch.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(files.refusal(files.certificate, pipe), Catch::Contains("not a regular file"));
}

TEST_CASE("a certificate with a passphrase is refused without a prompt") {
  const Files files;
  std::string locked = files.own.certificate;
  locked.insert(locked.find('\n') + 1,
                "Proc-Type: 4,ENCRYPTED\nDEK-Info: AES-256-CBC,00112233445566778899AABBCCDDEEFF\n\n");
  CHECK_THAT(files.refusal(files.scratch.write("locked", locked), files.key),
             Catch::Contains("bad password read"));
  CHECK_THAT(files.refusal(files.scratch.write("chain", files.own.certificate + locked), files.key),
             Catch::Contains("certificate 2 in it is damaged"));
}

TEST_CASE("another certificate's key is refused with both names") {
  const Files files;
  const std::string other = files.scratch.write("other.pem", make_certificate(2).key);
  CHECK_THAT(files.refusal(files.certificate, other),
             Catch::StartsWith("tls.key " + other) && Catch::Contains(files.certificate));
}

TEST_CASE("garbage is refused, and what would be right is said") {
  const Files files;
  const std::string garbage = files.scratch.write("garbage", "no PEM\n");
  CHECK_THAT(files.refusal(garbage, files.key), Catch::Contains("holds no certificate"));
  CHECK_THAT(files.refusal(files.certificate, garbage), Catch::Contains("holds no private key"));
  std::string damaged = files.own.certificate;
  damaged.insert(damaged.size() / 2, "!!");
  const std::string chain = files.scratch.write("chain", files.own.certificate + damaged);
  CHECK_THAT(files.refusal(chain, files.key), Catch::Contains("certificate 2 in it is damaged"));
}

TEST_CASE("a key with a passphrase is refused without a prompt") {
  const Files files;
  const std::string locked = files.scratch.write(
      "locked",
      "-----BEGIN ENCRYPTED PRIVATE KEY-----\n"
      "MFUwSAYJKoZIhvcNAQUNMDswGgYJKoZIhvcNAQUMMA0ECAAAAAAAAAAAAgEBMB0GCWCGSAFlAwQBKgQQAAAAAAAA\n"
      "AAAAAAAAAAAAAAQJAAAAAAAAAAAA\n"
      "-----END ENCRYPTED PRIVATE KEY-----\n");
  CHECK_THAT(files.refusal(files.certificate, locked), Catch::Contains("passphrase"));
}

TEST_CASE("a key that TLS 1.3 does not sign by is refused, and the kinds that it does are said") {
  const Files files;
  const TestCertificate odd = make_certificate(4, "localhost", 1, "secp256k1");
  CHECK_THAT(files.refusal(files.scratch.write("c", odd.certificate), files.scratch.write("k", odd.key)),
             Catch::StartsWith("tls.key ") && Catch::Contains("P-256"));
  const TestCertificate larger = make_certificate(5, "localhost", 1, "P-521");
  CHECK(load_now(files.scratch.write("c", larger.certificate), files.scratch.write("k", larger.key)));
}

TEST_CASE("a certificate out of its dates is an identity that says so") {
  const Files files;
  const TestCertificate ended = make_certificate(3, "localhost", -1);
  const auto loaded =
      load_now(files.scratch.write("c", ended.certificate), files.scratch.write("k", ended.key));
  REQUIRE(loaded.has_value());
  CHECK_FALSE(loaded->valid_now);
}
