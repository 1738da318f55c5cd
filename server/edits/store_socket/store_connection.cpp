#include "edits/store_socket/store_connection.h"

#include <pwd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <talus/store/bytes.h>
#include <talus/store/store_swap.h>

#include "edits/store_socket/pregen_fields.h"
#include "edits/store_socket/store_socket.h"
#include "edits/store_socket/unix_address.h"

namespace talus::server {
namespace {

/// Time for the server's answer; a checkpoint on a slow disk takes some time.
constexpr std::chrono::minutes kAnswerPatience{5};
constexpr std::size_t kMaxText = 4'096;

tl::unexpected<EditError> server_failed(const std::string& reason,
                                        EditErrorCode code = EditErrorCode::unanswered) {
  return edit_error(code, fmt::format("the running server: {}", reason));
}

tl::unexpected<EditError> not_asked_for(const SocketFrame& frame) {
  return server_failed(fmt::format("an answer of kind {} was not asked for", static_cast<int>(frame.kind)));
}

}  // namespace

std::string user_name(uid_t user) {
  passwd found{};
  passwd* entry = nullptr;
  std::array<char, 1024> text;
  const bool known = ::getpwuid_r(user, &found, text.data(), text.size(), &entry) == 0 && entry != nullptr;
  return known ? entry->pw_name : std::to_string(user);
}

tl::expected<std::optional<StoreConnection>, std::string> StoreConnection::open(
    const std::filesystem::path& directory) {
  const std::filesystem::path path = socket_path(directory);
  std::error_code code;
  if (!std::filesystem::is_socket(path, code)) {
    const bool absent =
        !code || code == std::errc::no_such_file_or_directory || code == std::errc::not_a_directory;
    if (absent) return std::nullopt;
    return tl::unexpected{
        fmt::format("{}: {}; run the command as the server's user", path.string(), code.message())};
  }
  const auto address = UnixAddress::of(path);
  if (!address) return tl::unexpected{address.error()};
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  StoreConnection connection{socket, directory};
  if (socket >= 0 && ::connect(socket, address->address(), address->size()) == 0) {
    struct stat about {};
    if (::stat(path.c_str(), &about) == 0 && about.st_uid != ::geteuid()) {
      return tl::unexpected{
          fmt::format("{}: the server that uses the store runs as user {}; run the command as that user",
                      path.string(), user_name(about.st_uid))};
    }
    return std::optional<StoreConnection>{std::move(connection)};
  }
  if (errno == ECONNREFUSED || errno == ENOENT) return std::nullopt;  // left by a process that was killed
  return tl::unexpected{fmt::format("{}: {}; run the command as the server's user", path.string(),
                                    std::generic_category().message(errno))};
}

StoreConnection::StoreConnection(int socket, std::filesystem::path directory)
    : socket_{socket}, directory_{std::move(directory)} {}
StoreConnection::StoreConnection(StoreConnection&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)}, directory_{std::move(other.directory_)} {}
StoreConnection::~StoreConnection() {
  if (socket_ >= 0) ::close(socket_);
}

tl::expected<SocketFrame, EditError> StoreConnection::receive() {
  auto got = receive_frame(socket_, kAnswerPatience);
  if (!got) return server_failed(got.error().empty() ? "it has closed the connection" : got.error());
  if (got->kind != SocketKind::failed && got->kind != SocketKind::busy) return *std::move(got);
  store::ByteReader in{got->fields};
  return server_failed(in.text(kMaxText),
                       got->kind == SocketKind::busy ? EditErrorCode::busy : EditErrorCode::unanswered);
}

tl::expected<SocketFrame, EditError> StoreConnection::ask(SocketKind kind, std::span<const std::byte> fields,
                                                          SocketKind answer) {
  // A server that refuses sends the reason, and does not read the request: sending may fail.
  (void)send_frame(socket_, kind, fields);
  auto got = receive();
  if (!got || got->kind == answer) return got;
  return not_asked_for(*got);
}

tl::expected<StoreConnection::Checkpoint, std::string> StoreConnection::checkpoint() {
  const auto answer = ask(SocketKind::checkpoint, {}, SocketKind::checkpoint_made);
  if (!answer) return tl::unexpected{answer.error().message};
  store::ByteReader in{answer->fields};
  const std::uint64_t number = in.varint();
  std::string read_only = in.text(kMaxText);
  if (!in.ended()) return tl::unexpected{std::string{"the running server: its answer is damaged"}};
  const bool in_place = number == 0;
  return Checkpoint{in_place ? directory_ : store::checkpoint_path(directory_, std::to_string(number)),
                    std::move(read_only)};
}

tl::expected<Restorer::Result, EditError> StoreConnection::restore(
    const std::vector<edits::ChunkChanges>& changes) {
  store::Bytes fields;
  store::encode(changes, fields);
  const auto answer = ask(SocketKind::restore, fields, SocketKind::restored);
  if (!answer) return tl::unexpected{answer.error()};
  store::ByteReader in{answer->fields};
  const std::uint64_t revision = in.varint();
  const std::uint64_t changed = in.varint();
  if (!in.ended()) return server_failed("its answer is damaged");
  return Restorer::Result{revision, changed};
}

tl::expected<PregenProgress, std::string> StoreConnection::pregen(
    const PregenPlan& plan, const std::function<void(const PregenProgress&)>& report) {
  store::Bytes fields;
  encode(plan, fields);
  (void)send_frame(socket_, SocketKind::pregen, fields);  // as in ask()
  for (;;) {
    const auto got = receive();
    if (!got) return tl::unexpected{got.error().message};
    if (got->kind != SocketKind::pregen_progress && got->kind != SocketKind::pregen_done) {
      return tl::unexpected{not_asked_for(*got).value().message};
    }
    const auto progress = decode_pregen_progress(got->fields);
    if (!progress) return tl::unexpected{std::string{"the running server: its answer is damaged"}};
    report(*progress);
    if (got->kind == SocketKind::pregen_done) return *progress;
  }
}

}  // namespace talus::server
