// A store of edits with its log, as talusd has it, for tests: opened, used and closed any number of times.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <rocksdb/env.h>

#include <talus/store/edit_database.h>
#include <talus/store/store_identity.h>

#include "edits/edit_state.h"
#include "edits/local_log.h"
#include "runtime/clock.h"

namespace talus::server::testing {

class EditStore {
 public:
  explicit EditStore(const std::filesystem::path& path) {
    database_settings.path = path;
    database_settings.fingerprint = {1, 2};
    database_settings.store_id = {3, 4};
  }
  ~EditStore() { close(); }

  store::EditDatabaseSettings database_settings;
  EditStateSettings state_settings;
  LocalLogSettings log_settings;
  LocalLog::OnChanged on_changed;
  /// Of the log; the system's unless a test has its own.
  const Clock* clock = &system_clock_;

  /// The error, or nothing.
  [[nodiscard]] std::string open() {
    if (auto error = open_without_log(); !error.empty()) return error;
    open_log();
    return {};
  }
  void open_log() {
    log_ = std::make_unique<LocalLog>(*database_, *state_, *clock, log_settings, on_changed);
  }
  [[nodiscard]] std::string open_without_log() {
    // As a DataDirectory reads it, where the store became another.
    const auto identity = store::read_store_identity(database_settings.path / "store.toml");
    if (identity) database_settings.store_id = identity->store_id;
    auto database = store::EditDatabase::open(database_settings);
    if (!database) return database.error();
    database_ = std::move(*database);
    auto state = EditState::open(*database_, state_settings);
    if (!state) {
      database_.reset();
      return state.error();
    }
    state_ = std::move(*state);
    return {};
  }
  void close() {
    log_.reset();
    state_.reset();
    database_.reset();
  }

  [[nodiscard]] LocalLog& log() { return *log_; }
  [[nodiscard]] EditState& state() { return *state_; }
  [[nodiscard]] store::EditDatabase& database() { return *database_; }

  /// What became of an entry; nothing where the log did not take it, or failed.
  std::optional<edits::EntryResult> apply(LogEntry entry) {
    std::mutex mutex;
    std::condition_variable answered;
    bool is_answered = false;
    std::optional<edits::EntryResult> result;
    const auto taken = log_->append(std::move(entry), [&](const auto& applied) {
      const std::lock_guard lock{mutex};
      if (applied) result = **applied;
      is_answered = true;
      answered.notify_one();
    });
    if (!taken) return std::nullopt;
    std::unique_lock lock{mutex};
    answered.wait(lock, [&] { return is_answered; });
    return result;
  }

 private:
  SystemClock system_clock_;
  std::unique_ptr<store::EditDatabase> database_;
  std::unique_ptr<EditState> state_;
  std::unique_ptr<LocalLog> log_;
};

}  // namespace talus::server::testing
