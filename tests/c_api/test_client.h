// A talus_client of a test, and the events that come to it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <talus.h>

namespace talus::c_api::testing {

template <typename T>
[[nodiscard]] T sized() {
  T fresh{};
  fresh.size = sizeof(T);
  return fresh;
}

using Voxels = std::vector<std::uint16_t>;
using Key = std::tuple<std::uint32_t, std::int32_t, std::int32_t, std::int32_t>;  // level, x, y, z

[[nodiscard]] inline Key key_of(const talus_event& event) {
  return {event.level, event.x, event.y, event.z};
}
[[nodiscard]] Voxels decode(const talus_chunk* chunk);

class TestClient {
 public:
  TestClient();
  ~TestClient() { talus_destroy(client_); }
  TestClient(const TestClient&) = delete;
  TestClient& operator=(const TestClient&) = delete;

  [[nodiscard]] talus_client* get() const { return client_; }
  [[nodiscard]] std::string error() const { return talus_last_error(client_); }

  void connect(std::uint16_t port, talus_connect_options options = sized<talus_connect_options>());
  /// Polls until an event of this type comes; fails the test where half a minute passes or the connection
  /// ends first. What came before is handed to `other`; `meanwhile` is called between.
  talus_event await(std::uint32_t type, const std::function<void(const talus_event&)>& other = {},
                    const std::function<void()>& meanwhile = {});
  /// connect() and the event.
  void join(std::uint16_t port, talus_connect_options options = sized<talus_connect_options>());

  [[nodiscard]] talus_world world() const;
  /// Around the spawn.
  [[nodiscard]] talus_view view(std::uint16_t horizontal, std::uint16_t vertical) const;
  void set_view(const talus_view& view);
  /// All chunks that come until the View is complete, without those that left it.
  [[nodiscard]] std::map<Key, Voxels> until_complete();

 private:
  talus_client* client_ = nullptr;
};

}  // namespace talus::c_api::testing
