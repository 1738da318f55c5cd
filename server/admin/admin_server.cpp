#include "admin/admin_server.h"

#include <exception>
#include <utility>

namespace talus::server {

AdminServer::AdminServer(const Clock& clock, Logger log)
    : log_{std::move(log)},
      acceptor_{io_, log_, clock},
      service_{clock, log_},
      connections_{service_, kMaxConnections} {}

AdminServer::~AdminServer() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
}

tl::expected<std::string, std::string> AdminServer::listen(const protocol::Endpoint& wanted) {
  return acceptor_.listen(wanted);
}

void AdminServer::start(OperatorAnswers answers) {
  connections_.set_handler(
      std::make_shared<http::FunctionHandler>([answers = std::move(answers)](const http::Request& request) {
        return answer_operator(request, answers);
      }));
  acceptor_.start([this]() -> asio::io_context& { return io_; },
                  [this](asio::ip::tcp::socket socket) { connections_.add(TcpStream{std::move(socket)}); },
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
