#include "database.h"

#include <cstring>
#include <new>
#include <utility>

#include <sqlite3.h>

namespace talus::saves {
namespace {

/// SQLite's limit for a value: a world's largest file.
constexpr int kMaxValueBytes = (1 << 28) + (1 << 21);

using Kind = SaveError::Kind;

tl::unexpected<SaveError> failed(sqlite3* database, const std::filesystem::path& file, int code) {
  switch (code & 0xFF) {
    case SQLITE_NOMEM:
      throw std::bad_alloc{};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return refused(file, Kind::in_use, "is in use; close it where it is open");
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return refused(file, Kind::read_only, "may not be written; give a save that this user may write");
    case SQLITE_NOTADB:
      return refused(file, Kind::foreign, "is no save of Talus");
    case SQLITE_CORRUPT:
    case SQLITE_TOOBIG:
    case SQLITE_MISMATCH:
    case SQLITE_CONSTRAINT:
    case SQLITE_ERROR:
      return refused(file, Kind::damaged, "is damaged; restore a backup");
    case SQLITE_FULL:
      return refused(file, Kind::full,
                     "the disk is full; nothing was written; free some space, and try again");
    case SQLITE_CANTOPEN: {
      const int reason = database == nullptr ? 0 : sqlite3_system_errno(database);
      return refused(file, Kind::missing,
                     std::string{"cannot be opened, or a journal beside it cannot"} +
                         (reason == 0 ? std::string{} : std::string{": "} + std::strerror(reason)));
    }
    default:
      return refused(file, Kind::disk,
                     std::string{"cannot be read or written: "} +
                         (database == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(database)));
  }
}

tl::unexpected<SaveError> failed(sqlite3* database, const std::filesystem::path& file) {
  return failed(database, file, sqlite3_extended_errcode(database));
}

}  // namespace

tl::unexpected<SaveError> refused(const std::filesystem::path& file, Kind kind, std::string_view what) {
  return tl::unexpected{SaveError{kind, file.string() + ": " + std::string{what}}};
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Statement::note(int code) {
  if (bound_ == SQLITE_OK) bound_ = code;
}

void Statement::bind(int at, std::int64_t number) {
  note(sqlite3_bind_int64(statement_.get(), at, number));
}

void Statement::bind(int at, std::string_view text) {
  note(sqlite3_bind_text64(statement_.get(), at, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void Statement::bind(int at, std::span<const std::byte> bytes) {
  // A null pointer would bind NULL.
  note(sqlite3_bind_blob64(statement_.get(), at, bytes.empty() ? "" : static_cast<const void*>(bytes.data()),
                           bytes.size(), SQLITE_STATIC));
}

Result<bool> Statement::step() {
  const int bound = std::exchange(bound_, SQLITE_OK);
  const int code = bound == SQLITE_OK ? sqlite3_step(statement_.get()) : bound;
  if (code == SQLITE_ROW) return true;
  // Before an error is made, which may throw: a statement left as it is would keep pointers to freed bytes.
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
  if (code == SQLITE_DONE) return false;
  return failed(sqlite3_db_handle(statement_.get()), file_, code);
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

void Statement::check_memory(const void* value) const {
  if (value != nullptr) return;  // NULL, an empty value, or no memory
  if ((sqlite3_errcode(sqlite3_db_handle(statement_.get())) & 0xFF) == SQLITE_NOMEM) throw std::bad_alloc{};
}

std::string_view Statement::text(int column) const {
  const unsigned char* const text = sqlite3_column_text(statement_.get(), column);
  check_memory(text);
  const int bytes = sqlite3_column_bytes(statement_.get(), column);
  return text == nullptr
             ? std::string_view{}
             : std::string_view{reinterpret_cast<const char*>(text), static_cast<std::size_t>(bytes)};
}

std::span<const std::byte> Statement::bytes(int column) const {
  const void* const bytes = sqlite3_column_blob(statement_.get(), column);
  check_memory(bytes);
  const int count = sqlite3_column_bytes(statement_.get(), column);
  if (bytes == nullptr) return {};
  return {static_cast<const std::byte*>(bytes), static_cast<std::size_t>(count)};
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);
}

Result<std::unique_ptr<Database>> Database::open(const std::filesystem::path& file, Mode mode) {
  std::error_code code;
  const auto status = std::filesystem::status(file, code);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return refused(file, Kind::foreign,
                   "is not a regular file; give that of a save");  // opening a pipe may wait
  }
  // Absolute, since SQLite has names of its own: "", ":memory:", "file:...".
  const std::filesystem::path absolute = std::filesystem::absolute(file, code);
  if (code) return refused(file, Kind::missing, "cannot be opened: " + code.message());
  std::unique_ptr<Database> opened{new Database{file}};
  sqlite3* handle = nullptr;
  // To read, too: what a killed process left half written is undone first.
  const int flags =
      SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE | (mode == Mode::create ? SQLITE_OPEN_CREATE : 0);
  const int result = sqlite3_open_v2(absolute.string().c_str(), &handle, flags, nullptr);
  opened->database_.reset(handle);
  if (result != SQLITE_OK) return failed(handle, file, result);
  if (mode != Mode::read && sqlite3_db_readonly(handle, "main") == 1)
    return failed(handle, file, SQLITE_READONLY);
  // A save may come from a stranger.
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kMaxValueBytes);
  sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  if (auto locked = opened->lock(mode); !locked) return tl::unexpected{std::move(locked.error())};
  return opened;
}

Result<void> Database::lock(Mode mode) {
  if (mode == Mode::read) {
    return run("PRAGMA cell_size_check=ON; PRAGMA query_only=ON; BEGIN; SELECT count(*) FROM sqlite_schema");
  }
  // The lock stays after the transaction. EXTRA: what commit() kept stays through a power cut.
  return run(
      "PRAGMA cell_size_check=ON; PRAGMA locking_mode=EXCLUSIVE; PRAGMA synchronous=EXTRA;"
      "BEGIN EXCLUSIVE; COMMIT");
}

Result<Statement> Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  const int code =
      sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  if (code != SQLITE_OK) return failed(database_.get(), file_);
  return Statement{statement, file_};
}

Result<void> Database::run(const char* sql) {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return failed(database_.get(), file_);
}

Result<std::int64_t> Database::number(const char* sql) {
  auto statement = prepare(sql);
  if (!statement) return tl::unexpected{std::move(statement.error())};
  const auto row = statement->step();
  if (!row) return tl::unexpected{row.error()};
  return *row ? statement->number(0) : 0;
}

void Database::roll_back() noexcept {
  if (sqlite3_get_autocommit(database_.get()) != 0) return;
  sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

}  // namespace talus::saves
