#include "admin/admin_server.h"

#include <chrono>
#include <exception>
#include <utility>

#include <restinio/all.hpp>

namespace talus::server {
namespace {

constexpr std::chrono::seconds kTimeToAsk{5};
constexpr std::size_t kMostUrlBytes = 1024;
constexpr std::size_t kMostFields = 64;
constexpr std::size_t kMostFieldBytes = 4096;

struct Traits : restinio::default_single_thread_traits_t {
  static constexpr bool use_connection_count_limiter = true;
};

restinio::request_handling_status_t answer(const restinio::request_handle_t& request,
                                           const AdminServer::Answers& answers) {
  const auto reply = [&](restinio::http_status_line_t status, const char* type, std::string body) {
    auto response = request->create_response(std::move(status));
    response.append_header(restinio::http_field::content_type, type);
    response.append_header(restinio::http_field::cache_control, "no-store");
    if (request->header().method() != restinio::http_method_head()) response.set_body(std::move(body));
    return response.done();
  };
  constexpr const char* kText = "text/plain; charset=utf-8";
  const auto method = request->header().method();
  if (method != restinio::http_method_get() && method != restinio::http_method_head()) {
    return reply(restinio::status_method_not_allowed(), kText, "only GET and HEAD are answered here\n");
  }
  const auto path = request->header().path();
  if (path == "/metrics") {
    return reply(restinio::status_ok(), "text/plain; version=0.0.4; charset=utf-8", answers.metrics());
  }
  if (path == "/-/healthy") return reply(restinio::status_ok(), kText, "healthy\n");
  if (path == "/-/ready") {
    return answers.ready() ? reply(restinio::status_ok(), kText, "ready\n")
                           : reply(restinio::status_service_unavailable(), kText, "draining\n");
  }
  return reply(restinio::status_not_found(), kText, "here are /metrics, /-/healthy and /-/ready\n");
}

}  // namespace

struct AdminServer::Http {
  using Server = restinio::http_server_t<Traits>;

  Http(asio::io_context& io, const asio::ip::tcp::endpoint& wanted, Answers answers)
      : server{
            restinio::external_io_context(io), [&](restinio::server_settings_t<Traits>& settings) {
              settings.address(wanted.address())
                  .port(wanted.port())
                  .protocol(wanted.protocol())
                  .max_parallel_connections(kMostConnections)
                  .read_next_http_message_timelimit(kTimeToAsk)
                  .handle_request_timeout(kTimeToAsk)
                  .write_http_response_timelimit(kTimeToAsk)
                  .incoming_http_msg_limits(restinio::incoming_http_msg_limits_t{}
                                                .max_url_size(kMostUrlBytes)
                                                .max_field_name_size(kMostFieldBytes)
                                                .max_field_value_size(kMostFieldBytes)
                                                .max_field_count(kMostFields)
                                                .max_body_size(0))
                  .acceptor_post_bind_hook(
                      [this](asio::ip::tcp::acceptor& acceptor) { address = acceptor.local_endpoint(); })
                  .request_handler([asked = std::move(answers)](const restinio::request_handle_t& request) {
                    return answer(request, asked);
                  });
            }} {}

  asio::ip::tcp::endpoint address;
  Server server;
};

AdminServer::AdminServer(std::unique_ptr<Http> http) : http_{std::move(http)} {}
AdminServer::AdminServer(AdminServer&&) noexcept = default;
AdminServer& AdminServer::operator=(AdminServer&&) noexcept = default;
AdminServer::~AdminServer() = default;

tl::expected<AdminServer, std::string> AdminServer::open(asio::io_context& io,
                                                         const asio::ip::tcp::endpoint& wanted,
                                                         Answers answers) {
  try {
    auto http = std::make_unique<Http>(io, wanted, std::move(answers));
    http->server.open_sync();
    return AdminServer{std::move(http)};
  } catch (const std::system_error& error) {
    return tl::make_unexpected(error.code().message());
  } catch (const std::exception& error) {
    return tl::make_unexpected(std::string{error.what()});
  }
}

const asio::ip::tcp::endpoint& AdminServer::address() const {
  return http_->address;
}

}  // namespace talus::server
