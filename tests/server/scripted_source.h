// A chunk source without threads: a test says which chunks are in memory, which submissions are refused, and
// when each answer comes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "chunks/chunk_source.h"

namespace talus::server {

/// A chunk whose hash tells its key and revision. Its payload is no chunk: sessions do not look.
[[nodiscard]] inline EncodedChunkPtr scripted_chunk(ChunkKey key, std::uint64_t revision = 0,
                                                    std::size_t payload_bytes = 100) {
  return std::make_shared<const EncodedChunk>(ContentHash{std::hash<ChunkKey>{}(key), revision},
                                              std::vector<std::byte>(payload_bytes), revision);
}
[[nodiscard]] inline EncodedChunkPtr uniform_chunk(ChunkKey key) {
  return std::make_shared<const EncodedChunk>(ContentHash{std::hash<ChunkKey>{}(key), 0},
                                              std::vector<std::byte>(4), 0, true);
}

class ScriptedSource final : public ChunkSource {
 public:
  // ---- the script
  std::map<ChunkKey, EncodedChunkPtr> in_memory;  // the newest version of each
  MixedRows rows;                                 // of every column
  std::function<MixedRows(ChunkKey)> rows_of;     // of a chunk's column; empty: `rows`
  std::size_t queue_places = SIZE_MAX;            // submissions beyond them are refused
  std::size_t payload_bytes = 100;
  std::optional<map::Tile> drawn;  // the tile of the map that is in memory
  int together = 1;                // columns along a square whose chunks are asked for together
  bool little_to_do = false;       // for its threads

  // ---- what was asked of it
  std::map<ChunkKey, MailboxPtr> waiting;
  std::map<std::uint64_t, MailboxPtr> waiting_heights;  // by ticket
  std::map<std::uint64_t, map::Tile> waiting_maps;      // those of them that are maps
  MailboxPtr last_mailbox;                              // of a submission, refused or not
  std::size_t submitted = 0;
  std::vector<std::vector<ChunkKey>> submissions;
  std::set<ChunkKey> wanted_soon;  // when they were submitted, or since
  std::size_t refused = 0;
  std::size_t revisions_asked = 0;
  std::map<ChunkKey, std::uint64_t> revisions;  // of chunks whose newest version may not be in memory
  /// What changes_since() answers; empty: nothing is known.
  std::function<std::optional<ChangedVoxels>(ChunkKey, std::uint64_t since)> changes;
  MailboxPtr watcher;  // of set_wanted() or set_watched()
  std::vector<LevelBox> wanted;
  bool wants_chunks = false;                  // set_wanted() was the last of them
  mutable std::vector<ChunkKey> looked_into;  // columns in which edited chunks were looked for

  [[nodiscard]] EncodedChunkPtr find(ChunkKey key, Version = Version::edited) override {
    const auto found = in_memory.find(key);
    const auto said = revisions.find(key);
    if (found == in_memory.end()) return nullptr;
    return said != revisions.end() && said->second > found->second->revision() ? nullptr : found->second;
  }
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override {
    EncodedChunkPtr newest = in_memory.contains(key) ? in_memory.at(key) : nullptr;
    return newest != nullptr && newest->revision() > revision ? newest : nullptr;
  }
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override {
    ++const_cast<ScriptedSource*>(this)->revisions_asked;
    const auto said = revisions.find(key);
    const auto kept = in_memory.find(key);
    return std::max(said == revisions.end() ? 0 : said->second,
                    kept == in_memory.end() ? 0 : kept->second->revision());
  }
  [[nodiscard]] std::optional<ChangedVoxels> changes_since(ChunkKey key, std::uint64_t since,
                                                           std::size_t max_voxels) const override {
    auto changed = changes ? changes(key, since) : std::nullopt;
    return changed && changed->voxels.size() <= max_voxels ? changed : std::nullopt;
  }
  void edited_chunks(const LevelBox& box, const ColumnFilter& filter,
                     std::vector<ChunkKey>& found) const override {
    std::set<ChunkKey> edited;
    for (const auto& [key, revision] : revisions) {
      if (revision > 0) edited.insert(key);
    }
    for (const auto& [key, chunk] : in_memory) {
      if (chunk->revision() > 0) edited.insert(key);
    }
    for (const ChunkKey key : edited) {
      if (key.lod != box.lod || !box.contains(key.coord) || !filter(key)) continue;
      looked_into.push_back(key);
      found.push_back(key);
    }
  }
  [[nodiscard]] MixedRows column(ChunkKey key, Version) override { return rows_of ? rows_of(key) : rows; }

  [[nodiscard]] int columns_together() const override { return together; }
  [[nodiscard]] bool has_little_to_do() const override { return little_to_do; }
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency urgency,
                                   Version) override {
    std::size_t accepted = 0;
    last_mailbox = mailbox;
    submissions.emplace_back(keys.begin(), keys.end());
    for (const ChunkKey key : keys) {
      if (waiting.size() >= queue_places) break;
      waiting[key] = mailbox;
      if (urgency == Urgency::soon) wanted_soon.insert(key);
      ++accepted;
    }
    submitted += accepted;
    if (accepted < keys.size()) ++refused;
    return accepted;
  }
  void hasten(ClientId, std::span<const ChunkKey> keys) override {
    wanted_soon.insert(keys.begin(), keys.end());
  }
  void cancel(ClientId, std::span<const ChunkKey> keys) override {
    for (const ChunkKey key : keys) waiting.erase(key);
  }
  void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override {
    watcher = boxes.empty() ? nullptr : mailbox;
    wanted.assign(boxes.begin(), boxes.end());
    wants_chunks = !boxes.empty();
  }
  void set_watched(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override {
    set_wanted(mailbox, boxes);
    wants_chunks = false;
  }
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) override {
    waiting_heights[ticket] = mailbox;
    heights_[ticket] = query.columns.size();
    if (query.tile) waiting_maps[ticket] = *query.tile;
    bodies_[ticket] = std::move(query.body);
  }
  void cancel_heights(ClientId, std::uint64_t ticket) override {
    waiting_heights.erase(ticket);
    waiting_maps.erase(ticket);
  }
  [[nodiscard]] PicturePtr find_map(const map::Tile& tile) override {
    return drawn.has_value() && *drawn == tile ? std::make_shared<const Picture>(Picture{"a map"}) : nullptr;
  }

  // ---- answers: they lie in the mailbox until the session takes them
  /// The chunk's newest version where one is in memory, else revision 0.
  void answer(ChunkKey key) {
    EncodedChunkPtr chunk = find(key);
    mail(key, chunk != nullptr ? std::move(chunk) : scripted_chunk(key, 0, payload_bytes));
  }
  void mail(ChunkKey key, ChunkAnswer answer) {
    const MailboxPtr mailbox = std::exchange(waiting.at(key), nullptr);
    waiting.erase(key);
    mailbox->put(ChunkReady{key, std::move(answer)});
  }
  void fail(ChunkKey key) { mail(key, tl::make_unexpected(GenerationError{"out of memory"})); }
  void answer_all() {
    while (!waiting.empty()) answer(waiting.begin()->first);
  }
  /// Every height is 256.
  void answer_heights(std::uint64_t ticket) {
    HeightsResult found{.heights_fx = std::vector<std::int32_t>(heights_[ticket], 256)};
    if (const HeightsBody& body = bodies_[ticket]) found = {.body = body(found)};
    const MailboxPtr mailbox = waiting_heights.at(ticket);
    mailbox->put(HeightsReady{ticket, std::move(found)});
    waiting_heights.erase(ticket);
  }
  void answer_map(std::uint64_t ticket) {
    const MailboxPtr mailbox = waiting_heights.at(ticket);
    HeightsResult found;
    found.picture = std::make_shared<const Picture>(Picture{"a map"});
    mailbox->put(HeightsReady{ticket, std::move(found)});
    waiting_heights.erase(ticket);
    waiting_maps.erase(ticket);
    mailbox->wake();
  }

 private:
  std::map<std::uint64_t, std::size_t> heights_;  // how many
  std::map<std::uint64_t, HeightsBody> bodies_;
};

}  // namespace talus::server
