#include "local_chunks.h"

#include <algorithm>
#include <random>
#include <utility>

namespace talus::client {

LocalChunks::LocalChunks(Host& host, std::weak_ptr<void> alive, const asio::any_io_executor& executor,
                         const Options& options, ContentHash fingerprint)
    : host_{host},
      alive_{std::move(alive)},
      gate_{std::make_shared<Gate>(executor)},
      maker_{options.maker},
      kept_files_{options.kept_files},
      fingerprint_{fingerprint},
      proofs_{options.reconnect.seed ? *options.reconnect.seed : std::random_device{}()} {}

template <typename Call>
auto LocalChunks::later(Call call) {
  // Holds neither the client, which would then outlive the caller's, nor a call that is no longer wanted.
  return [weak = weak_from_this(), alive = alive_, call = std::move(call)](auto&&... values) mutable {
    const auto client = alive.lock();
    const auto self = weak.lock();
    if (client && self && !self->stopped_) call(*self, std::forward<decltype(values)>(values)...);
  };
}

void LocalChunks::stop() {
  stopped_ = true;
  active_ = false;
  gate_->close();
  cancel_open_->store(true);
  for (const auto& [id, batch] : batches_) batch.cancel->store(true);
}

// ---- opening the world

void LocalChunks::start() {
  gate_->post(later([](LocalChunks& self) {
    auto kept = self.kept_files_ ? self.kept_files_(self.fingerprint_) : nullptr;
    if (self.stopped_) return;
    if (kept == nullptr) return self.fetch({""});
    self.files_.keep(std::move(kept));
    self.open(false);
  }));
}

void LocalChunks::fetch(std::set<std::string> names) {
  to_fetch_ = std::move(names);
  fetch_next();
}

void LocalChunks::fetch_next() {
  if (to_fetch_.empty()) return open(true);
  const std::string name = std::move(to_fetch_.extract(to_fetch_.begin()).value());
  if (const std::string why = files_.begin(name); !why.empty()) return fail(why);
  ask_part();
}

void LocalChunks::ask_part() {
  host_.ask(FileRequest{
      files_.name(), files_.offset(),
      later([](LocalChunks& self, const Result<FileRequest::Part>& part) { self.take_part(part); })});
}

void LocalChunks::take_part(const Result<FileRequest::Part>& part) {
  if (!part) {
    return fail((files_.name().empty() ? "the world's file" : "file '" + files_.name() + "'") +
                " did not come: " + part.error().message);
  }
  host_.counts().file_bytes += part->bytes.size();
  const auto complete = files_.take(*part);
  if (!complete) return fail(complete.error());
  if (*complete) {
    fetch_next();
  } else {
    ask_part();
  }
}

void LocalChunks::open(bool fetched) {
  using World = tl::expected<std::shared_ptr<LocalWorld>, ChunkMaker::OpenFailure>;
  auto take = later([fetched](LocalChunks& self, World world) { self.opened(fetched, std::move(world)); });
  maker_->open(files_.files(), cancel_open_, [gate = gate_, take = std::move(take)](World world) mutable {
    gate->post([take = std::move(take), world = std::move(world)]() mutable { take(std::move(world)); });
  });
}

void LocalChunks::opened(bool fetched,
                         tl::expected<std::shared_ptr<LocalWorld>, ChunkMaker::OpenFailure> world) {
  const bool is_other = world && (*world)->fingerprint() != fingerprint_;
  if (!fetched && (is_other || (!world && world.error().missing_files.empty()))) {
    files_.keep(std::make_shared<const WorldFiles>());  // the caller kept other files
    return fetch({""});
  }
  if (!world && !world.error().missing_files.empty()) return fetch(std::move(world.error().missing_files));
  if (!world) return fail("the world cannot be opened: " + world.error().message);
  if (is_other) {
    return fail("the published world is " + to_string((*world)->fingerprint()) +
                " here, as by another version of the generator; the server's is " + to_string(fingerprint_));
  }
  world_ = std::move(*world);
  host_.world_opened(fetched ? files_.files() : nullptr);
  files_ = {};
}

void LocalChunks::fail(const std::string& why) {
  host_.cannot_generate(why);
}

// ---- making chunks

void LocalChunks::begin_session() {
  active_ = true;
  proofs_.begin();
  edits_.clear();
  announced_.clear();
  view_changed();
}

void LocalChunks::view_changed() {
  const ViewShape& shape = host_.tracker().shape();
  for (const auto& [id, batch] : batches_) {
    if (std::none_of(batch.keys.begin(), batch.keys.end(),
                     [&](const ChunkKey& k) { return shape.covers(k); }))
      batch.cancel->store(true);
  }
  for (const ChunkKey& key : edits_.keys()) {
    if (shape.covers(key)) continue;
    edits_.erase(key);
    host_.pass_by(key);
  }
  pump_soon();
}

void LocalChunks::announced(const std::vector<ReceivedChunk>& known) {
  announced_.clear();
  for (const ReceivedChunk& chunk : known) announced_.insert(chunk.key);
}

void LocalChunks::all_edits_came() {
  announced_.clear();
  pump_soon();
}

bool LocalChunks::add_edit(const ChunkKey& key, std::uint64_t previous, std::uint64_t revision,
                           const std::vector<Override>& voxels) {
  const bool is_planned = announced_.erase(key) == 0 && !host_.tracker().has_current(key);
  if (!edits_.add(key, previous, revision, voxels)) return false;
  if (!is_planned) pump_soon();
  return true;
}

void LocalChunks::came(const ChunkKey& key, std::uint64_t revision) {
  const auto* edits = edits_.find(key);
  if (edits != nullptr && edits->revision <= revision) edits_.erase(key);
  announced_.erase(key);
}

void LocalChunks::pump_soon() {
  plan_is_stale_ = true;
  if (!active_ || std::exchange(pump_posted_, true)) return;
  gate_->post(later([](LocalChunks& self) {
    self.pump_posted_ = false;
    self.pump();
  }));
}

bool LocalChunks::wanted(const ChunkKey& key) const {
  const ViewTracker& tracker = host_.tracker();
  return tracker.shape().covers(key) && (!tracker.has_current(key) || has_edits(key)) &&
         !announced_.contains(key) && !making_.contains(key);
}

void LocalChunks::pump() {
  if (!active_ || !host_.tracker().view()) return;
  if (std::exchange(plan_is_stale_, false)) plan();
  while (active_ && making_.size() < kMaxInFlight && !queue_.empty()) {
    auto keys = queue_.next();
    std::erase_if(keys, [this](const ChunkKey& key) { return !wanted(key); });
    if (!keys.empty()) start(std::move(keys));
  }
  if (active_) host_.made_some();
}

void LocalChunks::plan() {
  const ViewTracker& tracker = host_.tracker();
  std::vector<ChunkKey> chunks = tracker.missing();
  for (const ChunkKey& key : edits_.keys()) {
    if (tracker.has_current(key)) chunks.push_back(key);
  }
  std::vector<ReceivedChunk> held;
  std::erase_if(chunks, [&](const ChunkKey& key) {
    if (!wanted(key)) return true;
    const auto chunk = has_edits(key) ? std::nullopt : tracker.held(key);
    if (!chunk || chunk->revision != 0) return false;
    held.push_back(*chunk);
    return true;
  });
  queue_ = MakeQueue{*tracker.view(), chunks};
  for (const ReceivedChunk& chunk : held) {
    // The previous callback may have set another View.
    if (active_ && wanted(chunk.key)) host_.deliver_local(chunk, false);
  }
}

void LocalChunks::start(std::vector<ChunkKey> keys) {
  const std::uint64_t id = ++last_batch_;
  const auto cancel = std::make_shared<std::atomic<bool>>(false);
  making_.insert(keys.begin(), keys.end());
  batches_.emplace(id, Batch{keys, cancel});
  using Made = tl::expected<std::vector<MadeChunk>, std::string>;
  world_->make(std::move(keys), cancel, [gate = gate_, take = later([id](LocalChunks& self, Made made) {
                                                         self.take(id, std::move(made));
                                                       })](Made made) mutable {
    gate->post([take = std::move(take), made = std::move(made)]() mutable { take(std::move(made)); });
  });
}

void LocalChunks::take(std::uint64_t batch, tl::expected<std::vector<MadeChunk>, std::string> made) {
  const auto ended = batches_.extract(batch);
  if (ended.empty()) return;
  std::unordered_set<ChunkKey> asked;
  for (const ChunkKey& key : ended.mapped().keys) {
    asked.insert(key);
    making_.erase(key);
  }
  if (!made) return fail("chunks cannot be made: " + made.error());
  if (made->size() < asked.size()) plan_is_stale_ = true;  // cancelled; some may be wanted again
  std::vector<Proofs::Proof> mixed;
  for (const MadeChunk& each : *made) {
    if (active_ && asked.erase(each.key) == 1 && wanted(each.key)) deliver(each, mixed);
  }
  if (!active_) return;
  const bool last = queue_.empty() && batches_.empty();
  for (const Proofs::Proof& proof : proofs_.made(made->size(), std::move(mixed), last)) prove(proof);
  pump();
}

void LocalChunks::deliver(const MadeChunk& made, std::vector<Proofs::Proof>& mixed) {
  if (const auto* edits = edits_.find(made.key)) {
    auto edited = std::make_shared<const Chunk>(made.chunk->with_overrides(edits->voxels));
    const ContentHash hash = content_hash(*edited);
    const std::uint64_t revision = edits->revision;
    edits_.erase(made.key);
    return host_.deliver_local({made.key, revision, hash, std::move(edited)}, true);
  }
  if (!made.chunk->is_uniform()) mixed.push_back({made.key, made.hash});
  host_.deliver_local({made.key, 0, made.hash, made.chunk}, true);
}

// ---- comparing them

void LocalChunks::prove(const Proofs::Proof& proof) {
  ++host_.counts().proofs;
  host_.ask(ChunkRequest{
      proof.key, proof.hash,
      later([proof](LocalChunks& self, const Result<ReceivedChunk>& answer) { self.judge(proof, answer); })});
}

void LocalChunks::judge(const Proofs::Proof& proof, const Result<ReceivedChunk>& answer) {
  if (answer && (answer->unchanged() || answer->hash == proof.hash)) return;
  if (answer && answer->revision == 0) return differs(proof.key);
  proofs_.repeat();  // edited since, or refused
}

void LocalChunks::differs(const ChunkKey& key) {
  ++host_.counts().failed_proofs;
  fail("chunk " + to_string(key) + " differs from the server's");
}

}  // namespace talus::client
