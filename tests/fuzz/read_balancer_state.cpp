// The input is what a balancer says of itself in a health check, or whoever reaches the operators' port.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "net/balancer_state.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus::server;
  const std::string text{data, data + size};
  const auto query = read_balancer_query(text);
  if (query && query->ports && query->ports->first > query->ports->last) std::abort();
  if (!query && query.error().size() > 300) std::abort();
  const auto state = read_balancer_state(text);
  if (!state) return 0;
  if (state->weight == 0 || state->weight > state->all_weight) std::abort();
  if (state->sessions > state->all_sessions) std::abort();
  if (sessions_above_share(*state, 0) > state->sessions) std::abort();
  if (sessions_above_share(*state, 1000) > sessions_above_share(*state, 0)) std::abort();
  return 0;
}
