#include "edits/edit_state.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "edits/replay.h"

namespace talus::server {
namespace {

/// Maximum writes of a batch to a chunk that are made in place, while readers wait for the lock.
constexpr std::size_t kFewWrites = 256;

std::size_t bytes_of_edited(const EditedChunk& chunk) {
  constexpr std::size_t kBytes = sizeof(edits::ChunkOverrides) + 32;
  return chunk.overrides == nullptr ? 0 : kBytes + chunk.overrides->size() * sizeof(Override);
}
std::size_t dirty_bytes_of(const EditedChunk& chunk) {
  return 64 + bytes_of_edited(chunk);
}

EditedChunk edited_chunk(std::uint64_t revision, edits::ChunkOverrides overrides) {
  if (overrides.empty()) return {revision, nullptr};
  return {revision, std::make_shared<edits::ChunkOverrides>(std::move(overrides))};
}

/// Appends the current voxels of a chunk that an edit wrote, and returns their number; 0 if they are too many
/// to remember, or a voxel of a coarser level is as generated, which is not known here.
std::uint32_t add_voxels_now(const edits::EntryResult& applied, std::size_t write,
                             std::vector<Override>& voxels) {
  const std::size_t before = voxels.size();
  if (applied.writes[write].writes.size() > RecentChanges::kMaxVoxels) return 0;
  if (write < applied.changes.size()) {  // level 0, in the order of the changes
    for (const edits::VoxelChange& voxel : applied.changes[write].voxels) {
      voxels.push_back({voxel.index, voxel.after});
    }
  } else {
    for (const edits::OverrideWrite& each : applied.writes[write].writes) {
      if (!each.material) {
        voxels.resize(before);
        return 0;
      }
      voxels.push_back({each.index, *each.material});
    }
  }
  return static_cast<std::uint32_t>(voxels.size() - before);
}

}  // namespace

EditState::EditState(store::EditDatabase& database, const EditStateSettings& settings)
    : database_{database},
      settings_{settings},
      recent_{settings.recent_bytes},
      cache_{settings.cache_bytes} {}

tl::expected<std::unique_ptr<EditState>, std::string> EditState::open(store::EditDatabase& database,
                                                                      const EditStateSettings& settings) {
  std::unique_ptr<EditState> state{new EditState{database, settings}};
  auto good = database.for_each_chunk([&](ChunkKey key, std::uint64_t revision) {
    state->index_.raise(key, {revision});
    state->index_.raise_column(key, revision);
  });
  if (good) good = state->replay();
  if (!good) return tl::unexpected{std::move(good.error())};
  return state;
}

bool EditState::fit_cache() {
  std::size_t probes = 1024;
  return cache_.fit(probes);
}

store::EditDatabase::Status EditState::replay() {
  Replay replay{database_, index_};
  auto good = database_.for_each_editor(
      [&](edits::EditorId id, store::StoredEditor&& editor) { replay.start(id, std::move(editor)); });
  if (good) good = database_.replay([&](store::LogRecord&& record) { return replay.apply(record); });
  if (!good) return good;
  for (auto& [key, chunk] : replay.take_chunks()) {
    index_.raise(key, {chunk.revision});
    index_.raise_column(key, chunk.revision);
    put_dirty(dirty_[key], edited_chunk(chunk.revision, std::move(chunk.overrides)));
  }
  editors_ = replay.take_editors();
  dirty_editors_ = replay.take_dirty_editors();
  head_ = database_.meta().head;
  revision_ = head_.revision;
  return {};
}

tl::expected<EditedChunk, std::string> EditState::load(ChunkKey key) const {
  // The minimum revision. A chunk that is no longer dirty is on the disk, at this revision or a later one.
  const std::uint64_t wanted = index_.revision(key);
  if (wanted == 0) return EditedChunk{};
  {
    const std::shared_lock lock{dirty_mutex_};
    if (Dirty* const found = dirty_.find(key)) {
      found->share();
      return found->chunk;
    }
  }
  if (const auto cached = cache_.find(key); cached && cached->revision >= wanted) return *cached;
  auto stored = database_.chunk(key);
  if (!stored) return tl::unexpected{std::move(stored.error())};
  if (!*stored) {
    return tl::unexpected{"chunk " + to_string(key) +
                          ": its edits are missing in the store; restore a backup"};
  }
  if ((*stored)->revision < wanted) {
    return tl::unexpected{
        fmt::format("chunk {}: the store has its edits up to revision {}, and {} was "
                    "acknowledged; restore a backup",
                    to_string(key), (*stored)->revision, wanted)};
  }
  EditedChunk chunk = edited_chunk((*stored)->revision, edits::ChunkOverrides{std::move((*stored)->voxels)});
  // No commit runs under this lock, so that the cache never keeps an outdated chunk.
  const std::shared_lock lock{dirty_mutex_};
  if (index_.revision(key) == chunk.revision) cache_.put(key, chunk, bytes_of_edited(chunk));
  return chunk;
}

std::optional<AppliedEdits::Changes> EditState::changes_since(ChunkKey key, std::uint64_t since,
                                                              std::size_t max_voxels) const {
  return recent_.since(key, index_.find(key), since, max_voxels);
}

std::optional<edits::Editor> EditState::editor(edits::EditorId id) const {
  const std::shared_lock lock{editors_mutex_};
  const edits::Editor* const editor = editors_.find(id);
  return editor == nullptr ? std::nullopt : std::optional{*editor};
}

std::size_t EditState::editor_count() const {
  const std::shared_lock lock{editors_mutex_};
  return editors_.size();
}

std::size_t EditState::editor_bytes() const {
  const std::shared_lock lock{editors_mutex_};
  const std::size_t fresh = editors_.never_used().size();
  return fresh * kNewEditorBytes + (editors_.size() - fresh) * kUsedEditorBytes;
}

bool EditState::any_editor_idle_at(std::int64_t time_ms) const {
  const std::shared_lock lock{editors_mutex_};
  return editors_.any_idle_at(time_ms);
}

std::vector<ChunkChange> EditState::commit(edits::Batch&& batch) {
  std::vector<ChunkChange> changed;
  changed.reserve(batch.chunks().size());
  std::vector<std::uint32_t> newest;  // numbers of their last changes
  newest.reserve(batch.chunks().size());
  FlatMap<ChunkKey, std::size_t> places;  // index into both
  std::vector<RecentChanges::Change> recent;
  recent.reserve(batch.applied().size());
  std::vector<Override> recent_voxels;
  recent_voxels.reserve(batch.applied().size());
  for (const edits::EntryResult& applied : batch.applied()) {
    for (std::size_t i = 0; i < applied.writes.size(); ++i) {
      const ChunkKey key = applied.writes[i].key;
      const auto [place, added] = places.emplace(key);
      if (added) {
        place = changed.size();
        const ChunkIndex::ChunkEntry before = index_.find(key);
        changed.push_back({key, before.revision, before.revision});
        newest.push_back(before.change);
      }
      const std::uint64_t previous = std::exchange(changed[place].revision, applied.revision);
      // Unknown voxels make no change: the chain of the chunk's changes ends there.
      if (const std::uint32_t voxels = add_voxels_now(applied, i, recent_voxels)) {
        const auto number = recent_.next() + static_cast<std::uint32_t>(recent.size());
        recent.push_back({key, previous, applied.revision, std::exchange(newest[place], number), voxels});
      }
    }
  }
  head_ = batch.head();
  {
    const std::lock_guard lock{editors_mutex_};
    for (auto& [id, editor] : std::move(batch).take_editors()) {
      dirty_editors_.insert(id);
      if (editor) {
        editors_.put(id, std::move(*editor));
      } else {
        editors_.erase(id);
      }
    }
  }
  // Overrides first, then the index: a reader that sees a revision there can load it.
  write_overrides(batch.chunks(), changed);
  recent_.add(recent, recent_voxels);
  for (std::size_t i = 0; i < changed.size(); ++i)
    index_.raise(changed[i].key, {changed[i].revision, newest[i]});
  for (const ChunkChange& change : changed) index_.raise_column(change.key, change.revision);
  revision_.store(head_.revision, std::memory_order_release);
  return changed;
}

void EditState::write_overrides(const std::unordered_map<ChunkKey, edits::StagedChunk>& staged,
                                std::span<const ChunkChange> changed) {
  // Copies and slow work come before the lock.
  struct Write {
    const edits::StagedChunk* staged = nullptr;
    Dirty* held = nullptr;  // null: it is not dirty yet
    EditedChunk made;       // if it is not written in place
  };
  std::vector<Write> writes(changed.size());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    auto& [chunk, held, made] = writes[i];
    chunk = &staged.at(changed[i].key);
    held = dirty_.find(changed[i].key);
    const bool in_place = held != nullptr && is_own(*held) && chunk->writes.size() <= kFewWrites;
    if (!in_place) made = edited_chunk(changed[i].revision, chunk->after());
  }
  const std::lock_guard lock{dirty_mutex_};
  for (std::size_t i = 0; i < changed.size(); ++i) {
    auto& [chunk, found, made] = writes[i];
    Dirty& held = found == nullptr ? dirty_[changed[i].key] : *found;
    if (made.revision != 0) {
      put_dirty(held, std::move(made));
    } else if (is_own(held)) {
      write_in_place(held, *chunk, changed[i].revision);
    } else {  // a reader shared it meanwhile
      put_dirty(held, edited_chunk(changed[i].revision, chunk->after()));
    }
  }
}

bool EditState::is_own(Dirty& held) {
  return held.chunk.overrides != nullptr && !std::atomic_ref{held.is_shared}.load(std::memory_order_relaxed);
}

void EditState::write_in_place(Dirty& held, const edits::StagedChunk& staged, std::uint64_t revision) {
  dirty_bytes_ -= dirty_bytes_of(held.chunk);
  // Made by edited_chunk(), and not shared.
  const auto overrides = std::const_pointer_cast<edits::ChunkOverrides>(held.chunk.overrides);
  overrides->apply(staged.writes);
  held.chunk.revision = revision;
  if (overrides->empty()) held.chunk.overrides = nullptr;
  dirty_bytes_ += dirty_bytes_of(held.chunk);
}

void EditState::put_dirty(Dirty& held, EditedChunk chunk) {
  if (held.chunk.revision != 0) dirty_bytes_ -= dirty_bytes_of(held.chunk);
  dirty_bytes_ += dirty_bytes_of(chunk);
  held.chunk = std::move(chunk);
  held.is_shared = false;
}

std::vector<ChunkKey> EditState::dirty_chunks() const {
  std::vector<ChunkKey> keys;
  keys.reserve(dirty_.size());
  for (const auto& [key, chunk] : dirty_) keys.push_back(key);
  return keys;
}

std::vector<edits::EditorId> EditState::take_dirty_editors() {
  std::vector<edits::EditorId> ids(dirty_editors_.begin(), dirty_editors_.end());
  dirty_editors_.clear();
  return ids;
}

const EditedChunk* EditState::dirty(ChunkKey key) const {
  const Dirty* const found = dirty_.find(key);
  return found == nullptr ? nullptr : &found->chunk;
}

void EditState::mark_clean(ChunkKey key, std::uint64_t revision) {
  const std::lock_guard lock{dirty_mutex_};
  const Dirty* const found = dirty_.find(key);
  if (found == nullptr || found->chunk.revision != revision) return;
  const EditedChunk& chunk = found->chunk;
  dirty_bytes_ -= dirty_bytes_of(chunk);
  cache_.put(key, chunk, bytes_of_edited(chunk));
  dirty_.erase(key);
}

const edits::ChunkOverrides* EditState::Reader::find(ChunkKey key) const {
  if (const EditedChunk* const dirty = state_.dirty(key)) return dirty->overrides.get();
  if (state_.revision(key) == 0) return nullptr;
  const HeldOverrides& chunk = held(key);
  if (chunk.fault) error_ = chunk.fault;
  return chunk.overrides.get();
}

std::optional<std::string> EditState::Reader::fault_of(std::span<const ChunkKey> chunks) const {
  for (const ChunkKey key : chunks) {
    if (state_.dirty(key) != nullptr || state_.revision(key) == 0) continue;
    if (const auto& fault = held(key).fault) return fault;
  }
  return std::nullopt;
}

const EditState::Reader::HeldOverrides& EditState::Reader::held(ChunkKey key) const {
  const auto [held, added] = held_.try_emplace(key);
  if (added) {
    if (auto loaded = state_.load(key)) {
      held->second.overrides = std::move(loaded->overrides);
    } else {
      held->second.fault = std::move(loaded.error());
    }
  }
  return held->second;
}

}  // namespace talus::server
