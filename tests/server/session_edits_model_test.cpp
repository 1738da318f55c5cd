// Random Views, with and without a base, edits, credit, evictions and delays against a client that does what
// PROTOCOL.md says: when all is quiet, it has every chunk of its View as the source has it.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
#include <set>
#include <string>

#include "seed_of_run.h"
#include "session_bench.h"
#include "views.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

/// What a chunk of the model is: its first voxels.
using Content = std::array<std::uint16_t, 4>;

struct Random {
  std::mt19937_64 bits;
  int below(int end) { return static_cast<int>(bits() % static_cast<std::uint64_t>(end)); }
  bool one_in(int n) { return below(n) == 0; }
};

/// Equal voxels have equal hashes, whatever their revision.
ContentHash hash_of(const Content& content) {
  ContentHash hash{1, 0};
  std::memcpy(&hash.high, content.data(), sizeof(hash.high));
  return hash;
}

constexpr MaterialId kRock{2};

/// Row 0 is land; below it there is rock, and above it air.
Content as_generated(ChunkKey key) {
  const auto material = static_cast<std::uint16_t>(key.coord.y < 0 ? 2 : key.coord.y > 0 ? 0 : 3);
  return {material, material, material, material};
}

class ModelSource final : public ChunkSource {
 public:
  explicit ModelSource(Random& random) : random_{random} {}

  struct Version {
    std::uint64_t revision = 0;
    Content content;
  };

  [[nodiscard]] Version newest(ChunkKey key) const {
    const auto found = history_.find(key);
    return found == history_.end() ? Version{0, as_generated(key)} : found->second.back();
  }

  // ---- as a source
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override { return newest(key).revision; }
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key, server::Version) override {
    const auto kept = kept_.find(key);
    return kept != kept_.end() && kept->second->revision() == revision(key) ? kept->second : nullptr;
  }
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override {
    const auto kept = kept_.find(key);
    return kept != kept_.end() && kept->second->revision() > revision ? kept->second : nullptr;
  }
  [[nodiscard]] std::optional<ChangedVoxels> changes_since(ChunkKey key, std::uint64_t since,
                                                           std::size_t) const override {
    if (since < remembered_from) return std::nullopt;
    ChangedVoxels changed{revision(key), {}};
    const Content& now = newest(key).content;
    std::set<std::uint16_t> indices;
    Content before = as_generated(key);
    for (const Version& version : history_.at(key)) {
      for (std::uint16_t i = 0; i < now.size(); ++i) {
        if (version.revision > since && version.content[i] != before[i]) indices.insert(i);
      }
      before = version.content;
    }
    for (const std::uint16_t i : indices) changed.voxels.push_back({i, MaterialId{now[i]}});
    return changed;
  }
  void edited_chunks(const LevelBox& box, const ColumnFilter& wanted,
                     std::vector<ChunkKey>& found) const override {
    for (const auto& [key, versions] : history_) {
      if (key.lod != box.lod || !box.contains(key.coord) || !wanted(key)) continue;
      const auto untold = untold_.find(key);
      const bool may_miss = untold != untold_.end() && untold->second.previous == 0;
      if (!may_miss || random_.one_in(2)) found.push_back(key);
    }
  }
  [[nodiscard]] MixedRows column(ChunkKey key, server::Version) override {
    if (!columns_known) return {};
    MixedRows rows{0, 0, kRock};
    for (const auto& [edited, versions] : history_) {
      ChunkKey row = key;
      row.coord.y = edited.coord.y;
      if (row != edited) continue;
      rows.first = std::min(rows.first, edited.coord.y);
      rows.last = std::max(rows.last, edited.coord.y);
    }
    return rows;
  }
  [[nodiscard]] int columns_together() const override { return 2; }
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency,
                                   server::Version) override {
    std::size_t accepted = 0;
    for (; accepted < keys.size() && jobs_.size() + made_.size() < places; ++accepted) {
      jobs_[keys[accepted]] = mailbox;
    }
    return accepted;
  }
  void hasten(ClientId, std::span<const ChunkKey>) override {}
  void cancel(ClientId, std::span<const ChunkKey> keys) override {
    for (const ChunkKey key : keys) {
      jobs_.erase(key);
      if (random_.one_in(2)) made_.erase(key);  // else its answer is on its way
    }
  }
  void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override {
    watcher_ = mailbox;
    boxes_.assign(boxes.begin(), boxes.end());
  }
  void submit_heights(const MailboxPtr&, std::uint64_t, HeightsQuery) override {}
  void cancel_heights(ClientId, std::uint64_t) override {}

  // ---- what happens to it
  bool columns_known = false;
  std::size_t places = 1000;
  std::uint64_t remembered_from = 0;  // changes since older revisions are forgotten

  /// The revision is raised now, and the change told some time later.
  void edit(ChunkKey key) {
    const Version before = newest(key);
    Content after = before.content;
    if (random_.one_in(4)) {
      after = as_generated(key);  // undone
    } else {
      for (int voxels = 1 + random_.below(3); voxels > 0; --voxels) {
        after[static_cast<std::size_t>(random_.below(4))] = static_cast<std::uint16_t>(random_.below(6));
      }
    }
    if (after == before.content) return;
    history_[key].push_back({++last_revision_, after});
    const auto [untold, is_new] = untold_.try_emplace(key, ChunkChange{key, before.revision, last_revision_});
    if (!is_new) untold->second.revision = last_revision_;
  }
  void tell(bool any) {
    const auto untold = std::exchange(untold_, {});
    if (watcher_ == nullptr) return;
    if (any) return watcher_->put_changes(nullptr);
    std::vector<ChunkChange> changes;
    bool watched = false;
    for (const auto& [key, change] : untold) {
      changes.push_back(change);
      for (const LevelBox& box : boxes_) {
        watched = watched || (box.lod == key.lod && box.contains(key.coord));
      }
    }
    if (watched) watcher_->put_changes(std::make_shared<const std::vector<ChunkChange>>(std::move(changes)));
  }
  /// A generator looks at the newest version now, and answers some time later.
  void make_one() {
    if (jobs_.empty()) return;
    auto job = std::next(jobs_.begin(), random_.below(static_cast<int>(jobs_.size())));
    const ChunkKey key = job->first;
    EncodedChunkPtr chunk = encoded(key);
    if (!random_.one_in(4)) kept_[key] = chunk;
    made_[key] = {job->second, std::move(chunk)};
    jobs_.erase(job);
  }
  void answer_one() {
    if (made_.empty()) return;
    auto answer = std::next(made_.begin(), random_.below(static_cast<int>(made_.size())));
    answer->second.first->put(ChunkReady{answer->first, answer->second.second});
    made_.erase(answer);
  }
  void evict_one() {
    if (!kept_.empty()) kept_.erase(std::next(kept_.begin(), random_.below(static_cast<int>(kept_.size()))));
  }
  [[nodiscard]] bool works() const { return !jobs_.empty() || !made_.empty() || !untold_.empty(); }

 private:
  EncodedChunkPtr encoded(ChunkKey key) {
    const Version version = newest(key);
    // Some are so large that they pause before they are sent again.
    const std::size_t more = random_.one_in(5) ? Delivery::kMaxSmallUpdateBytes : 0;
    std::vector<std::byte> payload(sizeof(Content) + more + static_cast<std::size_t>(random_.below(300)));
    std::memcpy(payload.data(), version.content.data(), sizeof(Content));
    const bool uniform = version.revision == 0 && key.coord.y != 0;
    return std::make_shared<const EncodedChunk>(hash_of(version.content), payload, version.revision, uniform);
  }

  Random& random_;
  std::uint64_t last_revision_ = 0;
  std::map<ChunkKey, std::vector<Version>> history_;  // of edited chunks, oldest first
  std::map<ChunkKey, EncodedChunkPtr> kept_;
  std::map<ChunkKey, MailboxPtr> jobs_;
  std::map<ChunkKey, std::pair<MailboxPtr, EncodedChunkPtr>> made_;
  std::map<ChunkKey, ChunkChange> untold_;
  MailboxPtr watcher_;
  std::vector<LevelBox> boxes_;
};

constexpr std::uint16_t kRows = 1;
const std::vector<ViewRing> kRings{{Lod::of(1), 4}};

/// A session, and a client that keeps to PROTOCOL.md.
class Conversation {
 public:
  explicit Conversation(std::uint64_t seed) : random_{std::mt19937_64{seed}} {
    limits_.window_bytes = 1 + static_cast<std::uint64_t>(random_.below(2000));
    limits_.queued_bytes = 5000;
    limits_.view_base = true;
    receive([&](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
      return wire::CreateHello(builder, protocol::kOldestProtocol, protocol::kProtocolVersion, codecs);
    });
    (void)read(SIZE_MAX);
  }

  void step() {
    switch (random_.below(16)) {
      case 0:
        return say_view();
      case 1:
        return apply_view();
      case 2:
      case 3:
      case 4:
        return edit();
      case 5:
        return tell();
      case 6:
      case 7:
        return source_.make_one();
      case 8:
        return source_.answer_one();
      case 9:
        return take_mail();
      case 10:
        source_.evict_one();
        source_.columns_known = random_.one_in(2);
        return;
      case 11:
        source_.remembered_from = random_.one_in(3) ? source_.revision(any_key()) : 0;
        source_.places = static_cast<std::size_t>(random_.below(20));
        if (source_.places > 0) mailbox_->put(QueueHasRoom{});
        return;
      case 12:
        return give_credit();
      case 13:
        return get_chunk(any_key());
      default:
        clock_.advance(std::chrono::milliseconds{random_.below(100)});
        (void)read(static_cast<std::size_t>(random_.below(600)));
    }
  }

  /// Nobody edits any more, and everything comes.
  void calm_down() {
    source_.places = 1000;
    mailbox_->put(QueueHasRoom{});
    apply_view();
    for (int quiet = 0; quiet < 3;) {
      const bool worked = source_.works();
      source_.tell(false);
      source_.make_one();
      source_.answer_one();
      take_mail();
      give_credit();
      quiet = read(SIZE_MAX) || worked || wait() ? 0 : quiet + 1;
    }
  }

  /// What of the client's View is not as the source has it; empty: nothing.
  [[nodiscard]] std::string difference() const {
    for (const ChunkKey key : view_) {
      const auto newest = source_.newest(key);
      const auto held = holds_.find(key);
      if (held == holds_.end()) return to_string(key) + " did not come";
      if (held->second.revision != newest.revision || held->second.content != newest.content) {
        return to_string(key) + " is of revision " + std::to_string(held->second.revision) + ", not " +
               std::to_string(newest.revision);
      }
    }
    if (!open_.empty()) return "a request is not answered";
    return fault_;
  }

  [[nodiscard]] int broadcasts() const { return broadcasts_; }

 private:
  template <typename Make>
  void receive(Make&& make) {
    session_.receive(protocol::make_frame(make));
    session_.pump();
  }
  [[nodiscard]] ChunkKey any_key() {
    const int lod = random_.one_in(4) ? 1 : 0;
    return {{random_.below(4), random_.below(3) - 1, random_.below(2)}, Lod::of(lod)};
  }
  void edit() {
    for (int chunks = 1 + random_.below(2); chunks > 0; --chunks) source_.edit(any_key());
  }
  void tell() { source_.tell(random_.one_in(10)); }

  void say_view() {
    const std::int64_t x = random_.one_in(8) ? std::int64_t{1} << 40 : random_.below(4);
    const auto radius = static_cast<std::uint16_t>(random_.below(2));
    const auto keys = chunks_in_view({{x, 0, 0}, {}, radius, kRows, kRings});
    view_ = {keys.begin(), keys.end()};
    // What leaves may be kept for later, and is then named.
    for (const auto& [key, held] : holds_) {
      if (!view_.contains(key)) left_[key] = held;
    }
    std::erase_if(holds_, [&](const auto& each) { return !view_.contains(each.first); });
    const bool base = random_.one_in(2);
    if (std::exchange(has_base_, base) && !base) {
      for (const auto& [key, held] : std::exchange(holds_, {})) left_[key] = held;
    }
    named_.clear();
    receive([&](auto& builder) {
      std::vector<wire::KnownChunk> known;
      for (const auto& [key, kept] : left_) {
        if (!view_.contains(key) || holds_.contains(key)) continue;
        named_[key] = kept.content;
        const ContentHash hash = hash_of(kept.content);
        known.push_back({on_wire(key), wire::Hash128{hash.low, hash.high}});
      }
      const wire::Voxel centre{x * kChunkSize, 0, 0};
      std::vector<wire::LodRing> rings;
      for (const ViewRing& ring : kRings) {
        rings.emplace_back(static_cast<std::uint8_t>(ring.lod.value()),
                           static_cast<std::uint16_t>(ring.radius));
      }
      const auto ring_list = builder.CreateVectorOfStructs(rings);
      const auto list = builder.CreateVectorOfStructs(known);
      return wire::CreateView(builder, &centre, nullptr, radius, kRows, ring_list, list, 0, false, base);
    });
    // Only now, so that it names other versions that it has kept.
    for (const ChunkKey key : base ? view_ : std::set<ChunkKey>{}) {
      holds_.try_emplace(key, ModelSource::Version{0, as_generated(key)});
    }
  }
  static wire::ChunkKey on_wire(ChunkKey key) {
    return {key.coord.x, key.coord.y, key.coord.z, static_cast<std::uint8_t>(key.lod.value())};
  }
  void apply_view() {
    (void)session_.apply_view();
    session_.pump();
  }
  void take_mail() {
    session_.take_mail();
    session_.pump();
  }
  void give_credit() {
    receive([&](auto& builder) { return wire::CreateCredit(builder, taken_bytes_); });
  }
  void get_chunk(ChunkKey key) {
    const std::uint32_t id = ++last_id_;
    const bool known = random_.one_in(3);
    const Content content = holds_.contains(key) ? holds_.at(key).content : as_generated(key);
    open_[id] = {key, known ? std::optional{content} : std::nullopt};
    receive([&](auto& builder) {
      const ContentHash hash = hash_of(content);
      const std::vector<wire::ChunkRequest> requests{
          {id, on_wire(key), known, wire::Hash128{hash.low, hash.high}}};
      return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
    });
  }

  /// Until the session has something to say. Whether it will, and nothing else need happen.
  bool wait() {
    const Clock::time_point at = session_.sendable_at();
    if (at == Clock::time_point::max()) return false;
    if (at > clock_.now()) clock_.advance(at - clock_.now());
    return true;
  }
  /// Whether anything came.
  bool read(std::size_t enough_bytes) {
    const auto frames = cut(session_.take_output(enough_bytes));
    session_.written();
    session_.pump();
    for (const protocol::Frame& frame : frames) on(**protocol::read_message(frame), frame.size());
    return !frames.empty();
  }

  void on(const wire::Message& message, std::size_t frame_bytes) {
    if (const auto* chunk = message.body_as_Chunk()) {
      taken_bytes_ += frame_bytes;
      open_.erase(chunk->id());
      Content content;
      std::memcpy(content.data(), chunk->payload()->data(), sizeof(content));
      have(key_of(*chunk->key()), {chunk->revision(), content});
    } else if (const auto* unchanged = message.body_as_Unchanged()) {
      const ChunkKey key = key_of(*unchanged->key());
      const ContentHash hash{unchanged->hash()->low(), unchanged->hash()->high()};
      std::optional<Content> content;
      if (unchanged->id() != 0) {
        content = open_.at(unchanged->id()).second;
        open_.erase(unchanged->id());
      } else if (holds_.contains(key) && hash_of(holds_.at(key).content) == hash) {
        content = holds_.at(key).content;
      } else if (named_.contains(key)) {
        content = named_.at(key);
      }
      if (!content || hash_of(*content) != hash) {
        // The server confirms what a View before has named too, and the client may hold another since.
        if (view_.contains(key)) need(key, unchanged->revision());
        return ask_again();
      }
      have(key, {unchanged->revision(), *content});
    } else if (const auto* column = message.body_as_UniformColumn()) {
      for (const wire::UniformRun* run : *column->runs()) {
        for (std::int32_t y = run->first_y(); y <= run->last_y(); ++y) {
          const ChunkKey key{{column->x(), y, column->z()}, Lod::of(column->lod())};
          const Content content{run->material(), run->material(), run->material(), run->material()};
          have(key, {0, content});
        }
      }
    } else if (const auto* broadcast = message.body_as_EditBroadcast()) {
      ++broadcasts_;
      apply(*broadcast);
    } else if (const auto* error = message.body_as_Error()) {
      open_.erase(error->request_id());  // overloaded, as the source was full
    }
    ask_again();
  }
  /// Asks for the chunk until it has this revision of it, or a higher one.
  void need(ChunkKey key, std::uint64_t revision) { needs_[key] = std::max(needs_[key], revision); }
  void ask_again() {
    std::erase_if(needs_, [&](const auto& need) {
      const auto held = holds_.find(need.first);
      return !view_.contains(need.first) || (held != holds_.end() && held->second.revision >= need.second);
    });
    for (const auto& [key, revision] : needs_) {
      const auto asks = [&, at = key](const auto& request) { return request.second.first == at; };
      if (std::none_of(open_.begin(), open_.end(), asks)) get_chunk(key);
    }
  }
  void have(ChunkKey key, const ModelSource::Version& version) {
    if (!view_.contains(key)) return;
    const auto held = holds_.find(key);
    if (held == holds_.end() || held->second.revision <= version.revision) holds_[key] = version;
  }
  void apply(const wire::EditBroadcast& broadcast) {
    const auto held = holds_.find(key_of(*broadcast.key()));
    if (held == holds_.end() || broadcast.revision() <= held->second.revision) return;
    if (broadcast.previous_revision() > held->second.revision) return need(held->first, broadcast.revision());
    const auto voxels = edits::decode_runs(
        {reinterpret_cast<const std::byte*>(broadcast.runs()->data()), broadcast.runs()->size()});
    for (const Override& voxel : voxels.value())
      held->second.content.at(voxel.index) = to_integer(voxel.material);
    held->second.revision = broadcast.revision();
  }

  Random random_;
  ModelSource source_{random_};
  ManualClock clock_{std::chrono::sys_seconds{std::chrono::seconds{1'700'000'000}}};
  MemoryBudget memory_{0};
  Metrics metrics_;
  SessionLimits limits_ = test_limits();
  WorldInfo world_;
  CurrentRates rates_;
  FlowUses flows_;
  Access settings_;
  AccessControl access_{settings_, *load_keys(settings_)};
  MailboxPtr mailbox_ = std::make_shared<Mailbox>(ClientId{1}, [] {});
  Session session_{
      {limits_, world_, source_, memory_, metrics_, access_, rates_, flows_, clock_}, mailbox_, {}};

  std::set<ChunkKey> view_;  // the newest that the client said
  bool has_base_ = false;    // of that
  std::map<ChunkKey, ModelSource::Version> holds_;
  std::map<ChunkKey, ModelSource::Version> left_;
  std::map<ChunkKey, Content> named_;        // by the newest View
  std::map<ChunkKey, std::uint64_t> needs_;  // by GetChunks
  std::map<std::uint32_t, std::pair<ChunkKey, std::optional<Content>>> open_;
  std::uint32_t last_id_ = 0;
  std::uint64_t taken_bytes_ = 0;
  int broadcasts_ = 0;
  std::string fault_;
};

}  // namespace

TEST_CASE("after any edits an idle client has its View as the source has it") {
  // TALUS_SEED repeats a run, or with TALUS_RUNS so many from that seed on.
  const char* const said_seed = std::getenv("TALUS_SEED");
  const char* const said_runs = std::getenv("TALUS_RUNS");
  const std::uint64_t first = seed_of_run();
  const std::uint64_t runs = said_runs != nullptr ? std::stoull(said_runs) : said_seed != nullptr ? 1 : 7000;
  int broadcasts = 0;
  int wrong = 0;
  for (std::uint64_t run = 0; run < runs; ++run) {
    const std::uint64_t seed = first + run;
    Conversation conversation{seed};
    for (int steps = 0; steps < 150; ++steps) conversation.step();
    conversation.calm_down();
    const std::string difference = conversation.difference();
    broadcasts += conversation.broadcasts();
    if (difference.empty()) continue;
    if (++wrong <= 3) UNSCOPED_INFO("TALUS_SEED=" << seed << ": " << difference);
  }
  UNSCOPED_INFO(wrong << " of " << runs << " runs, from seed " << first);
  CHECK(wrong == 0);
  CHECK((broadcasts > 0 || runs == 1));
}
