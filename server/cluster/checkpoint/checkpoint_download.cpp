#include "cluster/checkpoint/checkpoint_download.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <utility>

#include <curl/curl.h>
#include <fmt/format.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

/// Maximum read ahead from the socket.
constexpr std::size_t kHeldBytes = std::size_t{1} << 20U;
constexpr std::size_t kReasonBytes = 300;
constexpr long kConnectMs = 5'000;
constexpr long kMinBytesPerSecond = 16'384;
constexpr int kPollMs = 1'000;
constexpr long kOk = 200;

}  // namespace

/// Adapts libcurl's push interface to pull.
class CheckpointDownload::Transfer {
 public:
  explicit Transfer(const std::string& peer)
      : peer_{peer},
        easy_{::curl_easy_init(), ::curl_easy_cleanup},
        multi_{::curl_multi_init(), ::curl_multi_cleanup},
        headers_{nullptr, ::curl_slist_free_all} {
    if (easy_ == nullptr || multi_ == nullptr) throw std::bad_alloc{};
  }
  ~Transfer() { ::curl_multi_remove_handle(multi_.get(), easy_.get()); }
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;

  [[nodiscard]] tl::expected<void, PeerRefusal> begin(const PeerAccess& access) {
    const auto set = [this](CURLoption option, auto value) {
      // A failed option must not fall back to curl's default.
      if (::curl_easy_setopt(easy_.get(), option, value) != CURLE_OK) sound_ = false;
    };
    set(CURLOPT_URL, (peer_ + "/store/checkpoint").c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_NOPROXY, "*");
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_HTTP_VERSION, long{CURL_HTTP_VERSION_1_1});
    set(CURLOPT_SSLVERSION, long{CURL_SSLVERSION_TLSv1_3});
    set(CURLOPT_CONNECTTIMEOUT_MS, kConnectMs);
    set(CURLOPT_LOW_SPEED_LIMIT, kMinBytesPerSecond);
    set(CURLOPT_LOW_SPEED_TIME, static_cast<long>(access.patience.count()));
    set(CURLOPT_BUFFERSIZE, 256L << 10);
    set(CURLOPT_ERRORBUFFER, error_.data());
    set(CURLOPT_WRITEDATA, this);
    set(CURLOPT_WRITEFUNCTION, &Transfer::take);
    const auto set_pem = [&](CURLoption option, const std::string& pem) {
      if (pem.empty()) return;
      curl_blob blob{const_cast<char*>(pem.data()), pem.size(), CURL_BLOB_COPY};
      set(option, &blob);
    };
    set_pem(CURLOPT_CAINFO_BLOB, access.ca);
    set_pem(CURLOPT_SSLCERT_BLOB, access.certificate);
    set_pem(CURLOPT_SSLKEY_BLOB, access.key);
    if (!access.token.empty()) {
      headers_.reset(
          ::curl_slist_append(nullptr, fmt::format("Authorization: Bearer {}", access.token).c_str()));
      if (headers_ == nullptr) throw std::bad_alloc{};
      set(CURLOPT_HTTPHEADER, headers_.get());
    }
    if (!sound_ || ::curl_multi_add_handle(multi_.get(), easy_.get()) != CURLM_OK) {
      return tl::unexpected{PeerRefusal{failed("libcurl refuses to ask it").value(), false}};
    }
    if (auto come = wait(); !come) return tl::unexpected{PeerRefusal{std::move(come.error()), false}};
    long status = 0;
    ::curl_easy_getinfo(easy_.get(), CURLINFO_RESPONSE_CODE, &status);
    const auto refused = [this](std::string_view why) {
      return tl::unexpected{PeerRefusal{failed(why).value(), true, aside()}};
    };
    if (status != kOk) return refused(fmt::format("it answers {}: {}", status, first_line()));
    curl_off_t length = -1;
    ::curl_easy_getinfo(easy_.get(), CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &length);
    if (length < 0) return refused("its answer has no length");
    size_ = static_cast<std::uint64_t>(length);
    return {};
  }

  [[nodiscard]] std::uint64_t size() const { return size_; }

  [[nodiscard]] tl::expected<std::string_view, std::string> read() {
    given_.clear();
    if (auto come = wait(); !come) return tl::unexpected{come.error()};
    given_.swap(held_);
    read_ += given_.size();
    return std::string_view{given_};
  }

 private:
  static std::size_t take(char* bytes, std::size_t one, std::size_t size, void* of) {
    auto& transfer = *static_cast<Transfer*>(of);
    if (transfer.held_.size() >= kHeldBytes) {
      transfer.paused_ = true;
      return CURL_WRITEFUNC_PAUSE;
    }
    try {
      transfer.held_.append(bytes, one * size);
    } catch (const std::bad_alloc&) {
      return 0;  // exceptions must not pass through libcurl, which fails on this value
    }
    return one * size;
  }

  /// Waits until bytes are held or all have arrived.
  [[nodiscard]] tl::expected<void, std::string> wait() {
    while (held_.empty() && !ended_) {
      if (std::exchange(paused_, false)) ::curl_easy_pause(easy_.get(), CURLPAUSE_CONT);
      int running = 0;
      if (::curl_multi_perform(multi_.get(), &running) != CURLM_OK) return failed("libcurl failed");
      int left = 0;
      while (const CURLMsg* const message = ::curl_multi_info_read(multi_.get(), &left)) {
        if (message->msg != CURLMSG_DONE) continue;
        ended_ = true;
        result_ = message->data.result;
      }
      if (held_.empty() && !ended_) ::curl_multi_poll(multi_.get(), nullptr, 0, kPollMs, nullptr);
    }
    if (!held_.empty() || result_ == CURLE_OK) return {};
    if (result_ == CURLE_PARTIAL_FILE || (result_ == CURLE_RECV_ERROR && size_ > 0)) {
      return failed(fmt::format("the connection ended after {} of {} bytes", read_, size_));
    }
    return failed(error_.front() != '\0' ? error_.data() : ::curl_easy_strerror(result_));
  }

  [[nodiscard]] std::optional<AsideStore> aside() const {
    curl_header* header = nullptr;
    if (::curl_easy_header(easy_.get(), kAsideHeader, 0, CURLH_HEADER, -1, &header) != CURLHE_OK) return {};
    return parse_aside(header->value);
  }
  [[nodiscard]] std::string first_line() const {
    const std::string_view text{held_};
    return escaped(text.substr(0, text.find('\n')), kReasonBytes);
  }
  [[nodiscard]] tl::unexpected<std::string> failed(std::string_view why) const {
    return tl::unexpected{fmt::format("{}: {}", peer_, on_one_line(why))};
  }

  const std::string peer_;
  std::unique_ptr<CURL, void (*)(CURL*)> easy_;
  std::unique_ptr<CURLM, CURLMcode (*)(CURLM*)> multi_;
  std::unique_ptr<curl_slist, void (*)(curl_slist*)> headers_;
  std::array<char, CURL_ERROR_SIZE> error_{};
  bool sound_ = true;
  bool paused_ = false;
  bool ended_ = false;
  CURLcode result_ = CURLE_OK;
  std::uint64_t size_ = 0;
  std::uint64_t read_ = 0;
  std::string held_;
  std::string given_;
};

CheckpointDownload::CheckpointDownload(std::unique_ptr<Transfer> transfer) : transfer_{std::move(transfer)} {}
CheckpointDownload::~CheckpointDownload() = default;

tl::expected<std::unique_ptr<CheckpointDownload>, PeerRefusal> CheckpointDownload::open(
    const std::string& peer, const PeerAccess& access) {
  auto transfer = std::make_unique<Transfer>(peer);
  if (auto begun = transfer->begin(access); !begun) return tl::unexpected{std::move(begun.error())};
  return std::unique_ptr<CheckpointDownload>{new CheckpointDownload{std::move(transfer)}};
}

std::uint64_t CheckpointDownload::size() const {
  return transfer_->size();
}

tl::expected<std::string_view, std::string> CheckpointDownload::read() {
  return transfer_->read();
}

}  // namespace talus::server
