// The subject of an Error: Error.about on the wire and the fields that it selects.
#pragma once

#include <cstdint>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

namespace talus::server {

struct Subject {
  wire::ErrorAbout about = wire::ErrorAbout::connection;
  std::uint32_t number = 0;  // request id or View.number
  ChunkKey chunk{};          // for view_chunk
};

[[nodiscard]] inline Subject about_request(std::uint32_t id) {
  return {wire::ErrorAbout::request, id};
}
/// The earlier request with the same id is still answered.
[[nodiscard]] inline Subject about_repeated(std::uint32_t id) {
  return {wire::ErrorAbout::repeated_request, id};
}
[[nodiscard]] inline Subject about_view(std::uint32_t number) {
  return {wire::ErrorAbout::view, number};
}
[[nodiscard]] inline Subject about_view_chunk(std::uint32_t number, ChunkKey chunk) {
  return {wire::ErrorAbout::view_chunk, number, chunk};
}
[[nodiscard]] inline Subject about_attach() {
  return {wire::ErrorAbout::attach};
}
[[nodiscard]] inline Subject about_ping() {
  return {wire::ErrorAbout::ping};
}

}  // namespace talus::server
