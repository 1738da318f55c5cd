#include "run.h"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>

#include <talus/progress/progress_bar.h>
#include "worker.h"

namespace talus::load {
namespace {

constexpr double kIdleJoinsPerSecond = 2000;
constexpr std::chrono::seconds kIdleTimeout{60};
constexpr std::chrono::milliseconds kPollInterval{100};
constexpr std::chrono::seconds kServerSettles{3};
constexpr std::uint64_t kSpareFiles = 64;

Clock::duration seconds(double count) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(count));
}

double own_cpu_seconds() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto in_seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
}

tl::expected<void, std::string> raise_file_limit(std::uint64_t needed) {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur >= needed) return {};
  limit.rlim_cur = needed;
  limit.rlim_max = std::max(limit.rlim_max, needed);  // if permitted
  if (::setrlimit(RLIMIT_NOFILE, &limit) == 0) return {};
  return tl::unexpected{
      fmt::format("{} open files are needed and the system allows fewer; raise ulimit -n", needed)};
}

std::vector<ClientProfile> profiles_of(const Plan& plan) {
  const Options& options = plan.options;
  std::vector<ClientProfile> profiles;
  const auto add = [&](Role role, std::uint32_t group, Clock::duration joins_after) {
    ClientProfile profile{role, static_cast<std::uint32_t>(profiles.size()), group, joins_after,
                          std::nullopt};
    if (options.from_addresses > 1) {
      constexpr std::uint32_t kLoopback = 0x7F000001;
      profile.from = asio::ip::address_v4{kLoopback + profile.number % options.from_addresses};
    }
    profiles.push_back(profile);
  };
  const auto group_of = [&](std::uint32_t client) {
    return options.groups != 0 ? client % options.groups : client;
  };
  const std::vector<Role> models = deal(options.mix, options.players);
  for (std::uint32_t i = 0; i < options.players; ++i) {
    const Role role = options.builds() ? Role::build : options.in_flight != 0 ? Role::requests : models[i];
    add(role, group_of(i), seconds(options.ramp_up_seconds * i / options.players));
  }
  std::uint32_t client = options.players;
  for (std::uint32_t i = 0; i < options.slow; ++i) add(Role::slow, group_of(client++), {});
  for (std::uint32_t i = 0; i < options.greedy; ++i) add(Role::greedy, group_of(client++), {});
  for (std::uint32_t i = 0; i < options.idle; ++i) add(Role::idle, 0, seconds(i / kIdleJoinsPerSecond));
  return profiles;
}

class Run {
 public:
  explicit Run(const Plan& plan)
      : plan_{plan}, watch_{plan.options.metrics, plan.options.server_pid}, signals_{io_, SIGINT, SIGTERM} {
    for (std::uint32_t number = 0; number < plan.options.threads; ++number) {
      workers_.push_back(std::make_unique<Worker>(plan, number));
    }
    const auto profiles = profiles_of(plan);
    for (const ClientProfile& profile : profiles) {
      const std::uint32_t together = profile.role == Role::build ? profile.group : profile.number;
      workers_[together % workers_.size()]->add(profile);
    }
    signals_.async_wait(
        [this](std::error_code cancelled, int) { interrupted_ = interrupted_ || !cancelled; });
  }

  tl::expected<RunResult, std::string> go() {
    if (watch_.watches())
      wait_until(Clock::now() + kPollInterval);  // until the probe's disconnect is
                                                 // visible
    auto before = watch_.sample();
    if (!before) return tl::unexpected{before.error()};
    result_.before = *before;
    for (const auto& worker : workers_) worker->run();
    if (plan_.options.idle > 0) {
      if (const auto joined = join_idle(); !joined) return tl::unexpected{joined.error()};
    }
    measure();
    leave();
    return std::move(result_);
  }

 private:
  template <typename Field>
  [[nodiscard]] std::uint64_t sum(Field field) const {
    std::uint64_t all = 0;
    for (const auto& worker : workers_) all += (worker->live().*field).load(std::memory_order_relaxed);
    return all;
  }

  tl::expected<void, std::string> join_idle() {
    const std::uint64_t idle = plan_.options.idle;
    const Time start = Clock::now();
    for (const auto& worker : workers_) worker->begin(true, start, Time::max());
    ProgressBar progress{"idle", "connections"};
    while (sum(&Live::joined) < idle && Clock::now() < start + kIdleTimeout && !interrupted_) {
      wait_until(Clock::now() + kPollInterval);
      progress.show(static_cast<double>(sum(&Live::joined)) / static_cast<double>(idle), sum(&Live::joined));
    }
    result_.idle_joined = sum(&Live::joined);
    if (result_.idle_joined < idle && !interrupted_) {
      return tl::unexpected{
          fmt::format("only {} of {} idle connections were taken; the server's limits.connections and "
                      "limits.connections_per_address must allow them (--from-addresses spreads them)",
                      result_.idle_joined, idle)};
    }
    result_.idle = watch_.sample().value_or(ServerSample{});
    return {};
  }

  void measure() {
    const Options& options = plan_.options;
    start_ = Clock::now();
    if (!options.warm_up_seconds) result_.begin = moment();  // before players that join at once are served
    const Time first_join = Clock::now() + std::chrono::milliseconds{10};
    const Time from = options.warm_up_seconds
                          ? first_join + seconds(options.ramp_up_seconds + *options.warm_up_seconds)
                          : first_join;
    const Time end = from + seconds(options.seconds);
    for (const auto& worker : workers_) worker->begin(false, first_join, from);
    ProgressBar progress{"load", "chunks"};
    watch_rates();
    watch_progress(progress, from, end);
    if (options.warm_up_seconds) result_.begin = moment();
    result_.resident_bytes.clear();
    measures_ = true;
    watch_progress(progress, end, end);
    result_.end = moment();
    result_.interrupted = interrupted_;
    for (const auto& worker : workers_) worker->finish(Clock::now() + seconds(options.drain_seconds));
  }

  /// Models of the advertised rates, scaled by the number of clients that share each.
  void watch_rates() {
    const Options& options = plan_.options;
    const auto& limits = plan_.world.limits;
    const double clients =
        std::max(1.0, static_cast<double>(options.players + options.slow + options.greedy));
    const auto add = [&](const std::string& name, const std::optional<client::Rates>& rates, double share) {
      if (!rates) return;
      result_.rates.emplace("rates." + name + "_chunks", RateModel{rates->chunks, rates->burst});
      result_.rates.emplace("rates." + name + "_bytes", RateModel{rates->bytes, rates->burst});
      shares_[name] = share;
    };
    add("session", limits.session_rates, 1 / clients);
    add("address", limits.address_rates, 1 / std::min<double>(options.from_addresses, clients));
    rates_seen_ = {Clock::now(), sum(&Live::chunks), sum(&Live::bytes)};
  }

  void add_to_rates() {
    const RateSample now{Clock::now(), sum(&Live::chunks), sum(&Live::bytes)};
    const double passed = std::chrono::duration<double>(now.at - rates_seen_.at).count();
    for (const auto& [name, share] : shares_) {
      const auto add = [&, &name = name, &share = share](const char* of, std::uint64_t count) {
        result_.rates.at("rates." + name + of).add(passed, static_cast<double>(count) * share, measures_);
      };
      add("_chunks", now.chunks - rates_seen_.chunks);
      add("_bytes", now.bytes - rates_seen_.bytes);
    }
    rates_seen_ = now;
  }

  void watch_progress(ProgressBar& progress, Time until, Time end) {
    while (Clock::now() < until && !interrupted_) {
      const std::uint64_t chunks_before = sum(&Live::chunks) + sum(&Live::uniform);
      const Time sampled = Clock::now();
      wait_until(std::min(until, sampled + kPollInterval * 5));
      const Time now = Clock::now();
      add_to_rates();
      const std::uint64_t chunks = sum(&Live::chunks) + sum(&Live::uniform);
      const auto troubles = sum(&Live::troubles);
      const auto sample = watch_.sample();
      if (sample && sample->resident_bytes) result_.resident_bytes.push_back(*sample->resident_bytes);
      progress.show(
          std::chrono::duration<double>(now - start_) / std::chrono::duration<double>(end - start_), chunks,
          fmt::format("now {:.0f}/s  {} clients{}",
                      static_cast<double>(chunks - chunks_before) /
                          std::max(1e-3, std::chrono::duration<double>(now - sampled).count()),
                      sum(&Live::joined), troubles == 0 ? "" : fmt::format("  {} troubles", troubles)));
    }
  }

  [[nodiscard]] Moment moment() const {
    return {std::chrono::duration<double>(Clock::now() - start_).count(),
            sum(&Live::chunks),
            sum(&Live::uniform),
            sum(&Live::bytes),
            sum(&Live::edits),
            own_cpu_seconds(),
            watch_.sample().value_or(ServerSample{})};
  }

  void leave() {
    for (const auto& worker : workers_) worker->join();
    if (plan_.published != nullptr) plan_.published->stop();  // it posts to the workers
    for (const auto& worker : workers_) {
      for (std::size_t role = 0; role < kRoles; ++role) result_.tallies[role].merge(worker->tallies()[role]);
      result_.lateness.merge(worker->lateness());
    }
    workers_.clear();
    if (!watch_.watches()) return;
    // The server takes a moment to notice that they left.
    const Time deadline = Clock::now() + kServerSettles;
    do {
      wait_until(Clock::now() + kPollInterval);
      result_.after = watch_.sample().value_or(ServerSample{});
    } while (result_.after.open_files.value_or(0) > result_.before.open_files.value_or(0) &&
             Clock::now() < deadline);
  }

  void wait_until(Time when) {
    io_.restart();
    asio::steady_timer timer{io_, when};
    bool over = false;
    timer.async_wait([&](std::error_code) { over = true; });
    while (!over && !interrupted_) io_.run_one();
    timer.cancel();
    while (!over) io_.run_one();
  }

  const Plan& plan_;
  ServerWatch watch_;
  asio::io_context io_{1};
  asio::signal_set signals_;
  bool interrupted_ = false;
  std::vector<std::unique_ptr<Worker>> workers_;
  Time start_{};
  struct RateSample {
    Time at{};
    std::uint64_t chunks = 0, bytes = 0;
  };
  RateSample rates_seen_;
  std::map<std::string, double> shares_;  // share of all arrivals, by scope of the rate
  bool measures_ = false;
  RunResult result_;
};

}  // namespace

tl::expected<RunResult, std::string> run(const Plan& plan) {
  const Options& options = plan.options;
  const std::uint64_t clients = std::uint64_t{options.players} + options.slow + options.greedy + options.idle;
  if (const auto raised = raise_file_limit(clients + kSpareFiles); !raised)
    return tl::unexpected{raised.error()};
  return Run{plan}.go();
}

}  // namespace talus::load
