#include <talus/tls/session.h>

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "certificates.h"

using namespace talus::tls;

namespace {

/// The server's context, with a certificate that vouches for itself.
Context server_context() {
  Context context = new_context(Role::server);
  use_certificate(context.get(), make_certificate(1));
  return context;
}

/// Both ends of a connection.
class Sockets {
 public:
  Sockets() { REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends_.data()) == 0); }
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
  ~Sockets() {
    for (const int end : ends_) ::close(end);
  }
  [[nodiscard]] int server() const { return ends_[0]; }
  [[nodiscard]] int client() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{};
};

struct ConnectedPair {
  Sockets sockets;
  Session server{server_context(), Role::server, sockets.server()};
  Session client{new_context(Role::client), Role::client, sockets.client()};

  ConnectedPair() {
    Step from_client;
    Step from_server;
    do {
      from_client = client.handshake();
      from_server = server.handshake();
    } while (from_client.waits() || from_server.waits());
    REQUIRE(from_client.result == Step::Result::done);
    REQUIRE(from_server.result == Step::Result::done);
  }
};

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span{text});
}

std::string read_all(Session& session, std::size_t size) {
  std::string text(size, '\0');
  const Step step = session.read(std::as_writable_bytes(std::span{text}));
  text.resize(step.bytes);
  return text;
}

}  // namespace

TEST_CASE("bytes arrive as they were written, both ways") {
  ConnectedPair ends;
  REQUIRE(ends.client.write(bytes_of("a question")).bytes == 10);
  CHECK(read_all(ends.server, 100) == "a question");
  REQUIRE(ends.server.write(bytes_of("an answer")).bytes == 9);
  CHECK(read_all(ends.client, 100) == "an answer");
}

TEST_CASE("with nothing to read a session waits for its socket") {
  ConnectedPair ends;
  std::array<std::byte, 10> into{};
  CHECK(ends.server.read(into).result == Step::Result::wait_to_read);
}

TEST_CASE("a session reports bytes that the socket does not") {
  ConnectedPair ends;
  REQUIRE(ends.client.write(bytes_of("0123456789")).bytes == 10);
  CHECK_FALSE(ends.server.has_more());
  CHECK(read_all(ends.server, 4) == "0123");
  CHECK(ends.server.has_more());
  CHECK(read_all(ends.server, 100) == "456789");
  CHECK_FALSE(ends.server.has_more());
}

TEST_CASE("a write goes on where a full socket stopped it") {
  ConnectedPair ends;
  const std::string text(4'000'000, 'x');
  std::size_t written = 0;
  std::size_t received = 0;
  bool waited = false;
  std::vector<std::byte> into(100'000);
  while (received < text.size()) {
    if (written < text.size()) {
      const Step step = ends.client.write(bytes_of(text).subspan(written));
      written += step.bytes;
      if (!step.waits()) continue;
      CHECK(step.result == Step::Result::wait_to_write);
      waited = true;
    }
    received += ends.server.read(into).bytes;
  }
  CHECK(waited);
  CHECK(received == text.size());
}

TEST_CASE("the other side's end is an end and no error, said or not") {
  const bool said = GENERATE(true, false);
  ConnectedPair ends;
  if (said) {
    CHECK(ends.client.close_notify().result == Step::Result::done);
  } else {
    ::shutdown(ends.sockets.client(), SHUT_WR);
  }
  std::array<std::byte, 10> into{};
  CHECK(ends.server.read(into).result == Step::Result::closed);
}

TEST_CASE("a peer without TLS fails with OpenSSL's words") {
  const Sockets sockets;
  Session server{server_context(), Role::server, sockets.server()};
  REQUIRE(::write(sockets.client(), "plain text", 10) == 10);
  const Step step = server.handshake();
  REQUIRE(step.result == Step::Result::failed);
  CHECK(step.error.category() == error_category());
  CHECK(step.error.message() == "wrong version number");
}
