// What a payload is explained as: its fields cover its bytes, whatever these are.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>
#include <talus/voxel/explain.h>

#include "payload_vectors.h"
#include "sample_chunks.h"

namespace talus {
namespace {

using namespace testing;

/// Whether each byte is in one field, in order.
bool covered(const std::vector<PayloadField>& fields, std::size_t size) {
  std::size_t at = 0;
  for (const PayloadField& field : fields) {
    if (field.offset != at) return false;
    at += field.size;
  }
  return at == size;
}

const PayloadField* field_named(const std::vector<PayloadField>& fields, const std::string& name) {
  for (const PayloadField& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("the fields of a payload cover its bytes") {
  for (const WorkedExample& example : worked_examples()) {
    for (const std::size_t symbols : {0U, 16U, 100'000U}) {
      CAPTURE(example.name, symbols);
      const auto fields = explain(example.payload, symbols);
      CHECK(covered(fields, example.payload.size()));
      CHECK(fields.back().name == "end");
    }
  }
}

TEST_CASE("a volume is explained down to its exceptions and symbols") {
  const auto fields = explain(worked_examples()[1].payload, 100);
  REQUIRE(field_named(fields, "count of exceptions") != nullptr);
  CHECK(field_named(fields, "count of exceptions")->meaning == "17");
  REQUIRE(field_named(fields, "gaps") != nullptr);
  CHECK(field_named(fields, "gaps")->meaning.starts_with("5184, 0, 0"));
  REQUIRE(field_named(fields, "voxel (1, 12, 0)") != nullptr);
}

TEST_CASE("any bytes are explained up to an error") {
  CHECK(rc::check([] {
    auto payload = encoded(any_chunk());
    RC_PRE(payload.size() < 5000);
    payload[*rc::gen::inRange<std::size_t>(0, payload.size())] ^= std::byte{1} << *rc::gen::inRange(0, 8);
    payload.resize(*rc::gen::inRange<std::size_t>(0, payload.size() + 1));
    const auto fields = explain(payload);
    RC_ASSERT(!fields.empty());
    RC_ASSERT((fields.back().name == "end") == decode(payload).has_value());
    for (const PayloadField& field : fields) RC_ASSERT(field.offset + field.size <= payload.size());
  }));
}

}  // namespace talus
