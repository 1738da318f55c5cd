#include "net/proxy_header.h"

#include <rapidcheck.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

using namespace talus::server;
using Bytes = std::vector<std::uint8_t>;
using Client = std::optional<asio::ip::tcp::endpoint>;

namespace {

const Bytes kSignature{0x0D, 0x0A, 0x0D, 0x0A, 0x00, 0x0D, 0x0A, 0x51, 0x55, 0x49, 0x54, 0x0A};

Bytes header(std::uint8_t version_and_command, std::uint8_t family, const Bytes& body) {
  Bytes bytes = kSignature;
  bytes.insert(bytes.end(), {version_and_command, family, static_cast<std::uint8_t>(body.size() >> 8),
                             static_cast<std::uint8_t>(body.size())});
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

const Bytes kTcp4Body{192, 0, 2, 7, 198, 51, 100, 1, 0xC0, 0x01, 0x12, 0xAC};

Bytes tcp6_body() {
  Bytes body{0x20, 0x01, 0x0D, 0xB8};
  body.resize(16);
  body[15] = 9;
  body.resize(32);
  body.insert(body.end(), {0x00, 0x50, 0x12, 0xAC});
  return body;
}

/// As the door reads it: a prefix, then as many bytes as that says.
tl::expected<Client, std::string_view> read(const Bytes& bytes) {
  const auto all = std::as_bytes(std::span{bytes});
  REQUIRE(all.size() >= kProxyPrefixBytes);
  const auto prefix = read_proxy_prefix(all.first<kProxyPrefixBytes>());
  if (!prefix) return tl::make_unexpected(prefix.error());
  REQUIRE(all.size() == kProxyPrefixBytes + prefix->body_bytes);
  return proxied_client(*prefix, all.subspan(kProxyPrefixBytes));
}

void check_refused(const Bytes& bytes, const std::string& part) {
  const auto client = read(bytes);
  REQUIRE_FALSE(client.has_value());
  CHECK_THAT(std::string{client.error()}, Catch::Contains(part));
}

}  // namespace

TEST_CASE("a PROXY header says which IPv4 address and port it speaks for") {
  // As HAProxy writes it for 192.0.2.7:49153 to 198.51.100.1:4780.
  const Bytes golden{0x0D, 0x0A, 0x0D, 0x0A, 0x00, 0x0D, 0x0A, 0x51, 0x55, 0x49, 0x54, 0x0A, 0x21, 0x11,
                     0x00, 0x0C, 0xC0, 0x00, 0x02, 0x07, 0xC6, 0x33, 0x64, 0x01, 0xC0, 0x01, 0x12, 0xAC};
  const auto client = read(golden);
  REQUIRE(client.has_value());
  CHECK(client.value() == asio::ip::tcp::endpoint{asio::ip::make_address("192.0.2.7"), 49153});
}

TEST_CASE("a PROXY header says to which port of the proxy the client came") {
  using Origin = ProxyPrefix::Origin;
  CHECK(proxied_port({Origin::tcp4, 12}, std::as_bytes(std::span{kTcp4Body})) == 4780);
  const Bytes tcp6 = tcp6_body();
  CHECK(proxied_port({Origin::tcp6, 36}, std::as_bytes(std::span{tcp6})) == 4780);
  CHECK(proxied_port({Origin::peer, 12}, std::as_bytes(std::span{kTcp4Body})) == 0);
}

TEST_CASE("a PROXY header says which IPv6 address and port it speaks for") {
  const auto client = read(header(0x21, 0x21, tcp6_body()));
  REQUIRE(client.has_value());
  CHECK(client.value() == asio::ip::tcp::endpoint{asio::ip::make_address("2001:db8::9"), 80});
}

TEST_CASE("extra bytes after the addresses of a PROXY header are passed over") {
  Bytes body = kTcp4Body;
  body.insert(body.end(), {0x04, 0x00, 0x03, 1, 2, 3});  // PP2_TYPE_NOOP
  CHECK(read(header(0x21, 0x11, body)).value() == read(header(0x21, 0x11, kTcp4Body)).value());
}

TEST_CASE("a proxy that sends LOCAL, or names no client, is its own client") {
  CHECK(read(header(0x20, 0x00, {})).value() == Client{});
  CHECK(read(header(0x20, 0x11, kTcp4Body)).value() == Client{});
  CHECK(read(header(0x21, 0x00, {1, 2, 3})).value() == Client{});
}

TEST_CASE("a PROXY header that breaks its rules is refused, and says which") {
  check_refused(header(0x11, 0x11, kTcp4Body), "version");
  check_refused(header(0x22, 0x11, kTcp4Body), "command");
  check_refused(header(0x21, 0x12, kTcp4Body), "neither TCP");
  check_refused(header(0x21, 0x31, Bytes(216)), "neither TCP");
  check_refused(header(0x21, 0x11, Bytes(11)), "too short");
  check_refused(header(0x21, 0x21, Bytes(35)), "too short");
  check_refused(header(0x21, 0x11, Bytes(kMaxProxyBodyBytes + 1)), "1,024");
  const std::string version_1 = "PROXY TCP4 192.0.2.7 198.51.100.1 49153 4780\r\n";
  check_refused({version_1.begin(), version_1.end()}, "no PROXY header of version 2");
}

TEST_CASE("every byte of a PROXY header's signature counts") {
  for (std::size_t i = 0; i < kSignature.size(); ++i) {
    Bytes bytes = header(0x21, 0x11, kTcp4Body);
    bytes[i] ^= 0x20;
    CHECK_FALSE(read(bytes).has_value());
  }
}

TEST_CASE("a PROXY header is bounded and has the bytes of its addresses, or is refused") {
  const auto holds = rc::check([] {
    // Half of them almost right, or none would get past the signature.
    Bytes bytes = *rc::gen::container<Bytes>(kProxyPrefixBytes, rc::gen::arbitrary<std::uint8_t>());
    if (*rc::gen::arbitrary<bool>()) std::copy(kSignature.begin(), kSignature.end(), bytes.begin());
    if (*rc::gen::arbitrary<bool>()) bytes[12] = *rc::gen::element<std::uint8_t>(0x20, 0x21);
    if (*rc::gen::arbitrary<bool>()) bytes[13] = *rc::gen::element<std::uint8_t>(0x00, 0x11, 0x21);
    if (*rc::gen::arbitrary<bool>()) bytes[14] = 0;
    const auto prefix = read_proxy_prefix(std::as_bytes(std::span{bytes}).first<kProxyPrefixBytes>());
    RC_TAG(prefix.has_value());
    if (!prefix) return;
    RC_ASSERT(prefix->body_bytes <= kMaxProxyBodyBytes);
    RC_ASSERT(prefix->body_bytes == bytes[14] * 256 + bytes[15]);
    // Exactly as long as it says, so that a read beyond it is seen under the address sanitizer.
    const std::vector<std::byte> body(prefix->body_bytes, std::byte{0x7F});
    const auto client = proxied_client(*prefix, body);
    RC_ASSERT(client.has_value() == (bytes[12] == 0x21 && bytes[13] != 0x00));
  });
  CHECK(holds);
}

TEST_CASE("a PROXY header gives back any address that is written into it") {
  const auto holds = rc::check([](std::uint32_t address, std::uint16_t port) {
    Bytes body = kTcp4Body;
    for (int i = 0; i < 4; ++i)
      body[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(address >> (24 - 8 * i));
    body[8] = static_cast<std::uint8_t>(port >> 8);
    body[9] = static_cast<std::uint8_t>(port);
    const auto client = read(header(0x21, 0x11, body));
    RC_ASSERT(client.has_value());
    RC_ASSERT(client.value() == asio::ip::tcp::endpoint(asio::ip::address_v4{address}, port));
  });
  CHECK(holds);
}
