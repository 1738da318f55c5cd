// A thread with its clients. Only that thread may call, unless stated otherwise.
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

/// Counters that any thread may read while a worker runs.
struct Live {
  std::atomic<std::uint64_t> chunks{0};  // Chunk messages
  std::atomic<std::uint64_t> uniform{0};
  std::atomic<std::uint64_t> bytes{0};   // all bytes received
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

  // ---- for the creating thread
  /// Call before run(). The client joins with others of its kind: idle ones first. All builders of a group
  /// must belong to one worker.
  void add(const ClientProfile& profile);
  void run();
  /// Makes idle clients, or all others, join: the n-th at `from` plus n steps. Waits of Views from
  /// `measure_from` on are recorded.
  void begin(bool idle, Time from, Time measure_from);
  /// Stops sending Views and requests; ends when everything requested has arrived, or at `deadline`. Call
  /// join() afterwards.
  void finish(Time deadline);
  void join();
  [[nodiscard]] const Live& live() const { return live_; }
  /// Call after join().
  [[nodiscard]] const Tallies& tallies() const { return tallies_; }
  /// Delay of the clients' actions: the harness's own contribution.
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
  /// True if the next chunk belongs to the sample that is decoded and hashed.
  [[nodiscard]] bool picks_to_verify();
  /// Call when the client's due time may have changed.
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
  std::map<std::uint32_t, std::shared_ptr<EditSite>> sites_;  // building groups
  std::vector<std::unique_ptr<SimulatedClient>> clients_;
  std::priority_queue<Entry> entries_;  // entries with an outdated due time are ignored
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
