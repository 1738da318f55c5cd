// talus-load's own connection to talusd.
#include "link.h"

#include <array>
#include <catch2/catch.hpp>
#include <chrono>

#include <talus/client/tls.h>

#include "certificates.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::load;
using e2e::ServerProcess;
using Clock = std::chrono::steady_clock;

namespace {

class Owner final : public LinkOwner {
 public:
  void opened() override { is_open = true; }
  void received(const wire::Message&, std::size_t) override {}
  void read_done() override {}
  void ended(const std::string& reason, bool) override { failure = reason; }

  bool is_open = false;
  std::string failure;
};

}  // namespace

TEST_CASE("a slow reader's turns to read leave it its handshake") {
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1);
  client::TlsOptions options;
  options.ca_file = scratch.write("c.pem", own.certificate);
  const ServerProcess server{
      {{"TALUS_TLS_CERTIFICATE", options.ca_file}, {"TALUS_TLS_KEY", scratch.write("k.pem", own.key)}}};
  const auto tls = client::make_tls_context(options);
  REQUIRE(tls.has_value());

  asio::io_context io;
  std::array<std::byte, 4096> input{};
  Owner owner;
  Link link{io, input, owner};
  link.open({{asio::ip::address_v4::loopback(), server.port()}, {}, true, *tls, options});
  link.take(1);  // before it is connected at all
  (void)io.run_one();
  // It has asked for its handshake, and the answer comes while it takes.
  for (const auto end = Clock::now() + std::chrono::milliseconds{200}; Clock::now() < end;) link.take(64);
  (void)io.run_for(std::chrono::seconds{60});
  INFO(owner.failure);
  CHECK(owner.is_open);
  CHECK(owner.failure.empty());
}
