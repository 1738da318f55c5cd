#include <talus/client/prediction.h>

#include <algorithm>
#include <set>
#include <utility>

#include <talus/edits/evaluate.h>

namespace talus::client {
namespace {

/// No overrides: the held chunks are the base on which edits are evaluated.
struct NoOverrides final : edits::OverrideSource {
  [[nodiscard]] const edits::ChunkOverrides* find(ChunkKey) const override { return nullptr; }
};

ChunkKey key_of(ChunkCoord chunk) {
  return {chunk, Lod{}};
}

LocalPos place_of(std::uint16_t index) {
  const auto at = [&](int shift) { return static_cast<std::uint8_t>((index >> shift) % kChunkSize); };
  return {at(0), at(10), at(5)};
}

}  // namespace

struct Prediction::PredictedEdit {
  Id id{};
  Edit edit;
  std::vector<edits::TouchedChunk> touched;
  std::optional<std::uint64_t> revision;  // set once applied: the world's revision after the edit
  // Chunks of `touched` that are shown as held: they were requested again, or were not held at some time
  // since the answer. A later version includes the edit, is followed by one that does, or was not changed by
  // the edit.
  std::set<ChunkCoord> resolved;

  [[nodiscard]] bool touches(ChunkCoord chunk) const {
    const auto at = std::ranges::lower_bound(touched, chunk, {}, &edits::TouchedChunk::chunk);
    return at != touched.end() && at->chunk == chunk;
  }
};

struct Prediction::Overlay {
  std::map<std::uint16_t, MaterialId> voxels;
};

Prediction::Prediction(ChunkStore& store, std::function<void(ChunkKey)> changed)
    : store_{store}, changed_{std::move(changed)}, self_{std::make_shared<Prediction*>(this)} {}

Prediction::~Prediction() {
  *self_ = nullptr;
}

const ReceivedChunk* Prediction::confirmed(ChunkCoord chunk) const {
  const auto covered = confirmed_.find(chunk);
  return covered != confirmed_.end() ? &covered->second : store_.look(key_of(chunk));
}

// ---- chunks from the server

void Prediction::put(const ReceivedChunk& chunk) {
  const ReceivedChunk* const held = chunk.key.lod == Lod{} ? confirmed(chunk.key.coord) : nullptr;
  if (chunk.unchanged() || (held != nullptr && held->revision > chunk.revision)) return;
  if (chunk.key.lod == Lod{}) confirmed_.erase(chunk.key.coord);
  store_.put(chunk);
  if (is_touched(chunk.key) || covers_lost()) return rebuild(chunk.key);
  if (changed_) changed_(chunk.key);
}

void Prediction::erase(const ChunkKey& key) {
  store_.erase(key);
  if (!is_touched(key)) return;
  confirmed_.erase(key.coord);
  for (PredictedEdit& open : edits_) {
    if (open.revision && open.touches(key.coord)) open.resolved.insert(key.coord);
  }
  rebuild();
}

bool Prediction::is_touched(const ChunkKey& key) const {
  return key.lod == Lod{} &&
         std::ranges::any_of(edits_, [&](const PredictedEdit& open) { return open.touches(key.coord); });
}

bool Prediction::covers_lost() const {
  return std::ranges::any_of(confirmed_,
                             [&](const auto& covered) { return !store_.contains(covered.second.key); });
}

std::size_t Prediction::open() const {
  return edits_.size();
}

void Prediction::clear() {
  store_.clear();
  confirmed_.clear();
  edits_.clear();
}

// ---- own edits

void Prediction::edit(Client& client, const Edit& edit, std::function<void(Result<EditDone>)> handler) {
  const Id id = begin(edit);
  client.edit(edit, [self = std::weak_ptr{self_}, &client, id,
                     handler = std::move(handler)](Result<EditDone> result) {
    if (const auto there = self.lock(); there != nullptr && *there != nullptr) {
      (*there)->done(id, result);
      if (!(*there)->behind(id).empty()) ask_later(self, client, id);
    }
    if (handler) handler(std::move(result));
  });
}

void Prediction::ask_later(const std::weak_ptr<Prediction*>& self, Client& client, Id id) {
  // Most of the chunks are in flight already. The rest is requested after the next answer.
  client.ping([self, &client, id](Result<std::chrono::nanoseconds> answered) {
    const auto there = self.lock();
    if (there == nullptr || *there == nullptr) return;
    const std::vector<ChunkKey> behind = (*there)->behind(id);
    if (!answered) {  // The next connection sends the View's chunks again. The client may be gone.
      for (const ChunkKey& key : behind) (*there)->resolve(id, key);
      return;
    }
    for (const ChunkKey& key : behind) {
      client.get(key, std::nullopt, [self, id, key](Result<ReceivedChunk> chunk) {
        const auto still = self.lock();
        if (still == nullptr || *still == nullptr) return;
        Prediction& own = **still;
        if (chunk && own.confirmed(key.coord) != nullptr) own.put(*chunk);
        own.resolve(id, key);
      });
    }
  });
}

Prediction::Id Prediction::begin(const Edit& edit) {
  const Id id{++last_id_};
  auto touched = edits::touched_voxels(edit);
  if (!touched) return id;  // the server will refuse it
  edits_.push_back({id, edit, *std::move(touched), std::nullopt, {}});
  rebuild();
  return id;
}

void Prediction::done(Id id, const Result<EditDone>& result) {
  const auto open = std::ranges::find(edits_, id, &PredictedEdit::id);
  if (open == edits_.end()) return;
  if (result) {
    open->revision = result->revision;
    open->edit.guards.clear();  // they held on the server
    for (const edits::TouchedChunk& touched : open->touched) {
      if (confirmed(touched.chunk) == nullptr) open->resolved.insert(touched.chunk);
    }
  } else {
    edits_.erase(open);
  }
  rebuild();
}

std::vector<ChunkKey> Prediction::behind(Id id) const {
  std::vector<ChunkKey> keys;
  const auto open = std::ranges::find(edits_, id, &PredictedEdit::id);
  if (open == edits_.end() || !open->revision) return keys;
  for (const edits::TouchedChunk& touched : open->touched) {
    if (waits(*open, touched.chunk)) keys.push_back(key_of(touched.chunk));
  }
  return keys;
}

void Prediction::resolve(Id id, const ChunkKey& key) {
  const auto open = std::ranges::find(edits_, id, &PredictedEdit::id);
  if (open == edits_.end()) return;
  open->resolved.insert(key.coord);
  rebuild();
}

// ---- the store

void Prediction::rebuild(std::optional<ChunkKey> came) {
  std::vector<ChunkKey> changed;
  if (!edits_.empty() || !confirmed_.empty()) {
    Overlays overlays;
    std::erase_if(edits_, [&](const PredictedEdit& open) { return apply(open, overlays); });
    changed = show(overlays);
  }
  if (came && std::ranges::find(changed, *came) == changed.end()) changed.push_back(*came);
  if (!changed_) return;
  for (const ChunkKey& key : changed) changed_(key);
}

bool Prediction::waits(const PredictedEdit& open, ChunkCoord chunk) const {
  // A chunk at the edit's revision or later includes it. A chunk that the edit did not change never reaches
  // that revision; once the server's earlier edits have arrived, reapplying the edit there mostly changes
  // nothing. But loose material may have slid into a dug hole; then requesting the chunk again settles it.
  const ReceivedChunk* const held = confirmed(chunk);
  if (held == nullptr) return false;
  return !open.revision || (held->revision < *open.revision && !open.resolved.contains(chunk));
}

bool Prediction::apply(const PredictedEdit& open, Overlays& overlays) const {
  edits::BaseVoxels base;
  for (const edits::TouchedChunk& touched : open.touched) {
    const ReceivedChunk* const held = confirmed(touched.chunk);
    const auto overlay = overlays.find(touched.chunk);
    std::vector<Override>& voxels = base[touched.chunk];
    voxels.reserve(touched.voxels.size());
    for (const std::uint16_t index : touched.voxels) {
      MaterialId material = held == nullptr ? kAir : held->chunk->at(place_of(index));
      if (overlay != overlays.end()) {
        const auto over = overlay->second.voxels.find(index);
        if (over != overlay->second.voxels.end()) material = over->second;
      }
      voxels.push_back({index, material});
    }
  }
  const bool blind = std::ranges::any_of(open.edit.guards, [&](const VoxelWrite& guard) {
    return confirmed(chunk_holding(guard.voxel, Lod{})->coord) == nullptr;
  });
  const auto outcome = edits::evaluate(open.edit, base, NoOverrides{});
  bool shows = false;
  if (outcome && !blind) {
    for (const edits::ChunkChanges& changes : outcome->chunks) {
      if (!waits(open, changes.chunk)) continue;
      shows = true;
      Overlay& overlay = overlays[changes.chunk];
      for (const edits::VoxelChange& voxel : changes.voxels) overlay.voxels[voxel.index] = voxel.after;
    }
  }
  return open.revision.has_value() && !shows;
}

std::vector<ChunkKey> Prediction::show(const Overlays& overlays) {
  std::vector<ChunkKey> changed;
  const auto put = [&](const ReceivedChunk& chunk) {
    const ReceivedChunk* const before = store_.look(chunk.key);
    if (before != nullptr && before->revision == chunk.revision && before->hash == chunk.hash) return;
    store_.put(chunk);
    changed.push_back(chunk.key);
  };
  // Restore chunks that are not covered any more; forget chunks evicted from the store.
  for (auto each = confirmed_.begin(); each != confirmed_.end();) {
    const bool gone = !store_.contains(each->second.key);
    if (gone || !overlays.contains(each->first)) {
      if (!gone) put(each->second);
      each = confirmed_.erase(each);
    } else {
      ++each;
    }
  }
  for (const auto& [chunk, overlay] : overlays) {
    const ReceivedChunk* const held = confirmed(chunk);
    if (held == nullptr) continue;
    const ReceivedChunk& truth = confirmed_.try_emplace(chunk, *held).first->second;
    std::vector<Override> voxels;
    for (const auto& [index, material] : overlay.voxels) voxels.push_back({index, material});
    ReceivedChunk shown = truth;
    auto edited = std::make_shared<const Chunk>(truth.chunk->with_overrides(voxels));
    shown.hash = content_hash(*edited);
    shown.chunk = std::move(edited);
    put(shown);
  }
  return changed;
}

}  // namespace talus::client
