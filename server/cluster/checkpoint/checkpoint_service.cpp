#include "cluster/checkpoint/checkpoint_service.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/co_spawn.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/store/store_swap.h>

#include "config/access/auth_failure.h"
#include "net/admission.h"
#include "net/http/body_source.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

/// Downloads with a lower overall rate are cut off.
constexpr std::uint64_t kMinRate = std::uint64_t{1} << 20U;
constexpr std::chrono::seconds kGrace{60};
constexpr std::chrono::seconds kBetweenComplaints{1};
constexpr std::chrono::milliseconds kRateBurst{100};

http::Response refusal(int status, std::string text, std::vector<http::Field> fields = {}) {
  return {status, http::kPlainText, std::move(text) + "\n", std::move(fields)};
}

}  // namespace

/// A checkpoint being sent. It counts against kMaxAtOnce until it ends or gives way.
class CheckpointService::Body final : public http::BodySource {
 public:
  Body(CheckpointService& service, std::string who, FlowId flow, FlowShares::GiveWay close)
      : service_{service},
        who_{std::move(who)},
        begun_{service.parts_.clock.now()},
        place_{service.places_, flow, 1, begun_} {
    place_.set_give_way(std::move(close));
    service_.parts_.metrics.checkpoints_open.rise();
  }
  ~Body() override {
    service_.parts_.metrics.checkpoints_open.fall();
    if (tar_ == nullptr) return;
    const double seconds = std::chrono::duration<double>(service_.parts_.clock.now() - begun_).count();
    const bool whole = sent_ == tar_->size();
    if (whole) service_.parts_.metrics.checkpoints_sent.add();
    service_.log_->log(whole ? LogLevel::info : LogLevel::warn,
                       "checkpoint to {}: {} of {} bytes in {:.1f} s{}, position {}, revision {}", who_,
                       sent_, tar_->size(), seconds, whole ? "" : ", cut off", tar_->head().position,
                       tar_->head().revision);
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  void send(std::unique_ptr<CheckpointTar> tar) {
    tar_ = std::move(tar);
    const std::uint64_t limit = service_.wanted_rate_;
    const std::uint64_t least = limit == 0 ? kMinRate : std::min(kMinRate, limit / 8 + 1);
    deadline_ = service_.parts_.clock.now() + kGrace + std::chrono::seconds{tar_->size() / least};
  }

  std::uint64_t size() const override { return tar_->size(); }

  asio::awaitable<std::string_view> next() override {
    asio::steady_timer timer{co_await asio::this_coro::executor};
    for (auto pause = service_.wait(); pause > pause.zero(); pause = service_.wait()) {
      timer.expires_after(pause);
      co_await timer.async_wait(asio::use_awaitable);
    }
    if (service_.parts_.clock.now() > deadline_) {
      throw std::runtime_error{fmt::format("checkpoint to {}: the peer reads too slowly", who_)};
    }
    const auto piece = co_await asio::co_spawn(
        service_.disk_,
        [tar = tar_.get()]() -> asio::awaitable<tl::expected<std::string_view, std::string>> {
          co_return tar->next();
        },
        asio::use_awaitable);
    if (!piece) throw std::runtime_error{fmt::format("checkpoint to {}: {}", who_, piece.error())};
    sent_ += piece->size();
    service_.spend(piece->size());
    service_.parts_.metrics.checkpoint_bytes_sent.add(piece->size());
    co_return *piece;
  }

 private:
  CheckpointService& service_;
  const std::string who_;
  const Clock::time_point begun_;
  FlowShares::Part place_;
  Clock::time_point deadline_;
  std::unique_ptr<CheckpointTar> tar_;
  std::uint64_t sent_ = 0;
};

CheckpointService::CheckpointService(Parts parts, std::uint64_t bytes_per_second, Logger log)
    : parts_{std::move(parts)},
      log_{std::move(log)},
      wanted_rate_{bytes_per_second},
      rate_{Rate::with_burst_of(bytes_per_second, kRateBurst)} {
  try {
    for (std::size_t i = 0; i < kMaxAtOnce; ++i) threads_.emplace_back([this] { disk_.run(); });
  } catch (...) {
    disk_.stop();
    throw;
  }
}

CheckpointService::~CheckpointService() {
  stop();
}

void CheckpointService::stop() {
  disk_work_.reset();
  threads_.clear();
}

FlowId CheckpointService::flow_of(const std::string& address) const {
  std::error_code gone;
  return flow_id_of(counted_as(asio::ip::make_address(address, gone)), flows_);
}

tl::expected<std::string, http::Response> CheckpointService::admit(const http::Request& request,
                                                                   const std::string& address) {
  const auto refuse = [&](int status, const std::string& text, std::vector<http::Field> fields = {}) {
    parts_.metrics.checkpoints_refused.add();
    if (const auto now = parts_.clock.now(); now >= next_complaint_) {
      next_complaint_ = now + kBetweenComplaints;
      log_->warn("checkpoint to {}: refused: {}", address, text);
    }
    return tl::unexpected{refusal(status, text, std::move(fields))};
  };
  if (request.method != http::Method::get) {
    return refuse(405, "only GET is answered here", {{"Allow", "GET"}});
  }
  if (!parts_.access.has_keys()) {
    return refuse(403,
                  "this server has no keys, so its store cannot be taken; set access.signing_key_file, or "
                  "access.secret_file with access.secret_rights \"read,edit,admin\"");
  }
  const auto grant = parts_.access.admit(request.bearer_token(), parts_.clock.wall());
  if (!grant) {
    parts_.metrics.denied(grant.error().failure).add();
    return refuse(401, grant.error().text(), {{"WWW-Authenticate", "Bearer"}});
  }
  if (!grant->rights.has(Right::admin)) {
    return refuse(403, "the token lacks the right admin, which taking a store requires");
  }
  if (places_.size() >= kMaxAtOnce && !places_.make_room(flow_of(address), 1, 0, parts_.clock.now())) {
    return refuse(503, fmt::format("{} servers take this store already", kMaxAtOnce),
                  {{"Retry-After", "10"}});
  }
  return grant->subject.empty() ? address : fmt::format("{}, {}", address, escaped(grant->subject, 100));
}

tl::expected<std::unique_ptr<CheckpointTar>, std::string> CheckpointService::make(
    std::uint64_t number) const {
  const fs::path path = store::checkpoint_path(parts_.directory, fmt::format("http-{}", number));
  if (const auto made = store::make_checkpoint(path, store::kCheckpointCopiesBytes, parts_.make); !made) {
    return tl::unexpected{made.error()};
  }
  auto tar = CheckpointTar::open(path);
  std::error_code ignored;
  if (!tar) fs::remove_all(path, ignored);
  return tar;
}

asio::awaitable<http::Response> CheckpointService::respond(const http::Request& request,
                                                           const std::string& address,
                                                           FlowShares::GiveWay close) {
  auto who = admit(request, address);
  if (!who) co_return std::move(who.error());
  auto body = std::make_shared<Body>(*this, *std::move(who), flow_of(address), std::move(close));
  auto tar = co_await asio::co_spawn(
      disk_,
      [this, number = next_number_++]()
          -> asio::awaitable<tl::expected<std::unique_ptr<CheckpointTar>, std::string>> {
        co_return make(number);
      },
      asio::use_awaitable);
  if (!tar) {
    log_->error("checkpoint to {}: {}", address, tar.error());
    co_return refusal(503, "the server cannot make a checkpoint now; its log says more",
                      {{"Retry-After", "10"}});
  }
  body->send(*std::move(tar));
  http::Response response{200, "application/x-tar"};
  response.source = std::move(body);
  co_return response;
}

void CheckpointService::follow_rate() {
  const Rate wanted = Rate::with_burst_of(wanted_rate_, kRateBurst);
  if (wanted == rate_) return;
  bucket_ = bucket_.moved(rate_, wanted, parts_.clock.now());
  rate_ = wanted;
}

std::chrono::nanoseconds CheckpointService::wait() {
  follow_rate();
  return bucket_.wait(rate_, parts_.clock.now());
}

void CheckpointService::spend(std::uint64_t bytes) {
  bucket_.spend(rate_, parts_.clock.now(), bytes);
}

}  // namespace talus::server
