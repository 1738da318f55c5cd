// NKeys.
#include <catch2/catch.hpp>

#include "cluster/jetstream/nkey.h"

using talus::server::jetstream::public_nkey;

namespace {

// NATS' documentation, "NKeys".
constexpr std::string_view kSeed = "SUACSSL3UAHUDXKFSNVUZRF5UHPMWZ6BFDTJ7M6USDXIEDNPPQYYYCU3VY";
constexpr std::string_view kPublic = "UDXU4RCSJNZOIQHZNWXHXORDPRTGNJAHAHFRGZNEEJCPQTT2M7NLCNF4";

}  // namespace

TEST_CASE("the public key of a seed is the one that NATS knows") {
  const auto key = public_nkey(kSeed);
  REQUIRE(key);
  CHECK(*key == kPublic);
}

TEST_CASE("a seed with a wrong character, of another length or kind is refused, and not repeated") {
  for (std::size_t at = 0; at < kSeed.size(); ++at) {
    std::string wrong{kSeed};
    wrong[at] = wrong[at] == 'A' ? 'B' : 'A';
    const auto key = public_nkey(wrong);
    REQUIRE_FALSE(key);
    CHECK(key.error().find(wrong.substr(2, 8)) == std::string::npos);
  }
  for (const std::string_view wrong :
       {std::string_view{}, kPublic, kSeed.substr(1), std::string_view{"SU"}}) {
    CHECK_FALSE(public_nkey(wrong));
  }
}
