#include <catch2/catch.hpp>

#include "certificates.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {

using namespace testing;

TEST_CASE("a talus_client by TLS trusts the configured authorities") {
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1, "talus.example");
  const std::string certificate = scratch.write("certificate.pem", own.certificate);
  const e2e::ServerProcess server{
      {{"TALUS_TLS_CERTIFICATE", certificate}, {"TALUS_TLS_KEY", scratch.write("key.pem", own.key)}}};
  TestClient client;
  auto options = sized<talus_connect_options>();
  options.flags = TALUS_TLS;
  SECTION("by its certificate and name") {
    options.tls_ca_file = certificate.c_str();
    options.tls_server_name = "talus.example";
    client.join(server.port(), options);
    client.set_view(client.view(1, 0));
    CHECK(client.until_complete().size() == 9);
  }
  SECTION("not a server with an unknown certificate") {
    client.connect(server.port(), options);
    const talus_event closed = client.await(TALUS_EVENT_CLOSED);
    CHECK(closed.status == TALUS_UNTRUSTED);
    CHECK_THAT(closed.message, Catch::Contains("certificate verify failed"));
  }
  SECTION("any server") {
    options.flags |= TALUS_TLS_NO_VERIFY;
    client.join(server.port(), options);
  }
}

}  // namespace talus::c_api
