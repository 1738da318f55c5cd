#include "admin/admin_server.h"

#include <exception>
#include <optional>
#include <system_error>
#include <utility>

#include <asio/post.hpp>

#include "net/address_text.h"
#include "net/admission.h"

namespace talus::server {
namespace {

/// Serves one connection.
class OperatorHandler final : public http::Handler {
 public:
  OperatorHandler(const std::shared_ptr<const OperatorAnswers>& answers, std::string address,
                  asio::any_io_executor executor)
      : answers_{answers}, address_{std::move(address)}, executor_{std::move(executor)} {}

  std::optional<http::Response> respond_now(const http::Request& request,
                                            Clock::time_point /*came*/) override {
    if (request.path() == kCheckpointPath && answers_->checkpoint) return std::nullopt;
    return answer_operator(request, *answers_);
  }
  asio::awaitable<http::Response> respond(const http::Request& request) override {
    const auto kept = answers_;
    // A variable: GCC 12 destroys a temporary twice here.
    const std::function<void()> close = [weak = connection_, executor = executor_] {
      asio::post(executor, [weak] {
        if (const auto alive = weak.lock()) alive->close();
      });
    };
    co_return co_await kept->checkpoint(request, address_, close);
  }
  /// Call before the first request.
  void set_connection(const std::shared_ptr<http::Connection<TcpStream>>& connection) {
    connection_ = connection;
  }

 private:
  const std::shared_ptr<const OperatorAnswers>& answers_;  // the current answers
  const std::string address_;
  const asio::any_io_executor executor_;
  std::weak_ptr<http::Connection<TcpStream>> connection_;
};

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
  std::error_code gone;
  const asio::ip::address peer = socket.remote_endpoint(gone).address();
  const auto handler = std::make_shared<OperatorHandler>(
      answers_, gone ? "an address that is gone" : address_text(peer), socket.get_executor());
  handler->set_connection(
      connections_.add(TcpStream{std::move(socket)}, handler, counted_as(peer).to_string()));
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
