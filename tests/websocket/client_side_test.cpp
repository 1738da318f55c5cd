#include <rapidcheck.h>
#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include <talus/websocket/client_side.h>

using namespace talus::websocket;

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::array kMask{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
// The RFC's example.
const std::string kAccept = "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n";
const std::string kUpgrade = "Upgrade: websocket\r\nConnection: Upgrade\r\n";
const std::string kSwitching = "HTTP/1.1 101 Switching Protocols\r\n";
const std::string kGoodAnswer = kSwitching + kUpgrade + kAccept + "\r\n";

ClientSide new_side() {
  constexpr std::string_view kNonce = "the sample nonce";
  return {"talus.example:80", "/v1/stream",
          std::as_bytes(std::span<const char, kNonceBytes>{kNonce.data(), kNonceBytes})};
}

Bytes bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span{text});
  return {bytes.begin(), bytes.end()};
}

/// What a side takes out of `input`, in pieces of so many bytes.
std::string take(ClientSide& side, Bytes input, std::size_t piece = SIZE_MAX / 2) {
  std::string all;
  for (std::size_t at = 0; at < input.size() && !side.failure(); at += piece) {
    const auto part = std::span{input}.subspan(at, std::min(piece, input.size() - at));
    all.append(reinterpret_cast<const char*>(part.data()), side.take(part));
  }
  return all;
}

Failure failure_of(const std::string& input) {
  ClientSide side = new_side();
  (void)take(side, bytes_of(input));
  REQUIRE(side.failure());
  return *side.failure();
}

}  // namespace

TEST_CASE("The accept key is as in the RFC's example") {
  CHECK(accept_key("dGhlIHNhbXBsZSBub25jZQ==") == "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
}

TEST_CASE("The request is a WebSocket's, without extensions") {
  CHECK(new_side().request() ==
        "GET /v1/stream HTTP/1.1\r\nHost: talus.example:80\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
}

TEST_CASE("Payloads follow the answer, however they are cut") {
  CHECK(rc::check([] {
    Bytes input = bytes_of(kGoodAnswer);
    std::string payload;
    const int messages = *rc::gen::inRange(0, 5);
    for (int i = 0; i < messages; ++i) {
      const std::string text(*rc::gen::element<std::size_t>(0, 1, 125, 126, 65'535, 65'536),
                             static_cast<char>('a' + i));
      append_binary(input, bytes_of(text), {});
      payload += text;
      if (i == 2) append_pong(input, {}, {});  // unasked
    }
    ClientSide side = new_side();
    const auto piece = *rc::gen::element<std::size_t>(1, 2, 50, 1000, SIZE_MAX / 2);
    RC_ASSERT(take(side, input, piece) == payload);
    RC_ASSERT(side.is_open());
    RC_ASSERT(!side.failure());
  }));
}

TEST_CASE("A list in several fields of one name is read as one") {
  ClientSide side = new_side();
  (void)take(side, bytes_of(kSwitching + kAccept + "Upgrade: h2c\r\nConnection: keep-alive\r\n" + kUpgrade +
                            "\r\n"));
  CHECK(side.is_open());
}

TEST_CASE("A server reads a client's frames, which are masked") {
  Bytes sent;
  const std::string text(70'000, 'x');
  ClientSide::append(sent, bytes_of("abc"), kMask);
  CHECK(sent == Bytes{std::byte{0x82}, std::byte{0x83}, kMask[0], kMask[1], kMask[2], kMask[3],
                      std::byte{'a'} ^ kMask[0], std::byte{'b'} ^ kMask[1], std::byte{'c'} ^ kMask[2]});
  ClientSide::append(sent, bytes_of(text), kMask);
  FrameReader server{Sender::client};
  const std::size_t bytes = server.take(sent);
  CHECK(server.end() == End::none);
  CHECK(std::string{reinterpret_cast<const char*>(sent.data()), bytes} == "abc" + text);
}

TEST_CASE("A Ping is answered by its own Pong, a Close by a Close, masked") {
  ClientSide side = new_side();
  Bytes input = bytes_of(kGoodAnswer + std::string{"\x89\x02hi", 4} +
                         std::string{"\x82\x03"
                                     "end",
                                     5} +
                         std::string{"\x88\x02\x03\xE8", 4} + "what no longer counts");
  CHECK(take(side, input) == "end");
  REQUIRE(side.failure());
  CHECK(side.failure()->kind == Failure::Kind::closed);
  Bytes control;
  while (side.has_control()) side.append_control(control, kMask);
  CHECK(control == Bytes{std::byte{0x8A}, std::byte{0x82}, kMask[0], kMask[1], kMask[2], kMask[3],
                         std::byte{'h'} ^ kMask[0], std::byte{'i'} ^ kMask[1], std::byte{0x88},
                         std::byte{0x82}, kMask[0], kMask[1], kMask[2], kMask[3], std::byte{3} ^ kMask[0],
                         std::byte{0xE8} ^ kMask[1]});
}

TEST_CASE("The peer must be a WebSocket server that knows the key") {
  for (const std::string& answer :
       {kSwitching + kUpgrade + "\r\n", kSwitching + kAccept + "Upgrade: websocket\r\n\r\n",
        kSwitching + kAccept + "Connection: Upgrade\r\n\r\n",
        kSwitching + kUpgrade + "Sec-WebSocket-Accept: S3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n",
        kSwitching + kUpgrade + kAccept + "Sec-WebSocket-Extensions: permessage-deflate\r\n\r\n",
        kSwitching + kUpgrade + kAccept + "Sec-WebSocket-Protocol: chat\r\n\r\n",
        std::string{"HTTP/1.1 1x1 Switching Protocols\r\n\r\n"}, std::string{"HTTP/1.1 \r\n\r\n"},
        std::string{"SSH-2.0-OpenSSH_9.2"}, std::string{"\x2c\0\0\0\x0c\0\0\0", 8},
        kSwitching + "X: " + std::string(ClientSide::kMaxAnswerBytes, 'x')}) {
    INFO(answer.substr(0, 200));
    const Failure failure = failure_of(answer);
    CHECK(failure.kind == Failure::Kind::violation);
    CHECK_FALSE(failure.text.empty());
  }
}

TEST_CASE("A server that refuses is quoted in one printable line, and may say when to come back") {
  const Failure busy = failure_of("HTTP/1.1 503 Service \x1b[31mUnavailable\r\nretry-after:  7 \r\n\r\n{}");
  CHECK(busy.kind == Failure::Kind::refused);
  CHECK(busy.status == 503);
  CHECK(busy.retry_after_seconds == 7);
  CHECK(busy.text == "the server answered 503 Service ?[31mUnavailable instead of a WebSocket");
  CHECK(failure_of("HTTP/1.1 404 Not Found\r\nRetry-After: soon\r\n\r\n").retry_after_seconds == 0);
}

TEST_CASE("A server that masks its frames breaks the protocol, and gets the reason") {
  ClientSide side = new_side();
  CHECK(take(side, bytes_of(kGoodAnswer + std::string{"\x82\x81\0\0\0\0x", 7}), 1).empty());
  REQUIRE(side.failure());
  CHECK(side.failure()->kind == Failure::Kind::violation);
  Bytes close;
  side.append_control(close, {});
  CHECK(Bytes{close.end() - 2, close.end()} == Bytes{std::byte{3}, std::byte{0xEA}});  // 1002
}
