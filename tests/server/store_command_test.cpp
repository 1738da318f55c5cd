// The command line of `talusd store`, and its times.
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/store/data_directory.h>
#include <talus/store/edit_database.h>
#include <talus/store/store_identity.h>

#include "commands/store/local_writer.h"
#include "commands/store/moments.h"
#include "commands/store/opened_store.h"
#include "commands/store/store_command.h"
#include "config/parse_flags.h"
#include "scratch_directory.h"
#include "whole_stores.h"

namespace talus::server {
namespace {

int run(std::vector<const char*> flags, const Environment& environment = {}) {
  flags.insert(flags.begin(), "store");
  const LoadWorld none = [](const std::filesystem::path&, const SecretLayers&) {
    return tl::expected<std::shared_ptr<const terrain::World>, std::string>{tl::unexpect, "no world"};
  };
  return store_command(static_cast<int>(flags.size()), flags.data(), environment, none, {});
}

}  // namespace

TEST_CASE("times are a while ago, or in UTC") {
  constexpr std::int64_t kNow = 1'764'000'000'000;
  CHECK(parse_moment("90s", kNow) == kNow - 90'000);
  CHECK(parse_moment("2h", kNow) == kNow - 7'200'000);
  CHECK(parse_moment("7d", kNow) == kNow - 604'800'000);
  CHECK(parse_moment("1970-01-02", kNow) == 86'400'000);
  CHECK_FALSE(parse_moment("2026-02-31", kNow).has_value());
  CHECK(parse_moment("2025-11-24T16:00:00Z", kNow) == kNow);
  CHECK(moment(kNow) == "2025-11-24T16:00:00Z");
  for (const char* const wrong : {"", "h", "2", "2w", "-2h", "2h ", "99999999999999999999s",
                                  "2025-11-24T16:00:00", "2025-13-01", "yesterday"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_moment(wrong, kNow).has_value());
  }
}

TEST_CASE("wrong flags and failures have statuses of their own") {
  const ScratchDirectory scratch;
  const std::string data = scratch / "none";
  CHECK(run({}) == kWrongUse);
  CHECK(run({"--help"}) == 0);
  CHECK(run({"rollback", "--help"}) == 0);
  CHECK(run({"melt"}) == kWrongUse);
  CHECK(run({"stat"}) == kWrongUse);  // of which directory?
  CHECK(run({"backup", "--data", data.c_str()}) == kWrongUse);
  CHECK(run({"stat", "--data", data.c_str()}) == kFailed);
  CHECK(run({"stat"}, {{"TALUS_DATA", data}}) == kFailed);
  CHECK(run({"history", "--data", data.c_str(), "--at", "1,2"}) == kWrongUse);
  CHECK(run({"history", "--data", data.c_str()}) == kWrongUse);  // of what?
  CHECK(run({"history", "--data", data.c_str(), "--at", "1,2,3", "--subject", "mallory"}) == kWrongUse);
  CHECK(run({"history", "--data", data.c_str(), "--at", "1,2,3", "--since", "1h"}) == kWrongUse);
  CHECK(run({"history", "--data", data.c_str(), "--subject", "mallory", "--count", "0"}) == kWrongUse);
  CHECK(run({"history", "--data", data.c_str(), "--subject", "mallory", "--since", "soon"}) == kWrongUse);
  CHECK(run({"rollback", "--data", data.c_str(), "--subject", "", "--since", "1h", "--box", "1,2,3,4,5"}) ==
        kWrongUse);
  CHECK(run({"rebase", "--data", data.c_str()}) == kFailed);
  CHECK(run({"rename", "--data", data.c_str(), "planks"}) == kWrongUse);
  CHECK(run({"rename", "--data", data.c_str(), "planks", "boards"}) == kFailed);
  CHECK_FALSE(std::filesystem::exists(data));
}

TEST_CASE("a command's world has the secrets of the server's settings, however they are given") {
  const ScratchDirectory scratch;
  make_store(scratch / "data", {{{{0, 0, 0}, 5}, MaterialId{256}}});
  const std::string data = scratch / "data";
  const std::string config =
      scratch.write("talusd.toml", "[secret]\nkey_file = \"/ore.key\"\nlayers = [\"veins\"]\n");
  SecretLayers asked;
  const LoadWorld load = [&](const std::filesystem::path&, const SecretLayers& secret) {
    asked = secret;
    return tl::expected<std::shared_ptr<const terrain::World>, std::string>{tl::unexpect, "no world"};
  };
  const auto secret_of = [&](std::vector<const char*> flags, const Environment& environment) {
    asked = {};
    flags.insert(flags.begin(), "store");
    flags.insert(flags.end(), {"--data", data.c_str()});
    const int argc = static_cast<int>(flags.size());
    CHECK(store_command(argc, flags.data(), environment, load, {}) == kFailed);
    return asked;
  };
  const SecretLayers wanted{"/ore.key", {"veins"}};
  for (const char* const command : {"rebase", "join-cluster", "fork"}) {
    CAPTURE(command);
    CHECK(secret_of({command, "--config", config.c_str()}, {}) == wanted);
    CHECK(secret_of({command}, {{"TALUS_SECRET_KEY_FILE", "/ore.key"}, {"TALUS_SECRET_LAYERS", "veins"}}) ==
          wanted);
    CHECK(secret_of({command}, {}) == SecretLayers{});
  }
  CHECK(secret_of({"import", "FILE", "--config", config.c_str()}, {}) == wanted);
}

TEST_CASE("a store of another world's store.toml is not sound") {
  const ScratchDirectory scratch;
  const std::filesystem::path data = scratch / "data";
  make_store(data, {{{{0, 0, 0}, 5}, MaterialId{256}}});
  const std::string path = data.string();
  CHECK(run({"verify", "--data", path.c_str()}) == 0);
  std::ofstream{data / "store.toml"} << store::store_text({{3, 4}, {8, 9}});
  CHECK(run({"verify", "--data", path.c_str()}) == kFailed);
}

TEST_CASE("a store of a cluster is replaced or changed by no command, and each says what to do instead") {
  const ScratchDirectory scratch;
  const std::filesystem::path data = scratch / "data";
  {
    const auto directory = store::DataDirectory::open(data, {1, 2});
    REQUIRE(directory.has_value());
    store::EditDatabaseSettings settings;
    settings.path = data;
    settings.fingerprint = {1, 2};
    settings.store_id = directory->store_id();
    const auto database = store::EditDatabase::open(settings);
    REQUIRE(database.has_value());
    REQUIRE((*database)->enter({5, 1}).has_value());
  }
  for (const std::string_view command : {"restore", "rebase", "import into", "rename a material of"}) {
    const auto refused = check_is_alone(data, command);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().find("talusd store leave-cluster, " + std::string{command}) != std::string::npos);
  }
  CHECK(check_is_alone(scratch / "empty", "restore").has_value());
  const auto identity = store::read_store_identity(data / "store.toml");
  const auto writer = LocalWriter::open(data, *identity);
  REQUIRE_FALSE(writer.has_value());
  CHECK(writer.error().find("start its talusd") != std::string::npos);
}

}  // namespace talus::server
