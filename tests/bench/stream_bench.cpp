// The log of a cluster beside bare JetStream, in one run: three nats-servers on this machine, three replicas.
// bench_stream [acks|absence|kills|all] [SECONDS or KILLS]: acknowledgements at rates of edits; an absence
// read again; leaders killed under load.
// bench_stream bare SECONDS URLS STORE RATE PUBLISHERS: acknowledgements by libnats alone, of nats-servers
// that run already, in the stream of that store, which "talusd cluster init" has made and no talusd uses; the
// rate is that of all publishers, each with one message in flight, as a server has.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "cluster/jetstream/nats_handles.h"
#include "opened_stream.h"

namespace {

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kEditBytes = 60;  // of an edit in the log

double ms(Clock::duration time) {
  return std::chrono::duration<double, std::milli>{time}.count();
}

struct Times {
  std::vector<double> all_ms;
  [[nodiscard]] double at(double part) {
    if (all_ms.empty()) return 0;
    std::sort(all_ms.begin(), all_ms.end());
    return all_ms[std::min(all_ms.size() - 1,
                           static_cast<std::size_t>(part * static_cast<double>(all_ms.size())))];
  }
};

/// Publishes bytes and returns when they are acknowledged.
using Publish = std::function<bool(std::span<const std::byte>)>;

/// As a server publishes: one message in flight, and all edits that came meanwhile in the next. The time of
/// each message, and of each edit from when it came.
struct Measurement {
  Times of_messages;
  Times of_edits;
};

Measurement measure(std::uint64_t edits_a_second, std::chrono::seconds length, const Publish& publish) {
  Measurement measured;
  auto& [of_messages, of_edits] = measured;
  std::vector<std::byte> bytes(512U << 10U);
  const auto began = Clock::now();
  const auto came_at = [&](std::uint64_t edit) {
    return began + std::chrono::nanoseconds{edit * 1'000'000'000ULL / edits_a_second};
  };
  std::uint64_t next = 0;
  while (Clock::now() < began + length) {
    std::this_thread::sleep_until(came_at(next));
    const auto sends = Clock::now();
    std::uint64_t last = next;
    while (last - next < 1024 && came_at(last) <= sends) ++last;
    if (last == next) continue;
    const std::size_t size = std::min(bytes.size(), 100 + (last - next) * kEditBytes);
    if (!publish(std::span{bytes}.first(size))) continue;
    const auto done = Clock::now();
    of_messages.all_ms.push_back(ms(done - sends));
    for (; next < last; ++next) of_edits.all_ms.push_back(ms(done - came_at(next)));
  }
  return measured;
}

void print(const char* name, std::uint64_t edits_a_second, std::chrono::seconds length,
           Measurement measured) {
  auto& [of_messages, of_edits] = measured;
  fmt::print(
      "{:>12} {:>7}/s: {:>7.0f} messages/s, message p50 {:.2f} p99 {:.2f} ms; edit p50 {:.2f} p99 {:.2f} "
      "ms\n",
      name, edits_a_second,
      static_cast<double>(of_messages.all_ms.size()) / static_cast<double>(length.count()),
      of_messages.at(0.5), of_messages.at(0.99), of_edits.at(0.5), of_edits.at(0.99));
}

void at_rate(const char* name, std::uint64_t edits_a_second, std::chrono::seconds length,
             const Publish& publish) {
  print(name, edits_a_second, length, measure(edits_a_second, length, publish));
}

/// libnats by itself.
class Bare {
 public:
  Bare(const std::vector<std::string>& urls, std::string subject) : subject_{std::move(subject)} {
    natsOptions* made = nullptr;
    natsOptions_Create(&made);
    const NatsOptions options{made};
    std::vector<const char*> list;
    for (const auto& url : urls) list.push_back(url.c_str());
    natsOptions_SetServers(made, list.data(), static_cast<int>(list.size()));
    natsOptions_SetSendAsap(made, true);
    natsConnection* connection = nullptr;
    if (natsConnection_Connect(&connection, made) != NATS_OK) throw std::runtime_error{"no connection"};
    connection_.reset(connection);
    jsCtx* context = nullptr;
    if (natsConnection_JetStream(&context, connection, nullptr) != NATS_OK)
      throw std::runtime_error{"no JetStream"};
    context_.reset(context);
  }
  bool publish(std::span<const std::byte> bytes) {
    jsPubOptions options{};
    jsPubOptions_Init(&options);
    options.MaxWait = 500;
    jsPubAck* ack = nullptr;
    const natsStatus status = js_Publish(&ack, context_.get(), subject_.c_str(), bytes.data(),
                                         static_cast<int>(bytes.size()), &options, nullptr);
    const PublishAck owned{ack};
    return status == NATS_OK;
  }

 private:
  struct Destroy {
    void operator()(natsConnection* connection) const { natsConnection_Destroy(connection); }
  };
  std::string subject_;
  std::unique_ptr<natsConnection, Destroy> connection_;
  JetStreamContext context_;
};

/// Reads on a thread of its own, as a server does, until it is gone.
class Reader {
 public:
  explicit Reader(LogStream& log) : log_{log}, thread_{[this] { run(); }} {}
  ~Reader() {
    ends_ = true;
    log_.wake();
    thread_.join();
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

 private:
  void run() {
    for (std::uint64_t after = log_.state()->last; !ends_;) {
      const auto message = log_.next(after, Clock::now() + 100ms);
      if (message && *message) after = (*message)->sequence;
    }
  }
  LogStream& log_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

void acknowledgements(std::chrono::seconds length) {
  NatsServers servers;
  make_stream(servers, test_names(1), 3);
  make_stream(servers, test_names(2), 3);
  const auto log = open_log(servers.url_list(), test_names(1));
  Bare bare{servers.urls(), test_names(2).log};
  for (int turn = 0; turn < 2; ++turn) {
    for (const std::uint64_t rate : {1'000U, 10'000U}) {
      at_rate("bare libnats", rate, length, [&](auto bytes) { return bare.publish(bytes); });
      at_rate("JetStreamLog", rate, length, [&](auto bytes) { return log->publish(bytes).has_value(); });
      const Reader reader{*log};
      at_rate("and a reader", rate, length, [&](auto bytes) { return log->publish(bytes).has_value(); });
    }
  }
}

void absence() {
  NatsServers servers;
  make_stream(servers, test_names(), 3);
  const auto log = open_log(servers.url_list(), test_names());
  for (const std::size_t size : {700U, 10'000U, 100'000U}) {
    const std::uint64_t from = log->state()->last;
    const std::uint64_t messages = 20'000'000 / (size + 1'000);
    const std::vector<std::byte> bytes(size);
    for (std::uint64_t i = 0; i < messages;) i += log->publish(bytes) ? 1 : 0;
    const auto reader = open_log(servers.url_list(), test_names());
    const auto began = Clock::now();
    std::uint64_t after = from;
    const std::uint64_t last = log->state()->last;
    while (after < last) {
      const auto message = reader->next(after, Clock::now() + 1s);
      if (message && *message) ++after;
    }
    const double seconds = ms(Clock::now() - began) / 1000;
    fmt::print("absence: {} messages of {} bytes in {:.2f} s: {:.0f} messages/s, {:.1f} MB/s\n", last - from,
               size, seconds, static_cast<double>(last - from) / seconds,
               static_cast<double>((last - from) * size) / seconds / 1e6);
  }
}

void dead_leaders(int kills) {
  NatsServers servers;
  const StreamNames names = test_names();
  make_stream(servers, names, 3);
  const auto writer = open_log(servers.url_list(), names);
  std::atomic<bool> ends{false};
  std::atomic<std::int64_t> last_ack_ns{0};
  std::mutex mutex;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> acknowledged;  // number, sequence
  std::uint64_t republished = 0;
  std::thread publisher{[&] {
    for (std::uint64_t number = 1; !ends; ++number) {
      const std::string text = std::to_string(number) + std::string(600, ' ');
      while (!ends) {
        const auto sequence = writer->publish(bytes_of(text));
        if (sequence) {
          last_ack_ns = Clock::now().time_since_epoch().count();
          const std::lock_guard lock{mutex};
          acknowledged.emplace_back(number, *sequence);
          break;
        }
        ++republished;
        std::this_thread::sleep_for(20ms);
      }
    }
  }};
  std::vector<double> pauses;
  for (int i = 0; i < kills; ++i) {
    const std::size_t leader = servers.leader_of(names.stream);
    std::this_thread::sleep_for(300ms);  // under load
    servers.kill(leader);
    const auto killed = Clock::now();
    // The first acknowledgement of a message that was sent after it.
    while (last_ack_ns < (killed + 20ms).time_since_epoch().count()) std::this_thread::sleep_for(1ms);
    pauses.push_back(ms(Clock::time_point{Clock::duration{last_ack_ns.load()}} - killed) / 1000);
    servers.start(leader);
    servers.await_ready();
    servers.await_replicas(names.stream);
  }
  ends = true;
  publisher.join();
  // By another server, from the first on.
  const auto reader = open_log(servers.url_list(), names);
  const std::uint64_t last = writer->state()->last;
  std::vector<std::uint64_t> numbers;  // by sequence
  while (numbers.size() < last) {
    const auto message = reader->next(numbers.size(), Clock::now() + 1s);
    if (message && *message) numbers.push_back(std::stoull(text_of((*message)->bytes)));
  }
  std::uint64_t lost = 0;
  for (const auto& [number, sequence] : acknowledged) lost += numbers[sequence - 1] != number ? 1 : 0;
  std::uint64_t twice = 0;
  std::uint64_t disordered = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] == numbers[i - 1]) ++twice;
    if (numbers[i] < numbers[i - 1]) ++disordered;
  }
  std::sort(pauses.begin(), pauses.end());
  fmt::print(
      "leader killed {} times: {} acknowledged, {} lost, {} out of order, {} twice, {} published again; "
      "pause {:.2f} / {:.2f} / {:.2f} s (least, median, most)\n",
      kills, acknowledged.size(), lost, disordered, twice, republished, pauses.front(),
      pauses[pauses.size() / 2], pauses.back());
}

void bare_acknowledgements(std::chrono::seconds length, const std::string& urls, const std::string& store,
                           std::uint64_t rate, std::size_t publishers) {
  std::vector<std::string> list;
  for (const auto& url : urls_of(urls)) list.push_back(url);
  std::vector<Measurement> each(publishers);
  std::vector<std::thread> threads;
  for (Measurement& measured : each) {
    threads.emplace_back([&] {
      Bare bare{list, "talus." + store + ".log"};
      measured = measure(rate / publishers, length, [&](auto bytes) { return bare.publish(bytes); });
    });
  }
  for (std::thread& thread : threads) thread.join();
  Measurement all;
  for (const auto& [of_messages, of_edits] : each) {
    std::ranges::copy(of_messages.all_ms, std::back_inserter(all.of_messages.all_ms));
    std::ranges::copy(of_edits.all_ms, std::back_inserter(all.of_edits.all_ms));
  }
  print("bare libnats", rate, length, std::move(all));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "all";
  const int count = argc > 2 ? std::atoi(argv[2]) : 0;
  if (what == "bare") {
    if (argc != 7 || std::stoull(argv[6]) == 0) {
      fmt::print(stderr, "bench_stream bare: SECONDS, URLS, STORE, RATE and PUBLISHERS are wanted\n");
      return 2;
    }
    bare_acknowledgements(std::chrono::seconds{count}, argv[3], argv[4], std::stoull(argv[5]),
                          std::stoull(argv[6]));
    return 0;
  }
  if (what == "acks" || what == "all") acknowledgements(std::chrono::seconds{count > 0 ? count : 5});
  if (what == "absence" || what == "all") absence();
  if (what == "kills" || what == "all") dead_leaders(count > 0 ? count : 20);
}
