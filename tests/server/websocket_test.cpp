#include <rapidcheck.h>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "loopback_stream.h"
#include "net/websocket/handshake.h"
#include "net/websocket/stream.h"
#include "websocket_frames.h"

#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>

using namespace talus::server;
using namespace talus::server::websocket;

namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span{text});
  return {bytes.begin(), bytes.end()};
}

/// What a reader gives of `input` in pieces of so many bytes.
struct ReadResult {
  std::string payload;
  std::string pings;
  End end = End::none;
  bool operator==(const ReadResult&) const = default;
};
ReadResult read(Bytes input, std::size_t piece) {
  FrameReader reader{talus::websocket::Sender::client};
  ReadResult all;
  for (std::size_t at = 0; at < input.size(); at += piece) {
    const auto part = std::span{input}.subspan(at, std::min(piece, input.size() - at));
    const std::size_t kept = reader.take(part);
    all.payload.append(reinterpret_cast<const char*>(part.data()), kept);
    if (reader.has_ping()) {
      all.pings.assign(reinterpret_cast<const char*>(reader.ping().data()), reader.ping().size());
    }
    reader.pop_ping();
  }
  all.end = reader.end();
  return all;
}

}  // namespace

TEST_CASE("Payloads of frames are bytes one after the other, however they are cut") {
  CHECK(rc::check([] {
    Bytes input;
    std::string payload;
    std::string last_ping;
    const int messages = *rc::gen::inRange(0, 6);
    for (int i = 0; i < messages; ++i) {
      const int parts = *rc::gen::inRange(1, 4);
      for (int part = 0; part < parts; ++part) {
        const auto size = *rc::gen::element<std::size_t>(0, 1, 5, 125, 126, 300, 70'000);
        const std::string text(size, static_cast<char>('a' + (i + part) % 26));
        append_client_frame(input, part == 0 ? 2 : 0, bytes_of(text), *rc::gen::arbitrary<std::uint32_t>(),
                            part + 1 == parts);
        payload += text;
        if (*rc::gen::inRange(0, 3) == 0) {
          last_ping = std::string(*rc::gen::inRange<std::size_t>(0, 126), static_cast<char>('A' + part));
          append_client_frame(input, 9, bytes_of(last_ping), *rc::gen::arbitrary<std::uint32_t>());
          append_client_frame(input, 10, bytes_of("unasked"), 7);
        }
      }
    }
    const auto piece = *rc::gen::element<std::size_t>(1, 2, 3, 7, 100, SIZE_MAX / 2);
    const ReadResult got = read(input, piece);
    RC_ASSERT(got.payload == payload);
    RC_ASSERT(got.pings == last_ping);
    RC_ASSERT(got.end == End::none);
  }));
}

TEST_CASE("A client that breaks the protocol gets the reason") {
  const auto [input, end] = GENERATE(table<std::vector<int>, End>({
      {{0x82, 0x01, 'a'}, End::not_masked},
      {{0xC2, 0x80, 0, 0, 0, 0}, End::reserved_bit},
      {{0x83, 0x80, 0, 0, 0, 0}, End::unknown_opcode},
      {{0x8B, 0x80, 0, 0, 0, 0}, End::unknown_opcode},
      {{0x81, 0x80, 0, 0, 0, 0}, End::text},
      {{0x80, 0x80, 0, 0, 0, 0}, End::lone_continuation},
      {{0x02, 0x80, 0, 0, 0, 0, 0x82, 0x80, 0, 0, 0, 0}, End::nested_message},
      {{0x82, 0xFF, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, End::too_long},
      {{0x09, 0x80, 0, 0, 0, 0}, End::fragmented_control},
      {{0x89, 0xFE, 0, 126, 0, 0, 0, 0}, End::long_control},
      {{0x82, 0xFE, 0, 125, 0, 0, 0, 0}, End::long_length},
      {{0x82, 0xFE, 0, 0, 0, 0, 0, 0}, End::long_length},
      {{0x82, 0xFF, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 0, 0}, End::long_length},
      {{0x89, 0xFE, 0, 5, 0, 0, 0, 0}, End::long_length},
      {{0x88, 0x81, 0, 0, 0, 0, 3}, End::malformed_close},
      {{0x88, 0x82, 0, 0, 0, 0, 3, 237}, End::bad_close_code},
      {{0x88, 0x83, 0, 0, 0, 0, 3, 232, 0xFF}, End::bad_close_reason},
      {{0x88, 0x80, 0, 0, 0, 0}, End::closed},
      {{0x88, 0x82, 0, 0, 0, 0, 3, 232, 1, 2, 3}, End::closed},
  }));
  Bytes bytes;
  for (const int each : input) bytes.push_back(static_cast<std::byte>(each));
  INFO(make_error_code(end).message());
  for (const std::size_t piece : {std::size_t{1}, std::size_t{5}, std::size_t{100}}) {
    CHECK(read(bytes, piece) == ReadResult{"", "", end});
  }
  CHECK_FALSE(make_error_code(end).message().empty());
}

TEST_CASE("A length in the fewest bytes is taken, whatever it is") {
  for (const std::size_t bytes : {125, 126, 0xFFFF, 0x10000}) {
    Bytes input;
    append_client_frame(input, 2, Bytes(bytes), 1);
    const ReadResult got = read(input, SIZE_MAX / 2);
    CHECK(got.end == End::none);
    CHECK(got.payload.size() == bytes);
  }
}

TEST_CASE("A Close has a code that may be sent, and a reason in UTF-8") {
  const auto end_of = [](int code, std::string_view reason) {
    Bytes payload{static_cast<std::byte>(code >> 8), static_cast<std::byte>(code)};
    for (const char c : reason) payload.push_back(static_cast<std::byte>(c));
    Bytes input;
    append_client_frame(input, 8, payload, 0x01020304);
    return read(input, 1).end;
  };
  for (const int code : {1000, 1001, 1002, 1003, 1007, 1008, 1011, 1012, 1014, 3000, 3999, 4000, 4999}) {
    INFO(code);
    CHECK(end_of(code, "") == End::closed);
  }
  for (const int code : {0, 999, 1004, 1005, 1006, 1015, 1016, 1100, 2000, 2999, 5000, 65'535}) {
    INFO(code);
    CHECK(end_of(code, "") == End::bad_close_code);
  }
  using namespace std::string_view_literals;
  for (const std::string_view reason : {"going home"sv, "bis sp\xC3\xA4ter"sv,
                                        "\xE2\x82\xAC \xF0\x9F\x8C\x8D"sv, "a\0b"sv, "\xF4\x8F\xBF\xBF"sv}) {
    CHECK(end_of(1000, reason) == End::closed);
  }
  // Cut, alone, too long for what they are, a surrogate, beyond the last code point, never in UTF-8.
  for (const std::string_view reason :
       {"a\xC3"sv, "\xE2\x82"sv, "\xA4"sv, "\xC0\x80"sv, "\xE0\x80\xAF"sv, "\xED\xA0\x80"sv,
        "\xF4\x90\x80\x80"sv, "\xF8\x88\x80\x80\x80"sv, "\xFF"sv, "\xC3\0"sv}) {
    CHECK(end_of(1000, reason) == End::bad_close_reason);
  }
  CHECK(close_code(End::bad_close_code) == talus::websocket::CloseCode::protocol_error);
  CHECK(close_code(End::malformed_close) == talus::websocket::CloseCode::protocol_error);
  CHECK(close_code(End::long_length) == talus::websocket::CloseCode::protocol_error);
  CHECK(static_cast<int>(close_code(End::bad_close_reason)) == 1007);
}

TEST_CASE("The largest length is waited for, and takes no memory") {
  Bytes input;
  for (const int each :
       std::vector<int>{0x82, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0, 'a', 'b'}) {
    input.push_back(static_cast<std::byte>(each));
  }
  CHECK(read(input, 3) == ReadResult{"ab", "", End::none});
}

namespace {

struct Socket {
  asio::io_context io{1};
  std::shared_ptr<Loopback> client = std::make_shared<Loopback>(io);
  WebSocketStream<LoopbackStream> stream;
  std::string got;
  std::error_code ended;
  std::array<std::byte, 64> input{};

  explicit Socket(std::string_view unread = {})
      : stream{LoopbackStream{client}, std::as_bytes(std::span{unread})} {
    asio::co_spawn(io, read(), asio::detached);
  }
  ~Socket() {
    stream.close();
    io.poll();
  }

  asio::awaitable<void> read() {
    while (!ended) {
      const std::size_t bytes = co_await stream.async_read_some(
          asio::buffer(input), asio::redirect_error(asio::use_awaitable, ended));
      got.append(reinterpret_cast<const char*>(input.data()), bytes);
    }
  }
  void send(const Bytes& bytes) {
    client->send(bytes);
    io.poll();
  }
  /// Starts writing; how much was written when it is done.
  std::shared_ptr<std::optional<std::size_t>> write(std::vector<std::string> pieces) {
    auto written = std::make_shared<std::optional<std::size_t>>();
    asio::co_spawn(
        io,
        [this, pieces = std::move(pieces), written]() -> asio::awaitable<void> {
          std::vector<asio::const_buffer> buffers;
          for (const std::string& piece : pieces) buffers.push_back(asio::buffer(piece));
          std::error_code failed;
          const std::size_t bytes =
              co_await asio::async_write(stream, buffers, asio::redirect_error(asio::use_awaitable, failed));
          if (!failed) *written = bytes;
        },
        asio::detached);
    io.poll();
    return written;
  }
};

}  // namespace

TEST_CASE("Bytes that came with the handshake are read first") {
  Bytes early;
  append_client_frame(early, 2, bytes_of(std::string(100, 'x')), 1);
  Socket socket{{reinterpret_cast<const char*>(early.data()), 30}};
  socket.send({early.begin() + 30, early.end()});
  CHECK(socket.got == std::string(100, 'x'));
}

TEST_CASE("Writes become frames, and Pongs come between them, never inside one") {
  for (const std::size_t each : {std::size_t{1}, std::size_t{3}, std::size_t{50}, SIZE_MAX}) {
    Socket socket;
    socket.client->write_bytes = each;
    socket.client->room = 20;  // the first write stays unfinished
    const auto written = socket.write({std::string(100, 'a'), std::string(200, 'b')});
    Bytes ping;
    append_client_frame(ping, 9, bytes_of("are you there"), 99);
    socket.send(ping);
    const auto second = socket.write({"c"});
    CHECK_FALSE(*written);
    socket.client->room = SIZE_MAX;
    socket.client->changed();
    socket.io.poll();
    REQUIRE(*written);
    REQUIRE(*second);
    const ServerFrames frames = read_server_frames(socket.client->received);
    CHECK(frames.whole);
    CHECK(frames.payload == std::string(100, 'a') + std::string(200, 'b') + "c");
    CHECK(frames.pongs == std::vector<std::string>{"are you there"});
  }
}

TEST_CASE("A client's Close is answered, and ends the stream") {
  Socket socket;
  Bytes input;
  append_client_frame(input, 2, bytes_of("last words"), 3);
  append_client_frame(input, 8, Bytes{std::byte{3}, std::byte{232}}, 3);
  socket.send(input);
  CHECK(socket.got == "last words");
  CHECK(socket.ended == make_error_code(End::closed));
  CHECK(read_server_frames(socket.client->received).close == 1000);
  const auto written = socket.write({"more"});
  CHECK_FALSE(*written);
}

TEST_CASE("A Close that comes while a frame is being written is answered behind it") {
  const auto [payload, end, code] = GENERATE(table<Bytes, End, int>({
      {Bytes{std::byte{3}, std::byte{232}}, End::closed, 1000},
      {Bytes{std::byte{3}}, End::malformed_close, 1002},
      {Bytes{std::byte{3}, std::byte{232}, std::byte{0xFF}}, End::bad_close_reason, 1007},
  }));
  Bytes input;
  append_client_frame(input, 8, payload, 3);
  for (const std::size_t each : {std::size_t{1}, std::size_t{3}, SIZE_MAX}) {
    Socket socket;
    socket.client->write_bytes = each;
    socket.client->room = 4;
    const auto first = socket.write({"some words"});
    socket.send(input);
    CHECK(socket.ended == make_error_code(end));
    CHECK_FALSE(*first);
    asio::co_spawn(socket.io, socket.stream.say_end(), asio::detached);
    socket.client->room = SIZE_MAX;
    socket.client->changed();
    socket.io.poll();
    CHECK(*first);
    CHECK(socket.client->said_end);
    const ServerFrames frames = read_server_frames(socket.client->received);
    CHECK(frames.whole);
    CHECK(frames.payload == "some words");
    CHECK(frames.close == code);
    CHECK_FALSE(*socket.write({"more"}));
  }
}

TEST_CASE("A session that sends a client its end waits no longer than the stream") {
  Bytes input;
  append_client_frame(input, 8, {}, 3);
  for (const bool fails : {false, true}) {
    Socket socket;
    socket.client->room = 4;
    (void)socket.write({"some words"});
    socket.send(input);
    asio::co_spawn(socket.io, socket.stream.say_end(), asio::detached);
    socket.io.poll();
    CHECK_FALSE(socket.client->said_end);
    if (fails) {
      socket.client->write_error = asio::error::connection_reset;
      socket.client->changed();
    } else {
      socket.stream.close();
    }
    socket.io.poll();
    CHECK(socket.client->said_end);
  }
}

TEST_CASE("The server's own end is a Close, behind what is being written") {
  Socket socket;
  socket.client->room = 4;
  const auto written = socket.write({"some words"});
  asio::co_spawn(socket.io, socket.stream.say_end(), asio::detached);
  socket.io.poll();
  CHECK_FALSE(socket.client->said_end);
  socket.client->room = SIZE_MAX;
  socket.client->changed();
  socket.io.poll();
  const ServerFrames frames = read_server_frames(socket.client->received);
  CHECK(*written);
  CHECK(frames.payload == "some words");
  CHECK(frames.close == 1000);
  CHECK(socket.client->said_end);
}
