#include "admin/admin_server.h"

#include <exception>
#include <optional>
#include <system_error>
#include <utility>

#include <asio/post.hpp>

namespace talus::server {
namespace {

/// Serves one connection.
class OperatorHandler final : public http::Handler {
 public:
  OperatorHandler(const std::shared_ptr<const OperatorAnswers>& answers, std::string address)
      : answers_{answers}, address_{std::move(address)} {}

  std::optional<http::Response> respond_now(const http::Request& request,
                                            Clock::time_point /*came*/) override {
    if (request.path() == kCheckpointPath && answers_->checkpoint) return std::nullopt;
    return answer_operator(request, *answers_);
  }
  asio::awaitable<http::Response> respond(const http::Request& request) override {
    const auto kept = answers_;
    co_return co_await kept->checkpoint(request, address_);
  }

 private:
  const std::shared_ptr<const OperatorAnswers>& answers_;  // the current answers
  const std::string address_;
};

std::string address_of(const asio::ip::tcp::socket& socket) {
  std::error_code gone;
  const auto peer = socket.remote_endpoint(gone);
  return gone ? "an address that is gone" : peer.address().to_string();
}

}  // namespace

AdminServer::AdminServer(const Clock& clock, Logger log)
    : log_{std::move(log)},
      acceptor_{io_, log_, clock},
      service_{clock, log_},
      connections_{service_, kMaxConnections} {}

AdminServer::~AdminServer() {
  stop();
}

void AdminServer::stop() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
}

void AdminServer::on_connection(asio::ip::tcp::socket socket) {
  auto handler = std::make_shared<OperatorHandler>(answers_, address_of(socket));
  connections_.add(TcpStream{std::move(socket)}, std::move(handler));
}

tl::expected<std::string, std::string> AdminServer::listen(const protocol::Endpoint& wanted) {
  return acceptor_.listen(wanted);
}

void AdminServer::start(OperatorAnswers answers) {
  auto asked = std::make_shared<const OperatorAnswers>(std::move(answers));
  if (thread_.joinable()) {
    asio::post(io_, [this, changed = std::move(asked)] { answers_ = changed; });
    return;
  }
  answers_ = std::move(asked);
  acceptor_.start([this]() -> asio::io_context& { return io_; },
                  [this](asio::ip::tcp::socket socket) { on_connection(std::move(socket)); },
                  [this] { return connections_.make_room(); });
  thread_ = std::thread{[this] { run(); }};
}

void AdminServer::run() {
  while (!io_.stopped()) {
    try {
      io_.run();
    } catch (const std::exception& error) {
      log_->error("the operators' server: a handler failed: {}", error.what());
    }
  }
}

}  // namespace talus::server
