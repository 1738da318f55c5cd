// Secrets in files.
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "certificates.h"
#include "cluster/jetstream/credentials.h"
#include "scratch_directory.h"

using namespace talus::server;
using jetstream::load_credentials;

namespace {

std::string refused(const Cluster& cluster) {
  const auto loaded = load_credentials(cluster);
  REQUIRE_FALSE(loaded);
  CHECK(loaded.error().find('\n') == std::string::npos);
  return loaded.error();
}

}  // namespace

TEST_CASE("secrets of the cluster come from files, without their newline") {
  const ScratchDirectory scratch;
  Cluster cluster;
  cluster.user = "talus";
  cluster.password_file = scratch.write("password", "swordfish\n");
  ::chmod(cluster.password_file.c_str(), 0600);
  auto loaded = load_credentials(cluster);
  REQUIRE(loaded);
  REQUIRE(loaded->password);
  CHECK(loaded->password->bytes() == "swordfish");
  CHECK(loaded->warnings.empty());
  CHECK(loaded->any());

  ::chmod(cluster.password_file.c_str(), 0644);
  const auto warned = load_credentials(cluster);
  REQUIRE(warned);
  REQUIRE(warned->warnings.size() == 1);
  CHECK_THAT(warned->warnings[0], Catch::StartsWith("cluster.password_file: ") && Catch::Contains("chmod"));
  CHECK_FALSE(load_credentials(Cluster{})->any());
}

TEST_CASE("a secret that cannot be had names its key and file") {
  const ScratchDirectory scratch;
  Cluster cluster;
  cluster.token_file = scratch / "nowhere";
  CHECK_THAT(refused(cluster), Catch::StartsWith("cluster.token_file: ") && Catch::Contains("nowhere"));
  cluster.token_file = scratch.write("empty", "\n");
  CHECK_THAT(refused(cluster), Catch::StartsWith("cluster.token_file: ") && Catch::Contains("0 bytes"));
  cluster.token_file.clear();
  cluster.nkey_file = scratch.write("nkey", std::string(100, 'S') + std::string(100, 'U'));
  CHECK_THAT(refused(cluster), Catch::Contains("has 200 bytes; it must have 1 to 128, as \"nk -gen user\"") &&
                                   !Catch::Contains("urandom"));
  cluster.nkey_file = scratch.write("nkey", "SUSWORDFISH\n");
  CHECK_THAT(refused(cluster), Catch::StartsWith("cluster.nkey_file: ") && !Catch::Contains("SWORDFISH"));
  cluster.nkey_file.clear();
  cluster.ca = scratch.write("ca.pem", "no certificate");
  CHECK_THAT(refused(cluster), Catch::StartsWith("cluster.ca: ") && Catch::Contains("BEGIN CERTIFICATE"));
  cluster.ca.clear();
  cluster.key = scratch.write("key.pem", "-----BEGIN ENCRYPTED PRIVATE KEY-----\n");
  CHECK_THAT(refused(cluster), Catch::StartsWith("cluster.key: ") && Catch::Contains("passphrase"));
}
