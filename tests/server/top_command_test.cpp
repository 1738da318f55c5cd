#include "admin/top_command.h"

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read_until.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "scratch_directory.h"

using namespace talus;
using namespace talus::server;
using asio::ip::tcp;

namespace {

tl::expected<TopCommand, Exit> top(std::vector<const char*> flags, const Environment& environment = {}) {
  flags.insert(flags.begin(), "top");
  return read_top_command(static_cast<int>(flags.size()), flags.data(), environment);
}

/// Answers one client, whatever it asks, and closes.
class OneAnswer {
 public:
  explicit OneAnswer(std::string answer) {
    thread_ = std::thread{[this, answer = std::move(answer)] {
      tcp::socket client = acceptor_.accept();
      std::error_code gone;
      asio::read_until(client, asio::dynamic_buffer(asked_), "\r\n\r\n", gone);
      asio::write(client, asio::buffer(answer), gone);
    }};
  }
  ~OneAnswer() {
    if (thread_.joinable()) thread_.join();
  }
  OneAnswer(const OneAnswer&) = delete;
  OneAnswer& operator=(const OneAnswer&) = delete;

  [[nodiscard]] protocol::Endpoint endpoint(const std::string& host = "127.0.0.1") const {
    return {host, acceptor_.local_endpoint().port()};
  }
  /// What the client asked; waits for it to be gone.
  [[nodiscard]] const std::string& asked() {
    thread_.join();
    return asked_;
  }

 private:
  asio::io_context io_;
  tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
  std::string asked_;
  std::thread thread_;
};

std::string with_length(std::size_t length, const std::string& body) {
  return "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(length) + "\r\nConnection: close\r\n\r\n" +
         body;
}

tl::expected<std::string, std::string> fetched(const std::string& answer) {
  const OneAnswer server{answer};
  return fetch_flows(server.endpoint());
}

}  // namespace

TEST_CASE("talusd top asks the flag's address, otherwise the settings'") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("talusd.toml", "admin = \"127.0.0.1:7\"\n");
  CHECK(to_string(top({"--admin", "[::1]:9"})->admin) == "[::1]:9");
  CHECK(to_string(top({"--config", file.c_str()})->admin) == "127.0.0.1:7");
  CHECK(to_string(top({"--config", file.c_str()}, {{"TALUS_ADMIN", "127.0.0.1:8"}})->admin) == "127.0.0.1:8");
  CHECK(top({"--admin", "a:1", "--interval", "60"})->interval.count() == 60);
}

TEST_CASE("wrong flags of talusd top are one line") {
  using Flags = std::vector<const char*>;
  const std::vector<std::pair<Flags, std::string>> wrong{
      {Flags{}, "give --admin HOST:PORT"},
      {Flags{"--admin", "nowhere"}, "--admin: \"nowhere\": "},
      {Flags{"--admin", "a:1", "--interval", "0"}, "--interval"},
      {Flags{"--config", "/no/such.toml"}, "/no/such.toml: "},
      {Flags{"--bytes"}, "--bytes"}};
  for (const auto& [flags, part] : wrong) {
    const auto command = top(flags);
    REQUIRE_FALSE(command.has_value());
    CHECK(command.error().status != 0);
    CHECK_THAT(command.error().text, Catch::StartsWith("talusd top: ") && Catch::Contains(part));
    CHECK(command.error().text.find('\n') == command.error().text.size() - 1);
  }
}

TEST_CASE("talusd top shows a page that came whole") {
  CHECK(fetched(with_length(10, "a row\n\nend\n")) == "a row\n\nend");
  CHECK(fetched(with_length(11, "a row\n\nend\n")) == "a row\n\nend\n");
  CHECK(fetched(with_length(0, "")) == "");
}

TEST_CASE("talusd top takes no part of an answer for the whole, and no answer without end") {
  const auto [answer, part] = GENERATE(table<std::string, std::string>(
      {{with_length(500, "a row\n"), ": answered only 6 of 500 bytes"},
       {with_length(std::size_t{3} << 20, std::string(std::size_t{3} << 20, 'x')),
        ": answered more than 1 MiB"},
       {std::string(std::size_t{3} << 20, 'x'), "is not the answer of a talusd"},
       {"HTTP/1.1 200 OK\r\n\r\na row\n", "is not the answer of a talusd"},
       {"HTTP/1.1 200 OK\r\nContent-Length: 1x\r\n\r\na", "is not the answer of a talusd"},
       {"HTTP/1.1 200 OK\r\nContent-Length: 7\r\n", "is not the answer of a talusd"},
       {"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n", "status 404 is not the answer"},
       {"", ": "}}));
  const auto page = fetched(answer);
  REQUIRE_FALSE(page.has_value());
  CHECK_THAT(page.error(), Catch::StartsWith("http://127.0.0.1:") && Catch::Contains(part));
}

TEST_CASE("talusd top prints no terminal commands, whatever the answer") {
  CHECK(fetched(with_length(12, "\x1b[2J\r\n\xc2\x9bm\xff\t\n")) == "\\x1b[2J\\x0d\n\\xc2\\x9bm\\xff\\x09\n");
}

TEST_CASE("talusd top gives up a name that takes too long, and asks a host by all its addresses") {
  const auto name = std::make_shared<std::promise<void>>();
  const auto never = [known = name->get_future().share()](const protocol::Endpoint&, std::error_code&) {
    known.wait();
    return std::vector<tcp::endpoint>{};
  };
  const auto page = fetch_flows({"slow.example", 4781}, std::chrono::milliseconds{1}, never);
  REQUIRE_FALSE(page.has_value());
  CHECK_THAT(page.error(),
             Catch::StartsWith("http://slow.example:4781/flows: ") && Catch::Contains("timed out"));
  name->set_value();

  OneAnswer server{with_length(1, "a")};
  const auto port = server.endpoint().port;
  const auto two = [port](const protocol::Endpoint&, std::error_code&) {
    return std::vector<tcp::endpoint>{{asio::ip::make_address("127.0.0.2"), port},
                                      {asio::ip::address_v4::loopback(), port}};
  };
  CHECK(fetch_flows({"two.example", port}, std::chrono::seconds{60}, two) == "a");

  const auto none = [](const protocol::Endpoint&, std::error_code& failed) {
    failed = asio::error::host_not_found;
    return std::vector<tcp::endpoint>{};
  };
  CHECK_THAT(fetch_flows({"no.example", port}, std::chrono::seconds{60}, none).error(),
             Catch::Contains("Host not found"));
}

TEST_CASE("talusd top names the host that it asks as URLs do") {
  OneAnswer server{with_length(0, "")};
  const protocol::Endpoint mapped =
      server.endpoint("::ffff:127.0.0.1");  // there also where the network has no IPv6
  REQUIRE(fetch_flows(mapped).has_value());
  CHECK_THAT(server.asked(),
             Catch::Contains("\r\nHost: [::ffff:127.0.0.1]:" + std::to_string(mapped.port) + "\r\n"));
}
