#include "commands/store/local_writer.h"

#include <chrono>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace talus::server {

tl::expected<std::unique_ptr<LocalWriter>, std::string> LocalWriter::open(
    const std::filesystem::path& directory, const store::StoreIdentity& identity) {
  std::unique_ptr<LocalWriter> writer{new LocalWriter};
  store::EditDatabaseSettings settings;
  settings.path = directory;
  settings.fingerprint = identity.fingerprint;
  settings.store_id = identity.store_id;
  // Keeps all history; only talusd trims it.
  settings.history = {std::numeric_limits<std::uint64_t>::max(), std::chrono::milliseconds::max()};
  auto database = store::EditDatabase::open(settings);
  if (!database) return tl::unexpected{std::move(database.error())};
  if ((*database)->meta().stream.sequence != 0) {
    return tl::unexpected{
        fmt::format("data {}: the store belongs to a cluster, whose log has the next edits; start its "
                    "talusd, and run the command again: that talusd sends the edits to the log",
                    directory.string())};
  }
  auto state = EditState::open(**database, {});
  if (!state) return tl::unexpected{std::move(state.error())};
  writer->database_ = *std::move(database);
  writer->state_ = *std::move(state);
  writer->log_ = std::make_unique<LocalLog>(*writer->database_, *writer->state_, writer->clock_,
                                            LocalLogSettings{}, LocalLog::OnChanged{});
  writer->restorer_ = std::make_unique<Restorer>(*writer->log_);
  return writer;
}

}  // namespace talus::server
