#include "save_form.h"

#include <array>
#include <charconv>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <xxhash.h>

#include <talus/voxel/content_hash.h>

namespace talus::saves {
namespace {

namespace fs = std::filesystem;
using Kind = SaveError::Kind;

constexpr std::int64_t kApplication = 0x54414C53;  // "TALS"

/// By rising name, as they are compared.
constexpr std::array<std::string_view, 5> kTables{
    "CREATE TABLE chunks(x INTEGER NOT NULL, z INTEGER NOT NULL, y INTEGER NOT NULL, runs BLOB NOT NULL,"
    " PRIMARY KEY(x, z, y)) STRICT, WITHOUT ROWID",
    "CREATE TABLE files(name TEXT PRIMARY KEY NOT NULL, bytes BLOB NOT NULL) STRICT",
    "CREATE TABLE materials(id INTEGER PRIMARY KEY NOT NULL, name TEXT UNIQUE NOT NULL) STRICT",
    "CREATE TABLE state(only INTEGER PRIMARY KEY CHECK(only = 1), revision INTEGER NOT NULL, hash TEXT NOT "
    "NULL)"
    " STRICT",
    "CREATE TABLE world(only INTEGER PRIMARY KEY CHECK(only = 1), generator INTEGER NOT NULL,"
    " fingerprint TEXT NOT NULL, settles INTEGER NOT NULL, checksum TEXT NOT NULL, spec TEXT NOT NULL) "
    "STRICT"};

/// Covers what S does not; FORMAT.md, world.checksum.
std::string checksum_of(const SavedWorld& world) {
  XXH3_state_t* const state = XXH3_createState();
  if (state == nullptr) throw std::bad_alloc{};
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> owned{state, XXH3_freeState};
  XXH3_128bits_reset(state);
  const auto add = [&](const void* bytes, std::size_t size) {
    const std::string length = std::to_string(size) + ":";
    XXH3_128bits_update(state, length.data(), length.size());
    XXH3_128bits_update(state, bytes, size);
  };
  const auto add_text = [&](std::string_view text) { add(text.data(), text.size()); };
  add_text(world.spec);
  add_text(std::to_string(world.generator));
  add_text(world.fingerprint);
  add_text(world.settles ? "1" : "0");
  for (const auto& [name, bytes] : world.files) {
    add_text(name);
    add(bytes.data(), bytes.size());
  }
  for (const auto& [name, id] : world.materials) {
    add_text(name);
    add_text(std::to_string(to_integer(id)));
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state);
  return to_string(ContentHash{hash.low64, hash.high64});
}

/// Half of a hash's 32 digits.
std::optional<std::uint64_t> half_of(std::string_view digits) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// Calls `visit` for each row.
template <typename Visit>
Result<void> for_each_row(Database& database, std::string_view sql, const Visit& visit) {
  auto rows = database.prepare(sql);
  if (!rows) return tl::unexpected{rows.error()};
  while (true) {
    const auto row = rows->step();
    if (!row) return tl::unexpected{row.error()};
    if (!*row) return {};
    visit(*rows);
  }
}

Result<void> step_all(Result<Statement>&& statement) {
  if (!statement) return tl::unexpected{statement.error()};
  const auto done = statement->step();
  if (!done) return tl::unexpected{done.error()};
  return {};
}

}  // namespace

tl::unexpected<SaveError> damaged(const fs::path& file, std::string_view what) {
  return refused(file, Kind::damaged, "is damaged, " + std::string{what} + "; restore a backup");
}

Result<void> check_form(Database& database) {
  const auto application = database.number("PRAGMA application_id");
  if (!application) return tl::unexpected{application.error()};
  if (*application != kApplication) return refused(database.file(), Kind::foreign, "is no save of Talus");
  const auto version = database.number("PRAGMA user_version");
  if (!version) return tl::unexpected{version.error()};
  if (*version != kSaveVersion) {
    return refused(database.file(), Kind::other,
                   "is a save of format " + std::to_string(*version) + ", and this program reads format " +
                       std::to_string(kSaveVersion) + "; use the release of Talus that made it");
  }
  auto tables = database.prepare("SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY name");
  if (!tables) return tl::unexpected{tables.error()};
  for (const std::string_view table : kTables) {
    const auto row = tables->step();
    if (!row) return tl::unexpected{row.error()};
    if (!*row || tables->text(0) != table)
      return damaged(database.file(), "its tables are not those of a save");
  }
  const auto more = tables->step();
  if (!more) return tl::unexpected{more.error()};
  if (*more) return damaged(database.file(), "it has more than the tables of a save");
  return {};
}

Result<SavedWorld> read_world_of(Database& database) {
  SavedWorld world;
  std::string checksum;
  auto read = for_each_row(database, "SELECT generator, fingerprint, settles, checksum, spec FROM world",
                           [&](const Statement& row) {
                             world.generator = static_cast<int>(row.number(0));
                             world.fingerprint = row.text(1);
                             world.settles = row.number(2) != 0;
                             checksum = row.text(3);
                             world.spec = row.text(4);
                           });
  if (read) {
    read = for_each_row(database, "SELECT name, bytes FROM files", [&](const Statement& row) {
      const auto bytes = row.bytes(1);
      world.files[std::string{row.text(0)}].assign(bytes.begin(), bytes.end());
    });
  }
  if (read) {
    read = for_each_row(database, "SELECT id, name FROM materials", [&](const Statement& row) {
      if (row.number(0) < 0 || row.number(0) > std::numeric_limits<std::uint16_t>::max()) return;
      world.materials.emplace(row.text(1), MaterialId{static_cast<std::uint16_t>(row.number(0))});
    });
  }
  if (!read) return tl::unexpected{std::move(read.error())};
  if (checksum != checksum_of(world)) return damaged(database.file(), "its world is not as it was written");
  return world;
}

Result<SaveState> read_state_of(Database& database) {
  std::optional<SaveState> state;
  const auto read = for_each_row(database, "SELECT revision, hash FROM state", [&](const Statement& row) {
    const std::string_view digits = row.text(1);
    if (row.number(0) < 0 || digits.size() != 32) return;
    const auto high = half_of(digits.substr(0, 16));
    const auto low = half_of(digits.substr(16));
    if (high && low) state = {static_cast<std::uint64_t>(row.number(0)), {*low, *high}};
  });
  if (!read) return tl::unexpected{read.error()};
  if (!state) return damaged(database.file(), "it has no state");
  return *state;
}

Result<void> write_world(Database& database, const SavedWorld& world) {
  auto done = database.run("BEGIN EXCLUSIVE");
  if (!done) return done;
  const auto schema = database.number("PRAGMA schema_version");  // 0: nothing was ever made in it
  if (!schema) return tl::unexpected{schema.error()};
  if (*schema != 0) {
    return refused(database.file(), Kind::exists, "is there already; give the new save another name");
  }
  const std::string form = "PRAGMA application_id=" + std::to_string(kApplication) +
                           "; PRAGMA user_version=" + std::to_string(kSaveVersion);
  done = database.run(form.c_str());
  for (const std::string_view table : kTables) {
    if (done) done = database.run(std::string{table}.c_str());
  }
  if (!done) return done;
  auto row = database.prepare("INSERT INTO world VALUES(1, ?, ?, ?, ?, ?)");
  if (!row) return tl::unexpected{row.error()};
  const std::string checksum = checksum_of(world);
  row->bind(1, std::int64_t{world.generator});
  row->bind(2, world.fingerprint);
  row->bind(3, std::int64_t{world.settles ? 1 : 0});
  row->bind(4, checksum);
  row->bind(5, world.spec);
  done = step_all(std::move(row));
  for (const auto& [name, bytes] : world.files) {
    if (!done) break;
    auto file = database.prepare("INSERT INTO files VALUES(?, ?)");
    if (!file) return tl::unexpected{file.error()};
    file->bind(1, name);
    file->bind(2, std::span{bytes});
    done = step_all(std::move(file));
  }
  for (const auto& [name, id] : world.materials) {
    if (!done) break;
    auto material = database.prepare("INSERT INTO materials VALUES(?, ?)");
    if (!material) return tl::unexpected{material.error()};
    material->bind(1, std::int64_t{to_integer(id)});
    material->bind(2, name);
    done = step_all(std::move(material));
  }
  const std::string state = "INSERT INTO state VALUES(1, 0, '" + edits::to_string({}) + "'); COMMIT";
  if (done) done = database.run(state.c_str());
  return done;
}

}  // namespace talus::saves
