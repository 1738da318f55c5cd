// Writes to a store's log without a server, for commands that edit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/store/edit_database.h>
#include <talus/store/store_identity.h>

#include "edits/edit_state.h"
#include "edits/local_log.h"
#include "edits/store_socket/restorer.h"
#include "runtime/clock.h"

namespace talus::server {

class LocalWriter {
 public:
  /// `directory` must be locked and its database closed. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<LocalWriter>, std::string> open(
      const std::filesystem::path& directory, const store::StoreIdentity& identity);
  /// Flushes everything.
  ~LocalWriter() {
    if (log_ != nullptr) log_->stop();
  }

  [[nodiscard]] tl::expected<Restorer::Result, EditError> restore(
      const std::vector<edits::ChunkChanges>& changes) {
    return restorer_->restore(changes);
  }

 private:
  LocalWriter() = default;

  SystemClock clock_;
  std::unique_ptr<store::EditDatabase> database_;
  std::unique_ptr<EditState> state_;
  std::unique_ptr<LocalLog> log_;
  std::unique_ptr<Restorer> restorer_;
};

}  // namespace talus::server
