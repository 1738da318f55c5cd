// talus-load's own connection, from a TLS server's side that the test takes step by step.
#include "link.h"

#include <array>
#include <catch2/catch.hpp>

#include <talus/client/tls.h>

#include "certificates.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::load;
using asio::ip::tcp;

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
  const auto client_side = client::make_tls_context(options);
  REQUIRE(client_side.has_value());
  const tls::Context server_side = tls::new_context(tls::Role::server);
  use_certificate(server_side.get(), own);

  asio::io_context io;
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  std::array<std::byte, 4096> input{};
  Owner owner;
  Link link{io, input, owner};
  link.open({acceptor.local_endpoint(), {}, true, *client_side, options});
  link.take(1);  // before it is connected at all
  tcp::socket accepted = acceptor.accept();
  accepted.native_non_blocking(true);
  tls::Session server{server_side, tls::Role::server, accepted.native_handle()};
  while (accepted.available() == 0) (void)io.run_one();
  // It has sent its first message. This answers, and the answer lies there while the link's turns to read
  // come.
  REQUIRE(server.handshake().result == tls::Step::Result::wait_to_read);
  for (int turn = 0; turn < 1000; ++turn) link.take(64);
  while (!owner.is_open && owner.failure.empty()) (void)io.run_one();
  CHECK(owner.failure.empty());
  CHECK(server.handshake().result == tls::Step::Result::done);
}
