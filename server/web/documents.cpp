#include "web/documents.h"

#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <talus/files/npy_file.h>
#include <talus/vectors/little_endian.h>
#include <talus/voxel/codec.h>

namespace talus::server::web {
namespace {

using nlohmann::ordered_json;

std::string_view phase_name(terrain::MaterialKind kind) {
  switch (kind) {
    case terrain::MaterialKind::air:
      return "gas";
    case terrain::MaterialKind::water:
      return "liquid";
    default:
      return "solid";
  }
}

/// Appends a JSON array of up to tens of thousands of values, each in its shortest exact form.
template <typename Value>
void append_array(std::string& json, std::size_t count, const Value& value_at) {
  json += '[';
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) json += ',';
    fmt::format_to(std::back_inserter(json), "{}", value_at(i));
  }
  json += ']';
}

ordered_json rates_object(const RateSet& rates, std::chrono::milliseconds burst) {
  return {{"chunks_per_second", rates.chunks.per_second},
          {"bytes_per_second", rates.bytes.per_second},
          {"requests_per_second", rates.requests.per_second},
          {"burst_ms", burst.count()}};
}

ordered_json limits_object(const SessionLimits& limits, const RateLimits& rates) {
  return {{"heights_per_request", limits.heights_per_request},
          {"view_horizontal_radius", limits.view_horizontal_radius},
          {"view_vertical_radius", limits.view_vertical_radius},
          {"view_chunks", limits.view_chunks},
          {"square_edge", kMaxSquareEdge},
          {"session", rates_object(rates.session, rates.burst)},
          {"address", rates_object(rates.address, rates.burst)}};
}

}  // namespace

http::Response error_response(int status, wire::ErrorCode code, std::string_view text,
                              std::chrono::milliseconds retry_after) {
  ordered_json error{{"code", wire::EnumNameErrorCode(code)}, {"text", text}};
  http::Response response{status, kJson};
  if (retry_after.count() > 0) {
    error["retry_after_ms"] = retry_after.count();
    response.fields.push_back(
        {"Retry-After", std::to_string(std::chrono::ceil<std::chrono::seconds>(retry_after).count())});
  }
  response.body =
      ordered_json{{"error", error}}.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + '\n';
  return response;
}

std::string world_document(const WorldInfo& world, const SessionLimits& limits, const RateLimits& rates) {
  ordered_json materials = ordered_json::array();
  for (const terrain::Material& material : world.materials) {
    materials.push_back({{"id", to_integer(material.id)},
                         {"name", material.name},
                         {"colour", fmt::format("#{:02x}{:02x}{:02x}", material.colour.red,
                                                material.colour.green, material.colour.blue)},
                         {"phase", phase_name(material.kind)}});
  }
  ordered_json document{{"server", world.server},
                        {"fingerprint", to_string(world.fingerprint)},
                        {"store_id", to_string(world.store_id)},
                        {"codec", kCodecVersion},
                        {"chunk_size", kChunkSize},
                        {"levels", Lod::kMax + 1},
                        {"min_y", world.heights.low},
                        {"max_y", world.heights.high},
                        {"spawn", {world.spawn.x, world.spawn.y, world.spawn.z}},
                        {"materials", materials},
                        {"looks", world.looks},
                        {"fields", world.fields},
                        {"limits", limits_object(limits, rates)}};
  if (!world.world_file.empty()) document["world_file"] = world.world_file;
  return document.dump();
}

std::string with_edits(std::string_view world_document, EditsNow edits) {
  return fmt::format(R"({},"edits":{{"taken":{},"revision":"{}"}}}})"
                     "\n",
                     world_document.substr(0, world_document.size() - 1), edits.taken, edits.revision);
}

std::string access_fields(const AccessLine& line) {
  const ordered_json fields{{"connection", line.connection}, {"client", line.client}, {"method", line.method},
                            {"target", line.target},         {"status", line.status}, {"ms", line.ms},
                            {"bytes", line.bytes},           {"one_in", line.one_in}};
  return fields.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string heights_document(const HeightsForm& form, const HeightsResult& found) {
  const std::size_t columns = found.heights_fx.size();
  std::string json = fmt::format(R"({{"subvoxels_per_voxel":{})", terrain::kSubvoxels);
  if (form.width > 0) {
    fmt::format_to(std::back_inserter(json), R"(,"w":{},"h":{})", form.width, columns / form.width);
  }
  json += R"(,"heights":)";
  append_array(json, columns, [&](std::size_t i) { return found.heights_fx[i]; });
  if (!form.looks.empty()) {
    std::vector<std::string> names;
    for (const std::string& look : form.looks) names.push_back(ordered_json(look).dump());
    json += R"(,"looks":)";
    append_array(json, found.looks.size(),
                 [&](std::size_t i) -> const std::string& { return names.at(found.looks[i]); });
  }
  const std::size_t fields = form.fields.size();
  for (std::size_t field = 0; field < fields; ++field) {
    json += field == 0 ? R"(,"fields":{)" : ",";
    json += ordered_json(form.fields[field]).dump() + ':';
    append_array(json, found.values.size() / fields,
                 [&](std::size_t i) { return found.values[i * fields + field]; });
  }
  json += fields > 0 ? "}}\n" : "}\n";
  return json;
}

std::string heights_npy(std::size_t width, const HeightsResult& found) {
  const std::size_t count = found.heights_fx.size();
  std::vector<std::size_t> shape{count};
  if (width > 0) shape = {count / width, width};
  std::string array = files::npy_header(files::NpyType::int32, shape);
  std::vector<std::byte> scratch;
  const auto bytes = little_endian_bytes(std::span{found.heights_fx}, scratch);
  return array.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace talus::server::web
