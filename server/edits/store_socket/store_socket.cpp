#include "edits/store_socket/store_socket.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <talus/store/bytes.h>

#include "edits/store_socket/pregen_fields.h"
#include "edits/store_socket/restorer.h"
#include "edits/store_socket/unix_address.h"

namespace talus::server {
namespace {

// Interval between two reports of a pregen.
constexpr std::chrono::milliseconds kTellProgress{250};

namespace fs = std::filesystem;

tl::unexpected<std::string> socket_failure(const fs::path& path, int error) {
  return tl::unexpected{fmt::format("{}: {}; talusd store cannot reach this server", path.string(),
                                    std::generic_category().message(error))};
}

/// The process and the user of the peer.
std::optional<ucred> peer_of(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) return std::nullopt;
  return peer;
}

}  // namespace

fs::path socket_path(const fs::path& directory) {
  return directory / "talusd.socket";
}

tl::expected<std::unique_ptr<StoreSocket>, std::string> StoreSocket::open(const fs::path& directory,
                                                                          Parts parts, Logger log) {
  const fs::path path = socket_path(directory);
  const auto address = UnixAddress::of(path);
  if (!address) return tl::unexpected{address.error()};
  // Left by a process that ended; this process has the lock.
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return socket_failure(path, errno);
  const int listener = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (listener < 0) return socket_failure(path, errno);
  const int wake = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  // Sets the mode before the name, so that other users cannot connect in between.
  if (wake < 0 || ::fchmod(listener, S_IRUSR | S_IWUSR) != 0 ||
      ::bind(listener, address->address(), address->size()) != 0 ||
      ::listen(listener, static_cast<int>(kMaxCommands)) != 0) {
    const int error = errno;
    ::close(listener);
    if (wake >= 0) ::close(wake);
    return socket_failure(path, error);
  }
  std::unique_ptr<StoreSocket> opened{
      new StoreSocket{directory, std::move(parts), std::move(log), listener, wake}};
  opened->acceptor_ = std::thread{[socket = opened.get()] { socket->accept_all(); }};
  return opened;
}

StoreSocket::StoreSocket(fs::path directory, Parts parts, Logger log, int listener, int wake)
    : directory_{std::move(directory)},
      parts_{std::move(parts)},
      log_{std::move(log)},
      listener_{listener},
      wake_{wake} {}

StoreSocket::~StoreSocket() {
  ::eventfd_write(wake_, 1);
  if (acceptor_.joinable()) acceptor_.join();
  ends_.request_stop();
  {
    const std::lock_guard lock{mutex_};
    for (const Command& command : commands_) {
      if (!command.ended) ::shutdown(command.socket, SHUT_RDWR);
    }
  }
  for (Command& command : commands_) {
    command.thread.join();
    ::close(command.socket);
  }
  ::close(listener_);
  ::close(wake_);
  ::unlink(socket_path(directory_).c_str());
}

void StoreSocket::accept_all() {
  for (;;) {
    std::array<pollfd, 2> ready{{{listener_, POLLIN, 0}, {wake_, POLLIN, 0}}};
    if (::poll(ready.data(), ready.size(), -1) < 0 && errno != EINTR) {
      log_->error("the store's socket: {}; talusd store cannot reach this server any more",
                  std::generic_category().message(errno));
      return;
    }
    if (ready[1].revents != 0) return;
    join_ended();
    if (ready[0].revents != 0) accept_one();
  }
}

void StoreSocket::accept_one() {
  const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (socket < 0) {
    // Without free descriptors the pending connection keeps the poll ready: does not retry at once.
    if (errno == EMFILE || errno == ENFILE) {
      pollfd wake{wake_, POLLIN, 0};
      (void)::poll(&wake, 1, 1'000);
    }
    return;
  }
  const auto refuse = [socket](std::string_view reason) {
    (void)send_text(socket, SocketKind::failed, reason);
    ::close(socket);
  };
  const auto peer = peer_of(socket);
  if (!peer || peer->uid != ::geteuid()) {
    return refuse(fmt::format("this server runs as user {}; run the command as that user", ::geteuid()));
  }
  const FlowId process{static_cast<std::uint64_t>(peer->pid)};
  const auto now = std::chrono::steady_clock::now();
  const std::lock_guard lock{mutex_};
  if (commands_.size() >= 2 * kMaxCommands ||
      (places_.size() >= kMaxCommands && !places_.make_room(process, 1, 0, now))) {
    return refuse(
        fmt::format("{} commands use this server's store already; wait until one has ended", kMaxCommands));
  }
  Command& command = commands_.emplace_back();
  command.socket = socket;
  command.number = next_number_++;
  try {
    command.place.emplace(places_, process, 1, now);
    command.place->set_give_way([socket] { ::shutdown(socket, SHUT_RDWR); });
    command.thread = std::thread{[this, &command] { serve(command); }};
  } catch (const std::exception&) {
    commands_.pop_back();
    refuse("this server has no thread or memory for the command");
  }
}

void StoreSocket::join_ended() {
  const std::lock_guard lock{mutex_};
  for (auto at = commands_.begin(); at != commands_.end();) {
    if (!at->ended) {
      ++at;
      continue;
    }
    at->thread.join();
    ::close(at->socket);
    at = commands_.erase(at);
  }
}

void StoreSocket::serve(Command& command) {
  const fs::path checkpoint = store::checkpoint_path(directory_, std::to_string(command.number));
  try {
    Restorer restorer{parts_.log, ends_.get_token()};
    auto patience = parts_.patience.first;
    for (bool goes_on = true; goes_on; patience = parts_.patience.next) {
      const auto request = receive_frame(command.socket, patience);
      if (!request) {
        if (!request.error().empty()) (void)send_text(command.socket, SocketKind::failed, request.error());
        break;
      }
      goes_on = answer(command, *request, restorer);
    }
  } catch (const std::exception& error) {  // no memory
    log_->warn("the store's socket: {}", error.what());
  }
  command.held.reset();
  std::error_code ignored;
  fs::remove_all(checkpoint, ignored);
  ::shutdown(command.socket, SHUT_RDWR);
  command.ended = true;
}

tl::expected<void, std::string> StoreSocket::make_checkpoint(const fs::path& path) const {
  return store::make_checkpoint(path, parts_.checkpoint_copies_bytes,
                                [this](const fs::path& db) { return parts_.database.checkpoint(db); });
}

bool StoreSocket::answer(Command& command, const SocketFrame& request, Restorer& restorer) {
  const auto refuse = [&](std::string_view why) {
    return send_text(command.socket, SocketKind::failed, why).has_value();
  };
  store::Bytes fields;
  store::ByteWriter writer{fields};
  if (request.kind == SocketKind::checkpoint) {
    command.held.reset();
    if (const auto made = make_checkpoint(store::checkpoint_path(directory_, std::to_string(command.number)));
        made) {
      writer.varint(command.number);
    } else {
      log_->warn("talusd store reads the files where they are: {}", made.error());
      command.held = parts_.database.hold_files();
      writer.varint(0);
    }
    writer.counted(parts_.read_only().value_or(""));
    return send_frame(command.socket, SocketKind::checkpoint_made, fields).has_value();
  }
  if (request.kind == SocketKind::restore) {
    const auto changes = store::decode_changes(request.fields);
    std::size_t voxels = 0;
    if (changes) {
      for (const edits::ChunkChanges& chunk : *changes) voxels += chunk.voxels.size();
    }
    if (!changes || voxels == 0 || voxels > Restorer::kMaxVoxels) {
      return refuse(fmt::format("an edit of this kind has 1 to {} voxels", Restorer::kMaxVoxels));
    }
    const auto restored = restorer.restore(*changes);
    if (!restored) {
      const auto kind = is_transient(restored.error().code) ? SocketKind::busy : SocketKind::failed;
      return send_text(command.socket, kind, restored.error().message).has_value();
    }
    writer.varint(restored->revision);
    writer.varint(restored->changed);
    return send_frame(command.socket, SocketKind::restored, fields).has_value();
  }
  if (request.kind == SocketKind::pregen) return pregenerate(command, request);
  return refuse(fmt::format("there is no request {}", static_cast<int>(request.kind)));
}

bool StoreSocket::pregenerate(Command& command, const SocketFrame& request) {
  const auto refuse = [&](std::string_view why) {
    return send_text(command.socket, SocketKind::failed, why).has_value();
  };
  const auto plan = decode_pregen_plan(request.fields);
  if (!plan) return refuse("the plan of a pregen is damaged");
  if (const auto good = plan->check(); !good) return refuse(good.error());
  if (!parts_.pregen) return refuse(kNoColumnCache);
  const std::unique_lock alone{pregen_, std::try_to_lock};
  if (!alone) return refuse("another pregen runs on this server; wait until it has ended");
  store::Bytes fields;
  auto told = std::chrono::steady_clock::now();
  bool reached = true;
  const auto tell = [&](SocketKind kind, const PregenProgress& progress) {
    encode(progress, fields);
    reached = reached && send_frame(command.socket, kind, fields).has_value();
    return reached;
  };
  // Stops working for a command that has gone: sending a frame fails then.
  const auto ended = parts_.pregen(*plan, [&](const PregenProgress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told < kTellProgress) return reached;
    told = now;
    return tell(SocketKind::pregen_progress, progress);
  });
  if (!ended) return refuse(ended.error());
  return tell(SocketKind::pregen_done, *ended);
}

}  // namespace talus::server
