#include <talus/client/client.h>

#include <asio/associated_executor.hpp>
#include <asio/async_result.hpp>
#include <asio/post.hpp>
#include <asio/use_awaitable.hpp>

#include "core.h"

namespace talus::client {
namespace {

// Wraps a callback function as a coroutine. `start` is called with a callback; the coroutine resumes by post,
// never inside the call of that callback.
template <typename T, typename Start>
asio::awaitable<Result<T>> awaited(Start start) {
  constexpr auto kToken = asio::use_awaitable;
  auto initiate = [&start](auto handler) {
    const auto shared = std::make_shared<decltype(handler)>(std::move(handler));
    start([shared](Result<T> result) {
      const auto executor = asio::get_associated_executor(*shared);
      asio::post(executor, [shared, result = std::move(result)]() mutable { (*shared)(std::move(result)); });
    });
  };
  co_return co_await asio::async_initiate<const asio::use_awaitable_t<>, void(Result<T>)>(initiate, kToken);
}

}  // namespace

Client::Client(asio::any_io_executor executor, Options options, Events events)
    : core_{std::make_shared<Core>(std::move(executor), std::move(options), std::move(events))} {}

Client::~Client() {
  if (core_) core_->close();
}

Client::Client(Client&&) noexcept = default;

Client& Client::operator=(Client&& other) noexcept {
  if (this != &other) {
    if (core_) core_->close();
    core_ = std::move(other.core_);
  }
  return *this;
}

void Client::connect(std::string host, std::string port, std::function<void(Result<WorldInfo>)> handler) {
  core_->connect(std::move(host), std::move(port), std::move(handler));
}

asio::awaitable<Result<WorldInfo>> Client::connect(std::string host, std::string port) {
  return awaited<WorldInfo>([core = core_, host = std::move(host), port = std::move(port)](auto handler) {
    core->connect(host, port, std::move(handler));
  });
}

bool Client::connected() const {
  return core_->connected();
}

const WorldInfo* Client::world() const {
  return core_->world();
}

RequestId Client::get(ChunkKey key, std::optional<ContentHash> known,
                      std::function<void(Result<ReceivedChunk>)> handler) {
  return core_->get(key, known, std::move(handler));
}

asio::awaitable<Result<ReceivedChunk>> Client::get(ChunkKey key, std::optional<ContentHash> known) {
  return awaited<ReceivedChunk>(
      [core = core_, key, known](auto handler) { (void)core->get(key, known, std::move(handler)); });
}

void Client::cancel(RequestId request) {
  core_->cancel(request);
}

void Client::get_heights(std::vector<Column> columns,
                         std::function<void(Result<std::vector<std::int32_t>>)> handler) {
  core_->get_heights(std::move(columns), std::move(handler));
}

asio::awaitable<Result<std::vector<std::int32_t>>> Client::get_heights(std::vector<Column> columns) {
  return awaited<std::vector<std::int32_t>>([core = core_, columns = std::move(columns)](auto handler) {
    core->get_heights(columns, std::move(handler));
  });
}

void Client::get_places(std::vector<Column> columns, std::vector<std::string> fields,
                        std::function<void(Result<ColumnPlaces>)> handler) {
  core_->get_places(std::move(columns), std::move(fields), std::move(handler));
}

asio::awaitable<Result<ColumnPlaces>> Client::get_places(std::vector<Column> columns,
                                                         std::vector<std::string> fields) {
  return awaited<ColumnPlaces>([core = core_, columns = std::move(columns), fields = std::move(fields)](
                                   auto handler) { core->get_places(columns, fields, std::move(handler)); });
}

Result<void> Client::set_view(const View& view) {
  return core_->set_view(view);
}

void Client::edit(Edit edit, std::function<void(Result<EditDone>)> handler) {
  core_->edit(std::move(edit), std::move(handler));
}

asio::awaitable<Result<EditDone>> Client::edit(Edit edit) {
  return awaited<EditDone>(
      [core = core_, edit = std::move(edit)](auto handler) { core->edit(edit, std::move(handler)); });
}

void Client::ping(std::function<void(Result<std::chrono::nanoseconds>)> handler) {
  core_->ping(std::move(handler));
}

asio::awaitable<Result<std::chrono::nanoseconds>> Client::ping() {
  return awaited<std::chrono::nanoseconds>([core = core_](auto handler) { core->ping(std::move(handler)); });
}

void Client::close() {
  core_->close();
}

const Stats& Client::stats() const {
  return core_->stats();
}

bool Client::generates() const {
  return core_->generates();
}

}  // namespace talus::client
