#include "store_command/local_writer.h"

#include <utility>

namespace talus::server {

tl::expected<std::unique_ptr<LocalWriter>, std::string> LocalWriter::open(
    const std::filesystem::path& directory, const StoreIdentity& identity) {
  std::unique_ptr<LocalWriter> writer{new LocalWriter};
  EditDatabaseSettings settings;
  settings.path = directory;
  settings.fingerprint = identity.fingerprint;
  settings.store_id = identity.store_id;
  auto database = EditDatabase::open(settings);
  if (!database) return tl::unexpected{std::move(database.error())};
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
