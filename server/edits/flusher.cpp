#include "edits/flusher.h"

#include <algorithm>
#include <utility>

namespace talus::server {

Flusher::Flusher(EditState& state, store::EditDatabase& database)
    : Flusher{state, database, [&database]() -> tl::expected<bool, std::string> {
                if (auto synced = database.sync(); !synced) return tl::unexpected{std::move(synced.error())};
                return true;
              }} {}

void Flusher::start() {
  position_ = state_.head().position;
  chunks_ = state_.dirty_chunks();
  editors_ = state_.take_dirty_editors();
  editors_left_ = editors_.size();
  written_.clear();
  put_ = false;
  flushed_ = false;
  // Keys in order cost the database less.
  std::ranges::sort(chunks_, std::greater{});
  running_ = true;
}

store::EditDatabase::Status Flusher::step() {
  if (flushed_) {
    clean_some();
    return {};
  }
  if (put_) return mark();
  store::EditDatabase::Slice slice;
  const auto has_place = [&] { return slice.count() < kSliceValues && slice.bytes() < kSliceBytes; };
  const std::size_t written_before = written_.size();
  std::size_t chunks_left = chunks_.size();
  for (; chunks_left > 0 && has_place(); --chunks_left) {
    const ChunkKey key = chunks_[chunks_left - 1];
    const EditedChunk* const chunk = state_.dirty(key);
    if (chunk == nullptr) continue;
    const auto* const overrides = chunk->overrides.get();
    slice.put(key, chunk->revision, overrides == nullptr ? std::span<const Override>{} : overrides->voxels());
    written_.emplace_back(key, chunk->revision);
  }
  std::size_t editors_left = editors_left_;
  for (; editors_left > 0 && has_place(); --editors_left) {
    const edits::EditorId id = editors_[editors_left - 1];
    if (const edits::Editor* const editor = state_.editors().find(id)) {
      slice.put(id, state_.head().position, *editor);
    } else {
      slice.erase(id);
    }
  }
  if (slice.count() > 0) {
    if (auto put = database_.put(slice); !put) {
      written_.resize(written_before);
      return put;
    }
  }
  chunks_.resize(chunks_left);
  editors_left_ = editors_left;
  if (chunks_left > 0 || editors_left > 0) return {};
  put_ = true;
  return mark();
}

store::EditDatabase::Status Flusher::mark() {
  const auto synced = synced_();
  if (!synced) return tl::unexpected{synced.error()};
  if (!*synced) return {};
  if (auto marked = database_.mark_flushed(position_); !marked) return marked;
  flushed_ = true;
  clean_some();
  return {};
}

void Flusher::clean_some() {
  for (std::size_t left = kSliceValues; left > 0 && !written_.empty(); --left) {
    const auto [key, revision] = written_.back();
    state_.mark_clean(key, revision);
    written_.pop_back();
  }
  running_ = !written_.empty();
}

void Flusher::abandon() {
  state_.put_dirty_editors(editors_);
  running_ = false;
}

}  // namespace talus::server
