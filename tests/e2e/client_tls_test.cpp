// talus-client by TLS.
#include <algorithm>
#include <catch2/catch.hpp>

#include "certificates.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus::e2e;

namespace {

struct Secure {
  ScratchDirectory scratch;
  TestCertificate own = make_certificate(1, "talus.example");
  std::string certificate = scratch.write("certificate.pem", own.certificate);
  ServerProcess server{
      {{"TALUS_TLS_CERTIFICATE", certificate}, {"TALUS_TLS_KEY", scratch.write("key.pem", own.key)}}};
};

ProgramResult get(const ServerProcess& server, std::vector<std::string> flags) {
  flags.insert(flags.begin(), {"--connect", "127.0.0.1:" + std::to_string(server.port())});
  flags.insert(flags.end(), {"get", "0", "0", "0"});
  return run_program(TALUS_CLIENT_PATH, flags);
}

void check_refused(const ProgramResult& ended, const std::string& part) {
  INFO(ended.err);
  CHECK(ended.status == 1);
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  CHECK_THAT(ended.err, Catch::StartsWith("talus-client: 127.0.0.1:") && Catch::Contains(part));
}

}  // namespace

TEST_CASE("talus-client gets a chunk by TLS, and the same one") {
  const Secure secure;
  const ProgramResult by_tls =
      get(secure.server, {"--ca", secure.certificate, "--tls-name", "talus.example"});
  INFO(by_tls.err);
  CHECK(by_tls.status == 0);
  const auto hash = [](const ProgramResult& ended) {
    return ended.out.substr(0, ended.out.find("revision"));
  };
  CHECK_THAT(hash(by_tls), Catch::Contains("hash "));
  CHECK(hash(by_tls) == hash(get(ServerProcess{}, {})));
}

TEST_CASE("talus-client says in one line why it does not trust a server") {
  const Secure secure;
  check_refused(get(secure.server, {"--tls", "--tls-name", "talus.example"}),
                "certificate verify failed: self-signed certificate; give its issuer's certificate "
                "(TlsOptions::ca_file; in the programs --ca FILE)");
  check_refused(get(secure.server, {"--ca", secure.certificate}), "--tls-name NAME");
}

TEST_CASE("talus-client by TLS says in one line that a server is plain") {
  const ServerProcess server;
  check_refused(get(server, {"--tls"}), "does not speak TLS");
}

TEST_CASE("talus-client without TLS says in one line that a server may want it") {
  const Secure secure;
  check_refused(get(secure.server, {}), "--tls");
}
