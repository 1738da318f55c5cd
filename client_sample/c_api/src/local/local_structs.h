// Structs of talus_local.h as structs.h reads and writes them.
#pragma once

#include <talus_local.h>

#include "structs.h"

namespace talus::c_api {

template <>
inline constexpr std::size_t kFirstBytes<talus_world_options> = offsetof(talus_world_options, user) +
                                                                sizeof(void*);
template <>
inline constexpr std::size_t kFirstBytes<talus_world_info> = offsetof(talus_world_info, generator_version) +
                                                             sizeof(std::uint32_t);
template <>
inline constexpr std::size_t kFirstBytes<talus_edit_result> = offsetof(talus_edit_result, revision) +
                                                              sizeof(std::uint64_t);

}  // namespace talus::c_api
