#include <talus/store/acknowledged_file.h>

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <rocksdb/env.h>

#include <talus/store/regular_files.h>

namespace talus::store {
namespace {

rocksdb::Slice slice_of_bytes(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

rocksdb::Status make_whole(rocksdb::Env& env, const std::string& path, const Bytes& bytes) {
  const std::string temporary = path + ".new";
  env.DeleteFile(temporary).PermitUncheckedError();  // writing to an existing pipe would block
  rocksdb::Status status = rocksdb::WriteStringToFile(&env, slice_of_bytes(bytes), temporary, true);
  if (status.ok()) status = env.RenameFile(temporary, path);
  std::unique_ptr<rocksdb::Directory> directory;
  if (status.ok()) status = env.NewDirectory(std::filesystem::path{path}.parent_path().string(), &directory);
  if (status.ok()) status = directory->Fsync();
  return status;
}

}  // namespace

tl::expected<std::optional<AcknowledgedState>, std::string> AcknowledgedFile::read(rocksdb::Env& env,
                                                                                   const std::string& path) {
  if (auto regular = check_regular_file(path); !regular) return tl::unexpected{std::move(regular.error())};
  if (env.FileExists(path).IsNotFound()) return std::nullopt;
  constexpr std::size_t kMaxBytes = 4096;  // many times its real size
  std::string text(kMaxBytes, 0);
  std::unique_ptr<rocksdb::SequentialFile> file;
  rocksdb::Slice slice;
  auto status = env.NewSequentialFile(path, &file, rocksdb::EnvOptions{});
  if (status.ok()) status = file->Read(kMaxBytes, &slice, text.data());
  if (!status.ok()) {
    return tl::unexpected{fmt::format("{}: {}; talusd must be able to read it", path, status.ToString())};
  }
  const auto acknowledged = decode_acknowledged(std::as_bytes(std::span{slice.data(), slice.size()}));
  if (!acknowledged) {
    return tl::unexpected{
        fmt::format("{}: it is damaged, and the disk may be, too; restore a backup, or delete this file to "
                    "go on with what the store holds, as a store of a new id",
                    path)};
  }
  return acknowledged;
}

tl::expected<AcknowledgedFile, std::string> AcknowledgedFile::open(rocksdb::Env& env, const std::string& path,
                                                                   const AcknowledgedState& now) {
  Bytes bytes;
  encode(now, bytes);
  std::unique_ptr<rocksdb::RandomRWFile> file;
  rocksdb::Status status = make_whole(env, path, bytes);
  if (status.ok()) status = env.NewRandomRWFile(path, &file, rocksdb::EnvOptions{});
  if (!status.ok()) {
    return tl::unexpected{fmt::format("{}: {}; talusd must be able to write it", path, status.ToString())};
  }
  return AcknowledgedFile{std::move(file)};
}

AcknowledgedFile::AcknowledgedFile(std::unique_ptr<rocksdb::RandomRWFile> file) : file_{std::move(file)} {}
AcknowledgedFile::AcknowledgedFile(AcknowledgedFile&&) noexcept = default;
AcknowledgedFile& AcknowledgedFile::operator=(AcknowledgedFile&&) noexcept = default;
AcknowledgedFile::~AcknowledgedFile() = default;

void AcknowledgedFile::write(const AcknowledgedState& now) {
  encode(now, bytes_);
  file_->Write(0, slice_of_bytes(bytes_)).PermitUncheckedError();
}

void AcknowledgedFile::sync() {
  file_->Sync().PermitUncheckedError();
}

tl::expected<void, std::string> check_acknowledged(rocksdb::Env& env, const std::filesystem::path& directory,
                                                   const StoreMeta& meta) {
  const std::string path = (directory / "acknowledged").string();
  const auto failure = [&](std::string_view what) {
    return tl::unexpected{fmt::format("edits {}: {}", directory.string(), what)};
  };
  const auto read = AcknowledgedFile::read(env, path);
  if (!read) return failure(read.error());
  if (!*read) return {};
  const AcknowledgedState& acknowledged = **read;
  if (acknowledged.position > meta.head.position) {
    return failure(fmt::format(
        "entries {} to {} of its log were acknowledged and are lost, as the disk lost "
        "the end of the log; restore a backup, or delete {} to go on without them, as a store of a "
        "new id",
        meta.head.position + 1, acknowledged.position, path));
  }
  if (acknowledged.position == meta.head.position && acknowledged.link != meta.link) {
    return failure(
        fmt::format("entry {} of its log is not the one that was acknowledged; restore a backup, or "
                    "delete {} to go on with what is there, as a store of a new id",
                    meta.head.position, path));
  }
  return {};
}

bool can_read_acknowledged(rocksdb::Env& env, const std::filesystem::path& directory) {
  const std::string path = (directory / "acknowledged").string();
  if (!check_regular_file(path)) return false;
  std::string text;
  const auto status = rocksdb::ReadFileToString(&env, path, &text);
  return status.ok() || status.IsNotFound() || status.IsPathNotFound();
}

bool can_read_acknowledged(const std::filesystem::path& directory) {
  return can_read_acknowledged(*rocksdb::Env::Default(), directory);
}

tl::expected<void, std::string> check_acknowledged(const std::filesystem::path& directory,
                                                   const StoreMeta& meta) {
  return check_acknowledged(*rocksdb::Env::Default(), directory, meta);
}

}  // namespace talus::store
