// Converts between the types of talus.h and the C++ library's.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include <talus.h>
#include <talus/client/edit.h>
#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/client/view.h>
#include <talus/client/world_info.h>

namespace talus::c_api {

/// The error completes "FUNCTION: ...".
template <typename T>
using ConversionResult = tl::expected<T, std::string>;

[[nodiscard]] talus_status status_of(client::ErrorKind kind);

/// NULL is the empty string.
[[nodiscard]] inline std::string text_of(const char* text) {
  return text == nullptr ? std::string{} : std::string{text};
}

[[nodiscard]] ConversionResult<client::Options> options_of(const talus_connect_options& options);
[[nodiscard]] ConversionResult<client::View> view_of(const talus_view& view);
[[nodiscard]] ConversionResult<client::Edit> edit_of(const talus_edit& edit);
[[nodiscard]] talus_world world_of(const client::WorldInfo& world);
[[nodiscard]] talus_material material_of(const client::Material& material);

}  // namespace talus::c_api
