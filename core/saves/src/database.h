// A database of SQLite: owners of its handles, and its errors as lines for people.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <talus/saves/save_error.h>
#include <talus/saves/save_file.h>

struct sqlite3;
struct sqlite3_stmt;

namespace talus::saves {

[[nodiscard]] tl::unexpected<SaveError> refused(const std::filesystem::path& file, SaveError::Kind kind,
                                                std::string_view what);

/// A prepared statement of a Database that outlives it.
class Statement {
 public:
  /// Binds the parameter `at`, from 1. Bytes must live until step(), which fails if this did.
  void bind(int at, std::int64_t number);
  void bind(int at, std::string_view text);
  void bind(int at, std::span<const std::byte> bytes);
  /// True if there is a row. A finished or failed statement has no bindings, and may be bound anew.
  [[nodiscard]] Result<bool> step();

  /// Columns of the row, from 0. Bytes and text live until the next step().
  [[nodiscard]] std::int64_t number(int column) const;
  [[nodiscard]] std::string_view text(int column) const;
  [[nodiscard]] std::span<const std::byte> bytes(int column) const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(sqlite3_stmt* statement, const std::filesystem::path& file)
      : statement_{statement}, file_{file} {}
  void note(int code);
  void check_memory(const void* value) const;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  const std::filesystem::path& file_;
  int bound_ = 0;  // SQLite's code of the first bind that failed
};

class Database {
 public:
  enum class Mode : std::uint8_t { read, write, create };

  /// Opens the file and locks it: exclusively, or with Mode::read against writers.
  [[nodiscard]] static Result<std::unique_ptr<Database>> open(const std::filesystem::path& file, Mode mode);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] Result<Statement> prepare(std::string_view sql);
  [[nodiscard]] Result<void> run(const char* sql);
  /// The number that a pragma returns.
  [[nodiscard]] Result<std::int64_t> number(const char* sql);
  /// Ends a transaction, if there is one, without what it wrote.
  void roll_back() noexcept;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  explicit Database(std::filesystem::path file) : file_{std::move(file)} {}
  [[nodiscard]] Result<void> lock(Mode mode);

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace talus::saves
