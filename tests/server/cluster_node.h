// One server of a cluster, for tests: a store with its end of the shared log, opened, closed and cut off from
// power any number of times.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include <talus/store/edit_database.h>

#include "cluster/cluster_log.h"
#include "cluster/log_stream.h"
#include "cluster/message.h"
#include "edits/edit_state.h"
#include "runtime/clock.h"
#include "unsafe_disk.h"

namespace talus::server::testing {

inline const store::StoreIdentity kClusterIdentity{{3, 4}, {1, 2}};

inline std::vector<std::byte> empty_genesis() {
  cluster::Genesis genesis;
  genesis.identity = kClusterIdentity;
  return *cluster::encode(genesis);
}

class ClusterNode {
 public:
  /// An end of the shared stream, for each time that the node is opened.
  using OpenStream = std::function<std::unique_ptr<LogStream>()>;

  ClusterNode(std::filesystem::path path, OpenStream open_stream, std::uint64_t seed)
      : path_{std::move(path)},
        open_stream_{std::move(open_stream)},
        disk_{std::make_shared<UnsafeDisk>(seed)},
        env_{environment_of(disk_)} {
    settings.store.flush_interval = std::chrono::milliseconds{5};
    settings.store.retry_interval = std::chrono::milliseconds{20};
    settings.poll_interval = std::chrono::milliseconds{20};
    settings.sure_of_other = std::chrono::milliseconds{600};
  }
  ~ClusterNode() { close(); }

  /// The machine's.
  struct WrongClock final : Clock {
    std::chrono::seconds ahead{0};
    std::atomic<std::chrono::seconds> later{};
    [[nodiscard]] time_point now() const override { return right.now() + later.load(); }
    [[nodiscard]] std::chrono::sys_seconds wall() const override { return right.wall() + ahead; }
    [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override { return right.thread_cpu(); }
    SystemClock right;
  };
  WrongClock clock;
  cluster::ClusterLog::Settings settings;
  EditStateSettings state_settings;
  /// On the log's thread, after each batch that changed something.
  std::function<void(const edits::Head&)> on_changed = [](const edits::Head&) {};
  std::function<void(cluster::StoreLoss, const std::string&)> on_lost = [](cluster::StoreLoss,
                                                                           const std::string&) {};
  std::function<void()> on_takes = [] {};
  /// When the store is open, and nothing has begun.
  std::function<void()> before_log = [] {};

  /// The error, or nothing.
  [[nodiscard]] std::string open() {
    if (auto error = open_store(); !error.empty()) return error;
    before_log();
    end_ = open_stream_();
    cluster::ClusterLog::Parts parts{
        *end_,
        *database_,
        *state_,
        clock,
        make_logger("off", "text"),
        [this](const auto&) { on_changed(state_->head()); },
        [this] { on_takes(); },
        [this](cluster::StoreLoss how, const std::string& why) { on_lost(how, why); }};
    log_ = std::make_unique<cluster::ClusterLog>(std::move(parts), settings);
    log_->start();
    return {};
  }
  [[nodiscard]] std::string open_store() {
    store::EditDatabaseSettings store;
    store.path = path_;
    store.fingerprint = kClusterIdentity.fingerprint;
    store.store_id = kClusterIdentity.store_id;
    store.memory.write_buffer_bytes = 64 << 10;
    store.env = env_.get();
    store.log_elsewhere = true;
    auto database = store::EditDatabase::open(store);
    if (!database) return database.error();
    database_ = *std::move(database);
    auto state = EditState::open(*database_, state_settings);
    if (!state) return state.error();
    state_ = *std::move(state);
    return {};
  }
  void close() {
    log_.reset();
    state_.reset();
    database_.reset();
    end_.reset();
  }
  /// The power goes: what was not synced may be lost.
  void cut_power() {
    disk_->cut_after(0);
    close();
    disk_->restart();
  }
  [[nodiscard]] bool is_open() const { return log_ != nullptr; }

  [[nodiscard]] cluster::ClusterLog& log() { return *log_; }
  [[nodiscard]] EditState& state() { return *state_; }
  [[nodiscard]] store::EditDatabase& database() { return *database_; }
  [[nodiscard]] UnsafeDisk& disk() { return *disk_; }
  [[nodiscard]] rocksdb::Env& env() { return *env_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  const std::filesystem::path path_;
  const OpenStream open_stream_;
  const std::shared_ptr<UnsafeDisk> disk_;
  const std::unique_ptr<rocksdb::Env> env_;
  std::unique_ptr<store::EditDatabase> database_;
  std::unique_ptr<EditState> state_;
  std::unique_ptr<LogStream> end_;
  std::unique_ptr<cluster::ClusterLog> log_;
};

}  // namespace talus::server::testing
