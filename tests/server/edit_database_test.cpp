// Which stores are opened, and the table of materials.
#include <rocksdb/db.h>
#include <catch2/catch.hpp>

#include "scratch_directory.h"
#include "store/edit_database.h"
#include "store/read_only_store.h"

namespace talus::server {
namespace {

struct Store {
  ScratchDirectory scratch;
  EditDatabaseSettings settings{.path = scratch / "edits", .fingerprint = {1, 2}, .store_id = {3, 4}};

  [[nodiscard]] std::string open() const {
    const auto database = EditDatabase::open(settings);
    return database ? std::string{} : database.error();
  }
};

}  // namespace

TEST_CASE("a store of another world is refused with both fingerprints") {
  Store store;
  REQUIRE(store.open() == "");
  REQUIRE(store.open() == "");
  store.settings.fingerprint = {5, 6};
  const std::string error = store.open();
  CHECK(error.find("fingerprint 00000000000000020000000000000001") != std::string::npos);
  CHECK(error.find("fingerprint 00000000000000060000000000000005") != std::string::npos);
  CHECK(error.find("give --data another directory") != std::string::npos);
  store.settings.fingerprint = {1, 2};
  store.settings.store_id = {7, 7};
  CHECK(store.open().find("belong to store 00000000000000040000000000000003") != std::string::npos);
}

TEST_CASE("a store of a newer format is refused by its number") {
  Store store;
  REQUIRE(store.open() == "");
  rocksdb::DB* db = nullptr;
  REQUIRE(rocksdb::DB::Open({}, (store.settings.path / "db").string(), &db).ok());
  REQUIRE(db->Put({}, meta_key(), std::string("\x02whatever")).ok());
  delete db;
  CHECK(store.open().find("the store has format 2; this talusd reads format 1") != std::string::npos);
}

TEST_CASE("a database without the store's state is refused") {
  Store store;
  REQUIRE(store.open() == "");
  rocksdb::DB* db = nullptr;
  REQUIRE(rocksdb::DB::Open({}, (store.settings.path / "db").string(), &db).ok());
  REQUIRE(db->Delete({}, meta_key()).ok());
  delete db;
  CHECK(store.open().find("its record of the store's state is missing") != std::string::npos);
}

TEST_CASE("names of materials are bound to ids for ever") {
  Store store;
  {
    const auto database = EditDatabase::open(store.settings).value().release();
    const std::unique_ptr<EditDatabase> owner{database};
    CHECK(database->bind({{"stone", MaterialId{1}}, {"planks", MaterialId{300}}}).has_value());
    CHECK(database->bind({{"glass", MaterialId{301}}, {"stone", MaterialId{1}}}).has_value());
    const auto moved = database->bind({{"lamp", MaterialId{302}}, {"planks", MaterialId{301}}});
    REQUIRE_FALSE(moved.has_value());
    CHECK(moved.error().find("material planks has id 300 in the store and 301 here") != std::string::npos);
    const auto taken = database->bind({{"lamp", MaterialId{301}}});
    REQUIRE_FALSE(taken.has_value());
    CHECK(taken.error().find("material id 301 is glass in the store and lamp here") != std::string::npos);
  }
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  CHECK((*database)->materials() == std::map<std::string, MaterialId>{{"glass", MaterialId{301}},
                                                                      {"planks", MaterialId{300}},
                                                                      {"stone", MaterialId{1}}});
}

TEST_CASE("names of what the world generates follow the world, and may not be those of what is placed") {
  Store store;
  const auto database = EditDatabase::open(store.settings).value().release();
  const std::unique_ptr<EditDatabase> owner{database};
  CHECK(database->bind({{"planks", MaterialId{300}}}).has_value());
  CHECK(database->name_generated({{"stone", MaterialId{2}}, {"mud", MaterialId{3}}}).has_value());
  CHECK(database->name_generated({{"granite", MaterialId{2}}, {"stone", MaterialId{3}}}).has_value());
  const std::map<std::string, MaterialId> names{
      {"granite", MaterialId{2}}, {"planks", MaterialId{300}}, {"stone", MaterialId{3}}};
  CHECK(database->materials() == names);
  const auto refused = database->name_generated({{"planks", MaterialId{2}}});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("material planks is one that may be placed in the store, with id 300") !=
        std::string::npos);
  owner->settle().value();
}

TEST_CASE("a checkpoint is a store of its own, and the first goes on") {
  Store store;
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  CHECK((*database)->bind({{"planks", MaterialId{300}}}).has_value());
  std::filesystem::create_directory(store.scratch / "copy");
  REQUIRE((*database)->checkpoint(store.scratch / "copy" / "db").has_value());
  CHECK((*database)->bind({{"glass", MaterialId{301}}}).has_value());
  const auto copy = ReadOnlyStore::open(store.scratch / "copy");
  REQUIRE(copy.has_value());
  CHECK((*copy)->materials() == std::map<std::string, MaterialId>{{"planks", MaterialId{300}}});
  CHECK((*copy)->meta() == (*database)->meta());
  // A name that is taken is an error, and leaves what is there.
  CHECK_FALSE((*database)->checkpoint(store.scratch / "copy" / "db").has_value());
  CHECK(ReadOnlyStore::open(store.scratch / "copy").has_value());
}

}  // namespace talus::server
