// The settings of [cluster].
#include <string>

#include <catch2/catch.hpp>

#include "config/cluster_check.h"
#include "config/load.h"

using namespace talus::server;

namespace {

std::string refused(const std::string& toml) {
  Settings settings;
  const auto done = apply_toml(settings, toml, "f.toml");
  REQUIRE_FALSE(done);
  CHECK(done.error().find('\n') == std::string::npos);
  return done.error();
}

/// What is wrong with settings that are each right by themselves.
std::string conflict(const std::string& toml) {
  Settings settings;
  REQUIRE(apply_toml(settings, toml, "f.toml"));
  const auto done = check_member(settings.config);
  return done ? "" : settings.origins.locate(done.error());
}

const std::string kNats = "data = \"d\"\n[cluster]\nnats = [\"nats://127.0.0.1:4222\"]\n";
const std::string kTls = "data = \"d\"\n[cluster]\nnats = [\"tls://127.0.0.1:4222\"]\nca = \"ca.pem\"\n";

}  // namespace

TEST_CASE("NATS servers are a list in the file and one text in a variable") {
  Settings file;
  REQUIRE(
      apply_toml(file, "[cluster]\nnats = [\"nats://10.0.0.1:4222\", \"nats://[::1]:4223/\"]\n", "f.toml"));
  Settings variable;
  REQUIRE(apply_environment(variable, {{"TALUS_CLUSTER_NATS", "nats://10.0.0.1:4222, nats://[::1]:4223"}}));
  CHECK(file.config == variable.config);
  CHECK(file.config.cluster.nats.size() == 2);
  CHECK(file.config.cluster.nats.scheme() == "nats");
  CHECK(file.config.cluster.nats.text() == "nats://10.0.0.1:4222, nats://[::1]:4223");

  REQUIRE(apply_toml(file, "[cluster]\nnats = []\n", "f.toml"));
  CHECK_FALSE(file.config.cluster.wanted());
}

TEST_CASE("a wrong address of a NATS server names the line, the key and what would be right") {
  const auto wrong = [](const std::string& list) { return refused("[cluster]\nnats = " + list + "\n"); };
  for (const auto* list : {"[\"10.0.0.1:4222\"]", "[\"http://10.0.0.1:4222\"]", "[\"nats://10.0.0.1\"]",
                           "[\"nats://10.0.0.1:0\"]", "[\"nats://a:1\", \"tls://b:1\"]", "[1]",
                           "[[\"nats://a:1\"]]", "3", "[\"nats://a:99999\"]"}) {
    CAPTURE(list);
    CHECK_THAT(wrong(list), Catch::StartsWith("f.toml:2: cluster.nats: "));
  }
  CHECK_THAT(wrong("[\"nats://a:1\", \"tls://b:1\"]"), Catch::Contains("the same"));
  std::string many = "[";
  for (int i = 0; i <= 32; ++i) many += "\"nats://a:1\",";
  CHECK_THAT(wrong(many + "]"), Catch::Contains("more than 32"));
}

TEST_CASE("a secret in an address is refused and not repeated") {
  const std::string line = refused("[cluster]\nnats = [\"nats://me:swordfish@10.0.0.1:4222\"]\n");
  CHECK_THAT(
      line, Catch::Contains("cluster.nats") && Catch::Contains("@10.0.0.1") && !Catch::Contains("swordfish"));
}

TEST_CASE("settings of the cluster that do not fit each other name one of them and the other") {
  CHECK(conflict("").empty());
  CHECK(conflict(kNats).empty());
  CHECK(conflict(kTls).empty());
  CHECK_THAT(conflict("[cluster]\nnats = [\"nats://a:1\"]\n"),
             Catch::StartsWith("f.toml:2: cluster.nats: ") && Catch::Contains("data"));
  CHECK_THAT(conflict(kNats + "user = \"u\"\n"),
             Catch::StartsWith("f.toml:4: cluster.user: ") && Catch::Contains("password_file"));
  CHECK_THAT(conflict(kNats + "password_file = \"p\"\n"),
             Catch::StartsWith("f.toml:4: cluster.password_file: ") && Catch::Contains("user"));
  CHECK_THAT(conflict(kNats + "user = \"u\"\npassword_file = \"p\"\ntoken_file = \"t\"\n"),
             Catch::StartsWith("f.toml:6: cluster.token_file: "));
  CHECK_THAT(conflict(kNats + "nkey_file = \"n\"\nuser = \"u\"\npassword_file = \"p\"\n"),
             Catch::StartsWith("f.toml:4: cluster.nkey_file: "));
  CHECK_THAT(conflict(kNats + "store = \"abc\"\n"),
             Catch::StartsWith("f.toml:4: cluster.store: ") && Catch::Contains("32"));
  CHECK_THAT(conflict(kNats + "store = \"" + std::string(32, 'A') + "\"\n"),
             Catch::Contains("cluster.store"));
  CHECK(conflict(kNats + "store = \"" + std::string(32, 'a') + "\"\n").empty());
  CHECK_THAT(conflict(kNats + "replicas = 2\n"),
             Catch::StartsWith("f.toml:4: cluster.replicas: ") && Catch::Contains("1, 3 or 5"));
  CHECK_THAT(conflict("data = \"d\"\n[cluster]\nnats = [\"tls://127.0.0.1:4222\"]\n"),
             Catch::StartsWith("cluster.ca: "));
  CHECK_THAT(conflict(kTls + "certificate = \"c\"\n"), Catch::Contains("cluster.certificate: "));
  CHECK_THAT(conflict(kTls + "key = \"k\"\n"), Catch::Contains("cluster.key: "));
  CHECK_THAT(conflict(kNats + "certificate = \"c\"\nkey = \"k\"\n"), Catch::Contains("tls://"));
  CHECK_THAT(conflict(kNats + "peers = [\"http://a:1\"]\n"), Catch::StartsWith("cluster.peers_token_file: "));
  CHECK_THAT(conflict(kTls + "certificate = \"c\"\nkey = \"k\"\npeers = [\"https://a:1\"]\n"),
             Catch::StartsWith("cluster.peers_token_file: "));
}
