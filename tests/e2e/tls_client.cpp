#include "tls_client.h"

#include <array>
#include <catch2/catch.hpp>
#include <memory>

#include <asio/write.hpp>

namespace talus::e2e {

std::string client_hello() {
  const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context{SSL_CTX_new(TLS_client_method()),
                                                                  &SSL_CTX_free};
  const std::unique_ptr<SSL, decltype(&SSL_free)> tls{SSL_new(context.get()), &SSL_free};
  BIO* const out = BIO_new(BIO_s_mem());
  SSL_set_bio(tls.get(), BIO_new(BIO_s_mem()), out);  // it owns them
  SSL_connect(tls.get());
  std::string bytes(BIO_ctrl_pending(out), '\0');
  REQUIRE(BIO_read(out, bytes.data(), static_cast<int>(bytes.size())) == static_cast<int>(bytes.size()));
  return bytes;
}

TlsClient::TlsClient(std::uint16_t port, const std::string& before, int version) {
  socket_.connect({asio::ip::address_v4::loopback(), port});
  asio::write(socket_, asio::buffer(before));
  SSL_set_min_proto_version(stream_.native_handle(), version);
  SSL_set_max_proto_version(stream_.native_handle(), version);
  stream_.handshake(asio::ssl::stream_base::client, failure_);
}

long TlsClient::serial() {
  X509* const certificate = SSL_get0_peer_certificate(stream_.native_handle());
  return ASN1_INTEGER_get(X509_get0_serialNumber(certificate));
}

void TlsClient::send(const protocol::Frame& frame) {
  asio::write(stream_, asio::buffer(frame));
}

std::optional<ReceivedFrame> TlsClient::receive() {
  while (!frames_.has_frame()) {
    if (unread_.empty()) {
      std::array<char, 4096> buffer{};
      const std::size_t bytes = stream_.read_some(asio::buffer(buffer), ended_);
      if (ended_) return std::nullopt;
      unread_.assign(buffer.data(), bytes);
    }
    const auto taken = frames_.feed(std::as_bytes(std::span{unread_}));
    REQUIRE(taken.has_value());
    unread_.erase(0, *taken);
  }
  ReceivedFrame received{protocol::Frame{frames_.frame().begin(), frames_.frame().end()}};
  frames_.pop();
  return received;
}

void TlsClient::reset() {
  socket_.set_option(asio::socket_base::linger{true, 0});
  socket_.close();
}

void TlsClient::await_close() {
  std::array<char, 4096> buffer{};
  std::error_code closed;
  while (!closed) (void)socket_.read_some(asio::buffer(buffer), closed);
}

}  // namespace talus::e2e
