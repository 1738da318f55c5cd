// A thread with its clients. Everything but the functions that say otherwise is for the worker's own thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <queue>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "edit_site.h"
#include "plan.h"
#include "random.h"
#include "simulated_client.h"
#include "tally.h"

namespace talus::load {

/// What can be read while a worker runs, from any thread.
struct Live {
  std::atomic<std::uint64_t> chunks{0};  // Chunk messages
  std::atomic<std::uint64_t> uniform{0};
  std::atomic<std::uint64_t> bytes{0};   // all that was received
  std::atomic<std::uint64_t> joined{0};  // now, of all roles
  std::atomic<std::uint64_t> troubles{0};
  std::atomic<std::uint64_t> edits{0};  // acknowledged

  static void add(std::atomic<std::uint64_t>& counter, std::uint64_t count) {
    counter.store(counter.load(std::memory_order_relaxed) + count, std::memory_order_relaxed);
  }
};

class Worker {
 public:
  Worker(const Plan& plan, std::uint32_t number);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // ---- for the thread that made it
  /// Before run(). The client joins with others of its kind: idle ones first. All of a group that builds are
  /// of one worker.
  void add(const ClientProfile& profile);
  void run();
  /// Clients of role idle, or all others, join: the n-th at `from` and n of its own steps later. Waits of
  /// Views from `measure_from` on are counted.
  void begin(bool idle, Time from, Time measure_from);
  /// Sends no more Views or requests; ends when what was asked for has come, or at `deadline`. Call join()
  /// then.
  void finish(Time deadline);
  void join();
  [[nodiscard]] const Live& live() const { return live_; }
  /// After join().
  [[nodiscard]] const Tallies& tallies() const { return tallies_; }
  /// How much later than due the clients acted: what the harness itself adds.
  [[nodiscard]] const measure::Histogram& lateness() const { return lateness_; }

  // ---- for its clients
  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] asio::io_context& io() { return io_; }
  [[nodiscard]] std::span<std::byte> scratch() { return scratch_; }
  [[nodiscard]] Tally& tally(Role role) { return tallies_[static_cast<std::size_t>(role)]; }
  [[nodiscard]] Live& live() { return live_; }
  [[nodiscard]] Time measure_from() const { return measure_from_; }
  [[nodiscard]] bool counts(Time since) const { return since >= measure_from_; }
  [[nodiscard]] bool finishing() const { return finishing_; }
  /// Whether the next chunk is of the share that is decoded and hashed.
  [[nodiscard]] bool picks_to_verify();
  /// The client's due time may have changed.
  void reschedule(SimulatedClient& client);

 private:
  struct Entry {
    Time due;
    SimulatedClient* client;
    bool operator<(const Entry& other) const { return due > other.due; }
  };

  [[nodiscard]] std::unique_ptr<SimulatedClient> make_client(const ClientProfile& profile);
  void wake_at(Time due);
  void act();
  void end_if_satisfied(Time deadline);

  const Plan& plan_;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard_;
  asio::steady_timer timer_;
  asio::steady_timer end_timer_;
  std::vector<std::byte> scratch_;
  std::map<std::uint32_t, std::shared_ptr<EditSite>> sites_;  // of groups that build
  std::vector<std::unique_ptr<SimulatedClient>> clients_;
  std::priority_queue<Entry> entries_;  // those whose due time has changed since count for nothing
  Time timer_due_ = Time::max();
  Time measure_from_ = Time::max();
  std::atomic<bool> finishing_ = false;
  Random random_;
  Tallies tallies_;
  measure::Histogram lateness_;
  Live live_;
  std::thread thread_;
};

}  // namespace talus::load
