// protocol/vectors/frames.json against the library and the schema. `test_protocol "[.frames]"` writes the
// file anew, after the schema has got a field.
#include <flatbuffers/idl.h>

#include <fstream>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <talus/protocol/message.h>

#include "hex.h"
#include "sample_frames.h"

namespace talus::protocol {
namespace {

using Json = nlohmann::ordered_json;

std::string read_whole(const char* path) {
  std::ifstream in{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// Whole numbers that a double does not hold become strings, so that no reader of JSON rounds them.
void protect_large_numbers(Json& value) {
  constexpr std::int64_t kLargest = (std::int64_t{1} << 53) - 1;
  if (value.is_structured()) {
    for (Json& part : value) protect_large_numbers(part);
  } else if (value.is_number_unsigned() && value.get<std::uint64_t>() > kLargest) {
    value = std::to_string(value.get<std::uint64_t>());
  } else if (value.is_number_integer() && value.get<std::int64_t>() < -kLargest) {
    value = std::to_string(value.get<std::int64_t>());
  }
}

/// The message of a frame as the schema names its fields, those at their default included.
Json fields_of(const Frame& frame) {
  flatbuffers::IDLOptions options;
  options.strict_json = true;
  options.output_default_scalars_in_json = true;
  options.size_prefixed = true;
  flatbuffers::Parser parser{options};
  REQUIRE(parser.Parse(read_whole(TALUS_SOURCE_DIR "/protocol/schema/talus.fbs").c_str()));
  std::string text;
  REQUIRE(flatbuffers::GenerateText(parser, frame.data(), &text));
  Json message = Json::parse(text);
  protect_large_numbers(message);
  return message;
}

Json frames_json() {
  Json frames = Json::array();
  for (const auto& sample : testing::sample_frames()) {
    frames.push_back({{"kind", wire::EnumNameBody(sample.kind)},
                      {"number", static_cast<int>(sample.kind)},
                      {"hex", testing::hex(sample.frame)},
                      {"message", fields_of(sample.frame).at("body")}});
  }
  return {{"format", 1}, {"frames", frames}};
}

Json stored() {
  return Json::parse(read_whole(TALUS_SOURCE_DIR "/protocol/vectors/frames.json"));
}

}  // namespace

TEST_CASE("the frames of the test vectors are verified and have the fields that they name") {
  const Json frames = stored().at("frames");
  REQUIRE(frames.size() == static_cast<std::size_t>(wire::Body::MAX));
  int kind = 1;
  for (const Json& vector : frames) {
    INFO(vector.at("kind"));
    const Frame frame = testing::unhex(vector.at("hex").get<std::string>());
    const auto message = read_message(frame);
    REQUIRE(message.has_value());
    CHECK(static_cast<int>((*message)->body_type()) == kind);
    CHECK(vector.at("number") == kind);
    CHECK(vector.at("kind") == wire::EnumNameBody((*message)->body_type()));
    CHECK(fields_of(frame).at("body") == vector.at("message"));
    ++kind;
  }
}

TEST_CASE("every field of the schema has a value in the test vectors") {
  const std::string all = stored().dump();
  for (const char* field : {"window_bytes",    "known",
                            "rings",           "has_known",
                            "total_bytes",     "nonce",
                            "store_id",        "view_horizontal_radius",
                            "idle_timeout_ms", "colour",
                            "phase",           "spawn",
                            "payload",         "runs",
                            "first_y",         "heights_fx",
                            "retry_after_ms",  "previous_revision",
                            "reason",          "direction",
                            "codecs",          "token",
                            "session_rates",   "address_rates",
                            "requests",        "burst_ms",
                            "about",           "repeated_id",
                            "view_number",     "chunk",
                            "horizon",         "view_horizon",
                            "looks",           "fields",
                            "values",          "writes",
                            "sequence",        "guards",
                            "fills",           "only",
                            "flags",           "paste",
                            "with_air",        "editor",
                            "seen_revision",   "epoch",
                            "last_sequence",   "unanswered",
                            "changed",         "voxels_per_second"}) {
    CAPTURE(field);
    CHECK(all.find(std::string{"\""} + field + "\"") != std::string::npos);
  }
}

TEST_CASE("write protocol/vectors/frames.json", "[.frames]") {
  const Json all = frames_json();
  std::ofstream out{TALUS_SOURCE_DIR "/protocol/vectors/frames.json"};
  out << "{\n  \"format\": 1,\n  \"frames\": [\n";
  for (std::size_t i = 0; i < all.at("frames").size(); ++i) {
    out << "    " << all.at("frames")[i].dump() << (i + 1 < all.at("frames").size() ? ",\n" : "\n");
  }
  out << "  ]\n}\n";
}

}  // namespace talus::protocol
