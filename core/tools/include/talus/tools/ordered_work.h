// Produces results on many threads and consumes them in order on one, with bounded memory.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace talus::tools {

/// Number of threads for a requested number; 0 means one per core.
[[nodiscard]] inline int thread_count(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Calls produce(i) for i in 0 to count - 1 on `threads` threads, and consume(i, result) on the calling
/// thread in the order of i, until it returns false. At most four results per thread are pending. An
/// exception in either ends the work and leaves through this call. Returns true if everything was consumed.
template <typename Produce, typename Consume>
bool work_in_order(std::size_t count, int threads, const Produce& produce, const Consume& consume) {
  using Result = decltype(produce(std::size_t{}));
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    std::map<std::size_t, Result> ready;
    std::size_t taken = 0;
    std::size_t consumed = 0;
    bool stopped = false;
    std::exception_ptr failure;
  } state;
  const std::size_t window = static_cast<std::size_t>(threads) * 4;

  const auto work = [&] {
    std::unique_lock lock{state.mutex};
    for (;;) {
      state.changed.wait(lock, [&] {
        return state.stopped || state.taken == count || state.taken < state.consumed + window;
      });
      if (state.stopped || state.taken == count) return;
      const std::size_t index = state.taken++;
      lock.unlock();
      try {
        Result result = produce(index);
        lock.lock();
        state.ready.emplace(index, std::move(result));
      } catch (...) {
        if (!lock.owns_lock()) lock.lock();
        state.failure = std::current_exception();
        state.stopped = true;
      }
      state.changed.notify_all();
    }
  };

  std::vector<std::jthread> workers;
  // However this call ends, the workers are stopped before they are joined.
  struct Stop {
    State& state;
    ~Stop() {
      const std::lock_guard lock{state.mutex};
      state.stopped = true;
      state.changed.notify_all();
    }
  } stop{state};
  const std::size_t wanted = std::min(static_cast<std::size_t>(threads), count);
  for (std::size_t i = 0; i < wanted; ++i) workers.emplace_back(work);

  for (std::size_t next = 0; next < count; ++next) {
    std::unique_lock lock{state.mutex};
    state.changed.wait(lock, [&] { return state.failure || state.ready.contains(next); });
    if (state.failure) std::rethrow_exception(state.failure);
    Result result = std::move(state.ready.extract(next).mapped());
    state.consumed = next + 1;
    state.changed.notify_all();
    lock.unlock();
    if (!consume(next, std::move(result))) return false;
  }
  return true;
}

}  // namespace talus::tools
