#include "log_damage.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <rocksdb/env.h>
#include <rocksdb/write_batch.h>

#include <talus/store/keys.h>
#include <talus/store/log_records.h>
#include <talus/store/rocks.h>

namespace talus::store {
namespace {

// RocksDB's log: blocks of fragments, each with a checksum, a length and a type. A record is a full fragment,
// or a first one, any number of middle ones and a last one.
constexpr std::size_t kBlockBytes = 32'768;
constexpr std::size_t kHeaderBytes = 7;
enum class FragmentType : std::uint8_t { full = 1, first = 2, middle = 3, last = 4 };

/// A record is a WriteBatch, which begins with its sequence number and the count of its operations.
constexpr std::size_t kBatchHeaderBytes = 12;

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i > 0; --i) {
    number = number << 8U | static_cast<std::uint8_t>(bytes[i - 1]);
  }
  return number;
}

constexpr std::array<std::uint32_t, 256> crc32c_table() {
  constexpr std::uint32_t kPolynomial = 0x82f63b78;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ (crc & 1U) * kPolynomial;
    table[i] = crc;
  }
  return table;
}

/// CRC-32C, masked as in RocksDB's and LevelDB's logs.
std::uint32_t masked_crc(std::string_view bytes) {
  static constexpr auto kTable = crc32c_table();
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char byte : bytes) crc = kTable[(crc ^ static_cast<std::uint8_t>(byte)) & 0xffU] ^ crc >> 8U;
  crc = ~crc;
  return (crc >> 15U | crc << 17U) + 0xa282ead8U;
}

struct Fragment {
  FragmentType type{};
  std::string_view payload;
  std::size_t end = 0;
};

std::optional<Fragment> fragment_at(std::string_view file, std::size_t at) {
  const std::size_t left_in_block = kBlockBytes - at % kBlockBytes;
  if (left_in_block < kHeaderBytes) at += left_in_block;
  if (at + kHeaderBytes > file.size()) return std::nullopt;
  const std::string_view header = file.substr(at, kHeaderBytes);
  const auto length = static_cast<std::size_t>(little_endian(header.substr(4, 2)));
  const std::size_t end = at + kHeaderBytes + length;
  if (end > file.size() || end > (at / kBlockBytes + 1) * kBlockBytes) return std::nullopt;
  const auto type = static_cast<FragmentType>(header[6]);
  if (type < FragmentType::full || type > FragmentType::last) return std::nullopt;
  if (masked_crc(file.substr(at + 6, 1 + length)) != little_endian(header.substr(0, 4))) return std::nullopt;
  return Fragment{type, file.substr(at + kHeaderBytes, length), end};
}

struct Record {
  std::string batch;
  std::size_t end = 0;
  [[nodiscard]] std::uint64_t sequence() const { return little_endian(std::string_view{batch}.substr(0, 8)); }
  [[nodiscard]] std::uint64_t next_sequence() const {
    return sequence() + little_endian(std::string_view{batch}.substr(8, 4));
  }
};

std::optional<Record> record_at(std::string_view file, std::size_t at) {
  Record record;
  for (auto type = FragmentType::first; type != FragmentType::last; at = record.end) {
    const auto fragment = fragment_at(file, at);
    if (!fragment) return std::nullopt;
    const bool begins = fragment->type == FragmentType::full || fragment->type == FragmentType::first;
    if (begins != (record.end == 0)) return std::nullopt;
    record.batch.append(fragment->payload);
    record.end = fragment->end;
    type = fragment->type == FragmentType::full ? FragmentType::last : fragment->type;
  }
  return record;
}

/// Like record_at(), for a record of the log.
std::optional<Record> batch_at(std::string_view file, std::size_t at) {
  auto record = record_at(file, at);
  return record && record->batch.size() >= kBatchHeaderBytes ? std::move(record) : std::nullopt;
}

/// True for the zeros at a block's end that are too short for a fragment.
bool is_padding(std::string_view file, std::size_t at) {
  return file.size() - at < kHeaderBytes && kBlockBytes - at % kBlockBytes < kHeaderBytes;
}

/// Returns the first whole record from any offset on. As damage can hide where records begin, tries each
/// byte.
std::optional<Record> find_record(std::string_view file, std::size_t at, std::uint64_t sequence) {
  constexpr std::uint64_t kMaxSkipped = std::uint64_t{1} << 40U;
  for (; at + kHeaderBytes + kBatchHeaderBytes <= file.size(); ++at) {
    const auto type = static_cast<FragmentType>(file[at + 6]);
    if (type != FragmentType::full && type != FragmentType::first) continue;
    // A first fragment may be too short for the number.
    const std::uint64_t begins = little_endian(file.substr(at + kHeaderBytes, 8)) - sequence;
    if (type == FragmentType::full && begins > kMaxSkipped) continue;
    auto record = batch_at(file, at);
    if (record && record->sequence() >= sequence) return record;
  }
  return std::nullopt;
}

/// Classifies a batch by its keys.
class BatchKeys final : public rocksdb::WriteBatch::Handler {
 public:
  void Put(const rocksdb::Slice& key, const rocksdb::Slice& value) override {
    meet(key);
    if (kind_of(key) != KeyKind::log) return;
    std::uint64_t link = 0;
    if (const auto records = decode_records_alone(bytes_of(value), link)) {
      first_entry = records->front().position;
    }
  }
  void Delete(const rocksdb::Slice& key) override { meet(key); }
  rocksdb::Status DeleteRangeCF(std::uint32_t, const rocksdb::Slice& begin, const rocksdb::Slice&) override {
    meet(begin);
    return {};
  }

  bool is_slice = true;  // of chunks and editors, which is not synced
  bool is_mark = false;  // mark_flushed(), before which a sync ended
  std::optional<std::uint64_t> first_entry;

 private:
  [[nodiscard]] static KeyKind kind_of(const rocksdb::Slice& key) {
    return key.empty() ? KeyKind::meta : static_cast<KeyKind>(key[0]);
  }
  void meet(const rocksdb::Slice& key) {
    const KeyKind kind = kind_of(key);
    is_slice = is_slice && (kind == KeyKind::chunk || kind == KeyKind::editor);
    is_mark = is_mark || kind == KeyKind::history;
  }
};

class LogScan {
 public:
  void read(const std::string& name, std::string_view file) {
    std::size_t at = 0;
    while (!damage_) {
      const auto record = batch_at(file, at);
      if (!record) {
        if (at < file.size() && !is_padding(file, at)) damage_ = LogDamage{name, at, true, {}};
        break;
      }
      if (next_ != 0 && record->sequence() > next_) {
        // What lies between was at the end of this file or the one before.
        damage_ = LogDamage{at == 0 ? before_ : name, at == 0 ? before_end_ : at, true, {}};
        break;
      }
      next_ = record->next_sequence();
      at = record->end;
    }
    before_ = name;
    before_end_ = at;
    if (!damage_) return;
    while (const auto record = find_record(file, at, next_)) {
      meet(record->batch);
      at = record->end;
    }
  }

  [[nodiscard]] std::optional<LogDamage> damage() const { return damage_; }

 private:
  /// Takes a whole record behind the damage as evidence. A write begins only after the sync of the one before
  /// has ended, and all writes but slices and marks are synced.
  void meet(const std::string& batch) {
    BatchKeys keys;
    const bool sound = rocksdb::WriteBatch{batch}.Iterate(&keys).ok();
    if (!sound || keys.is_mark || met_synced_) damage_->is_torn = false;
    met_synced_ = met_synced_ || !keys.is_slice;
    if (keys.first_entry) damage_->entry_behind = keys.first_entry;
  }

  std::uint64_t next_ = 0;  // the sequence number that comes next; 0: unknown
  std::string before_;      // the log before, and where its whole records end
  std::uint64_t before_end_ = 0;
  std::optional<LogDamage> damage_;
  bool met_synced_ = false;  // a synced write lies behind the damage
};

}  // namespace

std::vector<std::uint64_t> log_numbers(rocksdb::Env& env, const std::string& directory) {
  std::vector<std::string> names;
  env.GetChildren(directory, &names).PermitUncheckedError();
  std::vector<std::uint64_t> numbers;
  for (const std::string_view name : names) {
    std::uint64_t number = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data(), end, number);
    if (error == std::errc{} && std::string_view{stop, end} == ".log") numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

std::optional<LogDamage> find_log_damage(rocksdb::Env& env, const std::string& directory,
                                         std::uint64_t first_log) {
  LogScan scan;
  for (const std::uint64_t number : log_numbers(env, directory)) {
    if (number < first_log) continue;
    std::string name = std::to_string(number) + ".log";
    if (name.size() < 10) name.insert(0, 10 - name.size(), '0');
    std::string file;
    if (!rocksdb::ReadFileToString(&env, directory + "/" + name, &file).ok()) continue;
    scan.read(name, file);
  }
  return scan.damage();
}

std::optional<LogDamage> find_manifest_damage(rocksdb::Env& env, const std::string& directory) {
  std::string name;
  std::string file;
  if (!rocksdb::ReadFileToString(&env, directory + "/CURRENT", &name).ok() || name.empty())
    return std::nullopt;
  name.pop_back();  // a line end
  if (!rocksdb::ReadFileToString(&env, directory + "/" + name, &file).ok()) return std::nullopt;
  std::size_t at = 0;
  while (const auto record = record_at(file, at)) at = record->end;
  if (at == file.size() || is_padding(file, at)) return std::nullopt;
  // The edits of a flush and of a compaction that end together, with those of the logs that they make
  // obsolete.
  constexpr int kMaxGroup = 4;
  int behind = 0;
  for (std::size_t next = at + 1; next < file.size(); ++next) {
    const auto record = record_at(file, next);
    if (!record || record->batch.empty()) continue;
    ++behind;
    next = record->end - 1;
  }
  return LogDamage{name, at, behind < kMaxGroup, {}};
}

}  // namespace talus::store
