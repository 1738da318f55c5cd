#include <talus/protocol/frame.h>

#include <algorithm>
#include <cassert>

namespace talus::protocol {
namespace {

constexpr std::size_t kMaxKeptBytes = std::size_t{16} * 1024;

// FlatBuffers aligns relative to the start of the buffer, so the buffer itself must be aligned.
static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= alignof(std::uint64_t));

std::uint32_t read_prefix(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < kPrefixBytes; ++i) value |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
  return value;
}

}  // namespace

std::string FrameError::message() const {
  return "a frame of " + std::to_string(claimed_bytes) + " bytes is announced; " +
         std::to_string(kMinFrameBytes) + " to " + std::to_string(limit_bytes) + " are allowed";
}

FrameReader::FrameReader(std::uint32_t limit_bytes) : limit_bytes_{limit_bytes} {
  assert(limit_bytes >= kMinFrameBytes && limit_bytes <= kMaxFrameBytes);
}

void FrameReader::set_limit(std::uint32_t limit_bytes) {
  assert(limit_bytes >= kMinFrameBytes && limit_bytes <= kMaxFrameBytes && buffer_.empty());
  limit_bytes_ = limit_bytes;
}

std::size_t FrameReader::take(std::span<const std::byte> bytes, std::size_t wanted) {
  const auto taken = bytes.first(std::min(bytes.size(), wanted - buffer_.size()));
  // Grow to twice the capacity, but not beyond the frame.
  const std::size_t needed = buffer_.size() + taken.size();
  if (needed > buffer_.capacity())
    buffer_.reserve(std::max(needed, std::min(wanted, 2 * buffer_.capacity())));
  buffer_.insert(buffer_.end(), taken.begin(), taken.end());
  return taken.size();
}

tl::expected<std::size_t, FrameError> FrameReader::feed(std::span<const std::byte> bytes) {
  if (error_) return tl::unexpected{*error_};
  if (has_frame()) return 0;

  std::size_t taken = 0;
  if (frame_bytes_ == 0) {
    taken = take(bytes, kPrefixBytes);
    if (buffer_.size() < kPrefixBytes) return taken;
    const std::uint64_t claimed = std::uint64_t{read_prefix(buffer_)} + kPrefixBytes;
    if (claimed < kMinFrameBytes || claimed > limit_bytes_) {
      error_ = FrameError{claimed, limit_bytes_};
      return tl::unexpected{*error_};
    }
    frame_bytes_ = static_cast<std::uint32_t>(claimed);
  }
  return taken + take(bytes.subspan(taken), frame_bytes_);
}

bool FrameReader::has_frame() const {
  return frame_bytes_ != 0 && buffer_.size() == frame_bytes_;
}

std::span<const std::byte> FrameReader::frame() const {
  assert(has_frame());
  return buffer_;
}

void FrameReader::pop() {
  assert(has_frame());
  frame_bytes_ = 0;
  buffer_.clear();
  if (buffer_.capacity() > kMaxKeptBytes) std::vector<std::byte>{}.swap(buffer_);
}

bool FrameReader::mid_frame() const {
  return !buffer_.empty() && !has_frame();
}

}  // namespace talus::protocol
