// Frames of the Unix socket in a data directory, by which `talusd store` reaches the server that uses it.
//
// A frame: its number of bytes (u32, little endian, at most kMaxSocketFrame), version, kind, and the kind's
// fields, as store/bytes.h writes them. The command sends one request at a time, and the server answers. Both
// are of one release: another version is refused by its number.
//
// clang-format off
// | kind            | from    | fields |
// | ---             | ---     | --- |
// | checkpoint      | command | |
// | restore         | command | changes of an edit (store/FORMAT.md): each voxel that is still `before` becomes `after` |
// | pregen          | command | x, z, radius (i32), levels (byte), millionths of the generators' time (u32) |
// | checkpoint_made | server  | number (0: it could not be made, and the files are held in place), and why edits are refused (text; empty: they are not) |
// | restored        | server  | revision, voxels that changed (numbers) |
// | pregen_progress | server  | squares done, squares in all, columns made in this run (numbers); some a second |
// | pregen_done     | server  | the same, once, when it has ended |
// | busy            | server  | why (text): a retry may succeed |
// | failed          | server  | why (text) |
// clang-format on
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/store/records.h>

namespace talus::server {

inline constexpr std::uint8_t kSocketVersion = 1;
inline constexpr std::size_t kMaxSocketFrame = std::size_t{1} << 20U;
/// Maximum time from the first byte of a frame to its last.
inline constexpr std::chrono::seconds kFramePatience{10};

enum class SocketKind : std::uint8_t {
  checkpoint = 1,
  restore = 2,
  pregen = 3,
  checkpoint_made = 129,
  restored = 130,
  pregen_progress = 131,
  pregen_done = 132,
  busy = 254,
  failed = 255
};

struct SocketFrame {
  SocketKind kind{};
  store::Bytes fields;
};

/// An error is one line. Fails if the peer reads nothing for kFramePatience.
[[nodiscard]] tl::expected<void, std::string> send_frame(int socket, SocketKind kind,
                                                         std::span<const std::byte> fields);
[[nodiscard]] tl::expected<void, std::string> send_text(int socket, SocketKind kind, std::string_view text);

/// Waits for a frame to begin, for ever if `patience` is 0. An error is one line, empty if the peer has
/// closed the connection between two frames.
[[nodiscard]] tl::expected<SocketFrame, std::string> receive_frame(int socket,
                                                                   std::chrono::milliseconds patience);

}  // namespace talus::server
