#include <talus/saves/save_file.h>

#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "database.h"
#include "save_form.h"

namespace talus::saves {
namespace {

namespace fs = std::filesystem;
using Kind = SaveError::Kind;

}  // namespace

struct SaveFile::Parts {
  std::unique_ptr<Database> database;  // outlives the statements
  SavedWorld world;
  SaveState state;
  Access access = Access::write;
  std::optional<Statement> chunks;
  std::optional<Statement> put;
  std::optional<Statement> remove;
  std::optional<Statement> set_state;
};

bool is_database(const fs::path& file) {
  constexpr std::string_view kBegin{"SQLite format 3\0", 16};
  std::array<char, kBegin.size()> begin{};
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return false;
  std::ifstream bytes{file, std::ios::binary};
  bytes.read(begin.data(), begin.size());
  return bytes.gcount() == static_cast<std::streamsize>(begin.size()) &&
         std::string_view{begin.data(), begin.size()} == kBegin;
}

SaveFile::SaveFile(std::unique_ptr<Parts> parts) : parts_{std::move(parts)} {}
SaveFile::~SaveFile() = default;
SaveFile::SaveFile(SaveFile&&) noexcept = default;
SaveFile& SaveFile::operator=(SaveFile&&) noexcept = default;

Result<SaveFile> SaveFile::create(const fs::path& file, const SavedWorld& world) {
  auto parts = std::make_unique<Parts>();  // before there is a file
  parts->world = world;
  std::error_code code;
  const bool was_there = fs::exists(file, code);
  auto database = Database::open(file, Database::Mode::create);
  auto written = database ? write_world(**database, world) : Result<void>{tl::unexpected{database.error()}};
  if (!written) {
    if (database) {
      database->reset();
      // It may have been made by another program since.
      if (!was_there && written.error().kind != Kind::exists) fs::remove(file, code);
    }
    return tl::unexpected{std::move(written.error())};
  }
  parts->database = *std::move(database);
  return SaveFile{std::move(parts)};
}

Result<SaveFile> SaveFile::open(const fs::path& file, Access access) {
  auto database = Database::open(file, access == Access::read ? Database::Mode::read : Database::Mode::write);
  if (!database) return tl::unexpected{std::move(database.error())};
  if (auto form = check_form(**database); !form) return tl::unexpected{std::move(form.error())};
  // A folder in which no journal can be made is found now, and not by the first edit.
  if (access == Access::write) {
    auto writes = (*database)->run("UPDATE state SET revision = revision");
    if (!writes) return tl::unexpected{std::move(writes.error())};
  }
  auto world = read_world_of(**database);
  if (!world) return tl::unexpected{std::move(world.error())};
  const auto state = read_state_of(**database);
  if (!state) return tl::unexpected{state.error()};
  auto parts = std::make_unique<Parts>();
  parts->database = *std::move(database);
  parts->world = *std::move(world);
  parts->state = *state;
  parts->access = access;
  return SaveFile{std::move(parts)};
}

const SavedWorld& SaveFile::world() const {
  return parts_->world;
}
const SaveState& SaveFile::state() const {
  return parts_->state;
}
const fs::path& SaveFile::path() const {
  return parts_->database->file();
}

Result<std::optional<SavedChunk>> SaveFile::next_chunk() {
  const auto fits = [](std::int64_t number) {
    return number >= std::numeric_limits<std::int32_t>::min() &&
           number <= std::numeric_limits<std::int32_t>::max();
  };
  if (!parts_->chunks) {
    auto rows = parts_->database->prepare("SELECT x, y, z, runs FROM chunks ORDER BY x, z, y");
    if (!rows) return tl::unexpected{rows.error()};
    parts_->chunks.emplace(*std::move(rows));
  }
  const Statement& row = *parts_->chunks;
  const auto found = parts_->chunks->step();
  if (!found) return tl::unexpected{found.error()};
  if (!*found) return std::nullopt;
  if (!fits(row.number(0)) || !fits(row.number(1)) || !fits(row.number(2))) {
    return damaged(path(), "it has a chunk outside of the world");
  }
  SavedChunk chunk{{static_cast<std::int32_t>(row.number(0)), static_cast<std::int32_t>(row.number(1)),
                    static_cast<std::int32_t>(row.number(2))},
                   {}};
  const auto runs = row.bytes(3);
  chunk.runs.assign(runs.begin(), runs.end());
  return chunk;
}

Result<void> SaveFile::begin() {
  if (parts_->access == Access::read) return refused(path(), Kind::read_only, "was opened for reading only");
  Database& database = *parts_->database;
  const auto prepare = [&](std::optional<Statement>& into, std::string_view sql) -> Result<void> {
    if (into) return {};
    auto statement = database.prepare(sql);
    if (!statement) return tl::unexpected{std::move(statement.error())};
    into.emplace(*std::move(statement));
    return {};
  };
  auto done = prepare(parts_->put, "REPLACE INTO chunks(x, z, y, runs) VALUES(?, ?, ?, ?)");
  if (done) done = prepare(parts_->remove, "DELETE FROM chunks WHERE x = ? AND z = ? AND y = ?");
  if (done) done = prepare(parts_->set_state, "UPDATE state SET revision = ?, hash = ?");
  if (done) {
    roll_back();  // what no memory was left to roll back
    done = database.run("BEGIN IMMEDIATE");
  }
  return done;
}

Result<void> SaveFile::put(ChunkCoord chunk, std::span<const std::byte> runs) {
  constexpr std::size_t kEmptyRuns = 2;
  Statement& statement = runs.size() == kEmptyRuns ? *parts_->remove : *parts_->put;
  statement.bind(1, std::int64_t{chunk.x});
  statement.bind(2, std::int64_t{chunk.z});
  statement.bind(3, std::int64_t{chunk.y});
  if (&statement == &*parts_->put) statement.bind(4, runs);
  const auto done = statement.step();
  if (!done) return tl::unexpected{done.error()};
  return {};
}

Result<void> SaveFile::clear() {
  return parts_->database->run("DELETE FROM chunks");
}

Result<void> SaveFile::commit(const SaveState& state) {
  const std::string hash = edits::to_string(state.hash);
  parts_->set_state->bind(1, static_cast<std::int64_t>(state.revision));
  parts_->set_state->bind(2, hash);
  const auto set = parts_->set_state->step();
  if (!set) return tl::unexpected{set.error()};
  if (auto done = parts_->database->run("COMMIT"); !done) return done;
  parts_->state = state;
  return {};
}

void SaveFile::roll_back() noexcept {
  if (parts_->access == Access::read) return;  // its transaction is the lock
  parts_->database->roll_back();
}

}  // namespace talus::saves
