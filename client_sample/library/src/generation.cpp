// The client's side of chunks that are made here (Options::generate).
#include <utility>

#include <talus/protocol/limits.h>

#include "core.h"
#include "incoming.h"

namespace talus::client {
namespace {

ClientError cannot(const std::string& why) {
  return {ErrorKind::cannot_generate, "chunks are not made here: " + why, {}};
}

}  // namespace

Result<void> Core::check_generation(const WorldInfo& world) const {
  if (options_.generate != Generate::always) return {};
  if (no_generation_) return tl::unexpected{*no_generation_};
  if (options_.maker == nullptr) return tl::unexpected{cannot("Options::maker is null")};
  if (!world.limits.view_base) return tl::unexpected{cannot("the server does not publish its world")};
  return {};
}

void Core::begin_generation() {
  if (!world_->limits.view_base) return;
  if (local_ != nullptr && local_->is_open()) return local_->begin_session();
  if (local_ != nullptr || no_generation_ || options_.generate == Generate::never ||
      options_.maker == nullptr)
    return;
  local_ = std::make_shared<LocalChunks>(*this, weak_from_this(), executor_, options_, world_->fingerprint);
  local_->start();
}

void Core::require_maker() {
  if (options_.generate != Generate::automatic || options_.maker != nullptr || no_generation_ ||
      !world_->limits.view_base)
    return;
  no_generation_ = cannot("Options::maker is null");
  report(ClientError{*no_generation_});  // the callback may connect again
}

void Core::stop_generation() {
  if (const auto local = std::exchange(local_, nullptr)) local->stop();
}

void Core::ask(Request request) {
  (void)requests_.add(std::move(request));
  wake();
}

void Core::world_opened(const std::shared_ptr<const WorldFiles>& fetched) {
  const auto local = local_;
  if (joined_ && world_->limits.view_base) {
    local->begin_session();
    // Chunks that the server has not sent yet are made here.
    view_to_send_ = view_to_send_ || (view_sent_ && completed_number_ != view_number_);
    wake();
  }
  if (fetched && events_.on_world_files) events_.on_world_files(world_->fingerprint, fetched);
}

// Known chunks save sending those again that were made here as the server has them; all others come again.
void Core::cannot_generate(const std::string& why) {
  const bool made_some = generates();
  stop_generation();
  no_generation_ = cannot(why);
  if (options_.generate == Generate::always) {
    connection_->close(*no_generation_);
    return;
  }
  if (made_some && view_sent_) {
    view_to_send_ = true;
    says_delivered_ = true;
    wake();
  }
  report(ClientError{*no_generation_});  // the callback may connect again
}

void Core::deliver_local(const ReceivedChunk& chunk, bool made) {
  if (!tracker_.deliver(chunk)) return;
  ++(made ? stats_.made_chunks : stats_.kept_chunks);
  if (events_.on_chunk) events_.on_chunk(chunk);
}

Result<bool> Core::add_to_made(const ChunkKey& key, const wire::EditBroadcast& edit) {
  if (!generates()) return false;
  const auto held = tracker_.held(key);
  const bool from_base = edit.previous_revision() == 0 && held && held->revision != 0;
  if (held && edit.revision() <= held->revision) return false;
  if (tracker_.has_current(key) && !from_base && !local_->has_edits(key)) return false;
  const auto voxels = read_runs(key, edit);
  if (!voxels) return tl::unexpected{voxels.error()};
  if (!local_->add_edit(key, edit.previous_revision(), edit.revision(), *voxels)) refetch(key);
  return true;
}

Result<void> Core::handle_file_part(const wire::FilePart& part) {
  constexpr std::uint64_t kMaxPartBytes = 65'536;
  const auto* request = requests_.in_flight(part.id());
  const auto* asked = request == nullptr ? nullptr : std::get_if<FileRequest>(request);
  const std::uint64_t count = part.bytes() == nullptr ? 0 : part.bytes()->size();
  const bool fits = asked != nullptr && count <= kMaxPartBytes && asked->offset <= part.size() &&
                    count <= part.size() - asked->offset && (count > 0 || asked->offset == part.size());
  if (!fits) {
    return tl::unexpected{broken_protocol("a FilePart of " + std::to_string(count) + " bytes for request " +
                                          std::to_string(part.id()) + ", which did not ask for them")};
  }
  useful_ = true;
  FileRequest::Part read{part.size(), {}};
  if (count > 0) {
    const auto bytes = std::as_bytes(std::span{part.bytes()->data(), part.bytes()->size()});
    read.bytes.assign(bytes.begin(), bytes.end());
  }
  std::get<FileRequest>(requests_.take(part.id())).handler(std::move(read));
  wake();
  return {};
}

}  // namespace talus::client
