#include <talus/store/store_builder.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <rocksdb/write_batch.h>
#include <talus/edits/levels.h>
#include <talus/files/atomic_file.h>
#include <talus/store/rocks.h>

namespace talus::store {
namespace {

/// Voxels of coarse levels held before they are written.
constexpr std::size_t kCoarseVoxels = std::size_t{1} << 20U;
constexpr std::size_t kWriteBytes = std::size_t{1} << 20U;

tl::unexpected<std::string> builder_failure(const std::filesystem::path& path,
                                            const rocksdb::Status& status) {
  return tl::unexpected{fmt::format("{}: {}", path.string(), status.ToString())};
}

}  // namespace

tl::expected<void, std::string> write_store_files(const std::filesystem::path& directory,
                                                  const StoreMeta& meta) {
  Bytes acknowledged;
  encode(AcknowledgedState{meta.head.position, meta.link}, acknowledged);
  const std::span<const std::byte> bytes{acknowledged};
  if (const auto written = files::write_file(directory / "acknowledged", bytes); !written) {
    return tl::unexpected{written.error().message()};
  }
  const std::string text = store_text({meta.store_id, meta.fingerprint});
  if (const auto written = files::write_file(directory / "store.toml", text); !written) {
    return tl::unexpected{written.error().message()};
  }
  return {};
}

StoreBuilder::StoreBuilder(std::filesystem::path directory, const StoreIdentity& identity)
    : directory_{std::move(directory)}, batch_{std::make_unique<rocksdb::WriteBatch>()} {
  meta_.fingerprint = identity.fingerprint;
  meta_.store_id = identity.store_id;
}

StoreBuilder::~StoreBuilder() = default;

tl::expected<std::unique_ptr<StoreBuilder>, std::string> StoreBuilder::create(
    const std::filesystem::path& directory, const StoreIdentity& identity, std::uint64_t position,
    std::uint64_t link) {
  std::unique_ptr<StoreBuilder> builder{new StoreBuilder{directory, identity}};
  builder->meta_.head.position = position;
  builder->meta_.link = link;
  builder->meta_.flushed = position;
  builder->meta_.flushed_link = link;
  rocksdb::DB* db = nullptr;
  const auto status = rocksdb::DB::Open(rocks_options({}, true), (directory / "db").string(), &db);
  builder->db_.reset(db);
  if (!status.ok()) return builder_failure(directory, status);
  return builder;
}

StoreBuilder::Status StoreBuilder::put(const std::string& key) {
  batch_->Put(key, as_slice(value_));
  if (batch_->GetDataSize() < kWriteBytes) return {};
  return write();
}

StoreBuilder::Status StoreBuilder::write() {
  rocksdb::WriteOptions options;
  options.disableWAL = true;  // an interrupted build starts over
  const auto status = db_->Write(options, batch_.get());
  batch_->Clear();
  if (!status.ok()) return builder_failure(directory_, status);
  return {};
}

StoreBuilder::Status StoreBuilder::add(ChunkCoord chunk, std::uint64_t revision,
                                       std::span<const Override> voxels) {
  if (voxels.empty()) return {};
  ++chunks_;
  voxels_ += voxels.size();
  hash_.add(chunk, voxels);
  const std::string key = chunk_key({chunk, Lod{}});
  encode(key, revision, voxels, value_);
  if (auto done = put(key); !done) return done;
  std::vector<edits::OverrideWrite> writes;
  writes.reserve(voxels.size());
  for (const Override& voxel : voxels) writes.push_back({voxel.index, voxel.material});
  for (const edits::ChunkWrites& coarse : edits::coarse_writes(chunk, writes)) {
    Coarse& held = coarse_[coarse.key];
    held.revision = std::max(held.revision, revision);
    for (const edits::OverrideWrite& write : coarse.writes)
      held.voxels.push_back({write.index, *write.material});
    coarse_voxels_ += coarse.writes.size();
  }
  return coarse_voxels_ < kCoarseVoxels ? Status{} : write_coarse();
}

StoreBuilder::Status StoreBuilder::write_coarse() {
  if (auto written = write(); !written) return written;  // the reads below need it
  for (auto& [key, coarse] : coarse_) {
    const std::string name = chunk_key(key);
    std::string before;
    const auto status = db_->Get({}, name, &before);
    if (status.ok()) {
      // Chunks of level 0 share no voxel of a coarse chunk.
      auto stored = decode_chunk_value(name, std::as_bytes(std::span{before}));
      if (!stored) return tl::unexpected{fmt::format("{}: what was written is not what is read", name)};
      coarse.voxels.insert(coarse.voxels.end(), stored->voxels.begin(), stored->voxels.end());
      coarse.revision = std::max(coarse.revision, stored->revision);
    } else if (!status.IsNotFound()) {
      return builder_failure(directory_, status);
    }
    std::ranges::sort(coarse.voxels, {}, &Override::index);
    encode(name, coarse.revision, coarse.voxels, value_);
    if (auto done = put(name); !done) return done;
  }
  coarse_.clear();
  coarse_voxels_ = 0;
  return {};
}

StoreBuilder::Status StoreBuilder::add(std::string_view name, MaterialId material) {
  const std::string key = material_key(name);
  encode(key, material, value_);
  return put(key);
}

StoreBuilder::Status StoreBuilder::finish(std::uint64_t revision, std::int64_t time_ms) {
  if (auto done = write_coarse(); !done) return done;
  meta_.head.revision = revision;
  meta_.head.time_ms = time_ms;
  meta_.head.hash = hash_;
  encode(meta_, value_);
  batch_->Put(meta_key(), as_slice(value_));
  if (auto done = write(); !done) return done;
  if (const auto status = db_->Flush({}); !status.ok()) return builder_failure(directory_, status);
  if (const auto status = db_->Close(); !status.ok()) return builder_failure(directory_, status);
  db_.reset();
  return write_store_files(directory_, meta_);
}

}  // namespace talus::store
