// The bytes that servers of one world write to each other: what is written is read back, and anything else is
// refused.
#include <algorithm>
#include <memory>
#include <random>

#include <talus/store/bytes.h>
#include <talus/voxel/codec.h>
#include <xxhash.h>
#include <catch2/catch.hpp>

#include "cluster/entry_codec.h"
#include "cluster/log_format.h"
#include "cluster/message.h"
#include "edits/model.h"
#include "seed_of_run.h"

namespace talus::server::cluster {
namespace {

std::string hex_of(std::span<const std::byte> bytes) {
  std::string hex;
  for (const std::byte byte : bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    hex += kDigits[std::to_integer<std::size_t>(byte >> 4)];
    hex += kDigits[std::to_integer<std::size_t>(byte & std::byte{15})];
  }
  return hex;
}

const store::StoreIdentity kIdentity{{1, 2}, {3, 4}};

edits::SettleRulesPtr sand_slides() {
  return std::make_shared<const edits::SettleRules>(edits::SettleRules{{MaterialId{3}, 160}});
}

Genesis small_genesis() {
  Genesis genesis;
  genesis.identity = kIdentity;
  genesis.head = {.position = 9, .revision = 5, .time_ms = 7, .hash = {10, 11}};
  genesis.settles = *sand_slides();
  genesis.materials = {{"glass", MaterialId{257}}, {"lamp", MaterialId{256}}};
  return genesis;
}

edits::EditEntry small_edit() {
  edits::EditEntry entry{{5, 6}, 2, 9, {}, {}, sand_slides(), "bob"};
  entry.edit.guards.push_back({{-1, 2, 3}, kAir});
  entry.edit.writes.push_back({{-1, 2, 3}, MaterialId{3}});
  entry.edit.writes.push_back({{0, 2, 3}, MaterialId{300}});
  entry.edit.fills.push_back({{0, 0, 0}, {1, 1, 1}, std::nullopt, MaterialId{3}});
  entry.base = {{{-1, 0, 0}, {{2145, kAir}}}, {{0, 0, 0}, {{0, MaterialId{1}}, {2144, kAir}}}};
  return entry;
}

BatchHead small_head() {
  return {kIdentity, 77, 3, 1'700'000'000'000, 5, {10, 11}};
}

store::Bytes bytes_of_entry(const LogEntry& entry) {
  store::Bytes bytes;
  encode(entry, bytes);
  return bytes;
}

/// Every bit flipped and every end cut off must be refused.
template <typename Decode>
void check_damage(const store::Bytes& value, const Decode& decode) {
  for (std::size_t bit = 0; bit < value.size() * 8; ++bit) {
    store::Bytes damaged = value;
    damaged[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    if (decode(damaged)) FAIL("bit " << bit << " makes no difference");
  }
  for (std::size_t size = 0; size < value.size(); ++size) {
    const store::Bytes cut(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(size));
    if (decode(cut)) FAIL(size << " bytes are enough");
  }
}

/// Edits of every kind: pastes, settling ones, ones that no sound server writes.
edits::EditEntry any_edit(std::mt19937_64& random) {
  const auto below = [&](std::uint64_t bound) { return random() % bound; };
  const auto material = [&] { return MaterialId{static_cast<std::uint16_t>(below(UINT16_MAX + 1))}; };
  const auto voxel = [&]() -> VoxelPos {
    const auto at = [&] {
      return below(10) == 0 ? static_cast<std::int64_t>(random())
                            : static_cast<std::int64_t>(below(600)) - 300;
    };
    return {at(), at(), at()};
  };
  const auto maybe = [&] { return below(2) == 0 ? std::nullopt : std::optional{material()}; };
  edits::EditEntry entry{{random(), random()}, random(), below(1'000), {}, {}, nullptr, {}};
  if (below(2) == 0) entry.settles = sand_slides();
  if (below(2) == 0) entry.subject = std::string(below(257), 'x');
  for (std::uint64_t left = below(5); left > 0; --left) entry.edit.guards.push_back({voxel(), material()});
  for (std::uint64_t left = below(5); left > 0; --left) entry.edit.writes.push_back({voxel(), material()});
  for (std::uint64_t left = below(3); left > 0; --left) {
    entry.edit.fills.push_back({voxel(), voxel(), maybe(), maybe()});
  }
  if (below(3) == 0) {
    edits::Paste paste{voxel(), Chunk::uniform(material()), below(2) == 0};
    entry.edit.paste = std::move(paste);
  }
  for (std::uint64_t left = below(4); left > 0; --left) {
    std::vector<Override>& voxels = entry.base[{static_cast<std::int32_t>(random()), 0, 1}];
    for (std::uint16_t index = 0; index < below(200); ++index) voxels.push_back({index, material()});
  }
  if (below(3) == 0) {
    entry.secrets.see_through = {kAir, MaterialId{static_cast<std::uint16_t>(1 + below(60'000))}};
    entry.secrets.hidden[{1, -2, 3}] = {{5, material()}, {700, material()}};
    entry.secrets.base[{1, -2, 3}] = {{5, material()}, {700, material()}};
  }
  return entry;
}

}  // namespace

TEST_CASE("messages of the shared log are as in FORMAT.md, byte by byte") {
  const auto genesis = encode(small_genesis());
  REQUIRE(genesis.has_value());
  CHECK(hex_of(*genesis) ==
        "0100010000000000000002000000000000000300000000000000040000000000000001000000090000000000"
        "0000070000000000000005000000000000000a000000000000000b000000000000000103c0020205676c6173"
        "738102046c616d708002d93c8673f3397950");
  const std::vector<store::Bytes> entries{bytes_of_entry(edits::AttachEntry{{5, 6}, 2, "bob"}),
                                          bytes_of_entry(small_edit()),
                                          bytes_of_entry(edits::BindEntry{{"glass"}})};
  CHECK(hex_of(entries[0]) == "0100050000000000000006000000000000000203626f62");
  CHECK(hex_of(entries[1]) ==
        "010105000000000000000600000000000000020903626f620101010406000201040603020000ac0201000000"
        "02020200040201000006010001e1100000000009020001020001df1000");
  CHECK(hex_of(entries[2]) == "01020105676c617373");
  CHECK(hex_of(encode_batch(small_head(), sand_slides(), entries)) ==
        "010101000000000000000200000000000000030000000000000004000000000000004d000000000000000380"
        "d095ffbc3105000000000000000a000000000000000b00000000000000010103c00203170100050000000000"
        "000006000000000000000203626f6249010105000000000000000600000000000000020903626f6201010104"
        "06000201040603020000ac020100000002020200040201000006010001e1100000000009020001020001df10"
        "000901020105676c617373b798c4a7590b13ca");
}

TEST_CASE("a genesis is read back, and damage is seen") {
  const store::Bytes bytes = *encode(small_genesis());
  const auto read = decode_genesis(bytes);
  REQUIRE(read.has_value());
  CHECK(*read == small_genesis());
  check_damage(bytes, [](const store::Bytes& each) { return decode_genesis(each).has_value(); });
  Genesis large = small_genesis();
  for (std::uint16_t id = 256; id < 20'000; ++id) {
    large.materials.emplace(std::string(40, 'm') + std::to_string(id), MaterialId{id});
  }
  const auto refused = encode(large);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("message has at most 523264") != std::string::npos);
}

TEST_CASE("a batch is read by servers of its store and world, and damage is detected") {
  const std::vector<store::Bytes> entries{bytes_of_entry(edits::AttachEntry{{5, 6}, 2, "bob"}),
                                          bytes_of_entry(small_edit())};
  const store::Bytes bytes = encode_batch(small_head(), sand_slides(), entries);
  const auto read = decode_batch(bytes, kIdentity);
  REQUIRE(read.has_value());
  CHECK(read->head == small_head());
  CHECK(*read->settles == *sand_slides());
  REQUIRE(read->entries.size() == 2);
  CHECK(std::equal(entries[1].begin(), entries[1].end(), read->entries[1].begin(), read->entries[1].end()));
  check_damage(bytes, [](const store::Bytes& each) { return decode_batch(each, kIdentity).has_value(); });
  // None at all: where a server says where it stands.
  const store::Bytes none = encode_batch(small_head(), nullptr, {});
  REQUIRE(decode_batch(none, kIdentity).has_value());
  CHECK(decode_batch(none, kIdentity)->settles == nullptr);

  using Kind = MessageFault::Kind;
  const auto other_store = decode_batch(bytes, {{1, 1}, kIdentity.fingerprint});
  REQUIRE_FALSE(other_store.has_value());
  CHECK(other_store.error().kind == Kind::other_store);
  const auto other_world = decode_batch(bytes, {kIdentity.store_id, {1, 1}});
  REQUIRE_FALSE(other_world.has_value());
  CHECK(other_world.error().kind == Kind::other_world);
  CHECK(other_world.error().reason.find("the same world") != std::string::npos);
  store::Bytes newer = bytes;
  newer.front() = std::byte{kMessageFormat + 1};
  CHECK(decode_batch(newer, kIdentity).error().kind == Kind::damaged);
  newer.resize(newer.size() - kSealBytes);
  store::ByteWriter{newer}.fixed64(XXH3_64bits(newer.data(), newer.size()));
  CHECK(decode_batch(newer, kIdentity).error().kind == Kind::newer);
  CHECK(decode_batch(newer, {{1, 1}, kIdentity.fingerprint}).error().kind == Kind::other_store);
  CHECK(decode_batch(*encode(small_genesis()), kIdentity).error().kind == Kind::damaged);
  CHECK(decode_genesis(bytes).error().kind == Kind::damaged);
  CHECK(decode_batch(store::Bytes(kMaxMessageBytes + 1, std::byte{1}), kIdentity).error().kind ==
        Kind::damaged);
}

TEST_CASE("entries of every kind are read back") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  for (int i = 0; i < 300; ++i) {
    const edits::EditEntry entry = any_edit(random);
    const store::Bytes bytes = bytes_of_entry(entry);
    const auto read = decode_entry(bytes, sand_slides());
    REQUIRE(read.has_value());
    const auto& edit = std::get<edits::EditEntry>(*read);
    CHECK(edit.editor == entry.editor);
    CHECK(edit.epoch == entry.epoch);
    CHECK(edit.sequence == entry.sequence);
    CHECK(edit.subject == entry.subject);
    CHECK((edit.settles != nullptr) == (entry.settles != nullptr));
    CHECK(edit.edit.guards == entry.edit.guards);
    CHECK(edit.edit.writes == entry.edit.writes);
    CHECK(edit.edit.fills.size() == entry.edit.fills.size());
    CHECK(edit.edit.paste.has_value() == entry.edit.paste.has_value());
    CHECK(edit.base == entry.base);
    CHECK(bytes_of_entry(*read) == bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      if (decode_entry(std::span{bytes}.first(size), sand_slides())) FAIL(size << " bytes are enough");
    }
  }
  const auto bind = decode_entry(bytes_of_entry(edits::BindEntry{{"glass", "lamp"}}), nullptr);
  REQUIRE(bind.has_value());
  CHECK(std::get<edits::BindEntry>(*bind).names == std::vector<std::string>{"glass", "lamp"});
  const auto attach = decode_entry(bytes_of_entry(edits::AttachEntry{{5, 6}, 2, "bob"}), nullptr);
  REQUIRE(attach.has_value());
  CHECK(std::get<edits::AttachEntry>(*attach).epoch == 2);
}

TEST_CASE("a stream's description names the first message that may be newer") {
  const std::vector<EnabledFormat> two{{2, 1'000'000}, {3, 5'000'000'000}};
  CHECK(enabled_formats("log format 2 from message 1000000").list == std::vector{two[0]});
  for (const auto* const text : {"log format 2 from message 1000000",
                                 "log format 2 from message 1000000, 3 from message 5000000000"}) {
    CHECK(enabled_formats(text).understood);
    CHECK(to_string(enabled_formats(text)) == text);
  }
  CHECK(enabled_formats("log format 2 from message 1000000, 3 from message 5000000000").list == two);
  for (const char* const none : {"", "log", "log forma", "the log format of a world", "a log format 2"}) {
    CAPTURE(none);
    CHECK(enabled_formats(none) == EnabledFormats{});
    CHECK(to_string(enabled_formats(none)) == "log format 1");
  }
  CHECK_FALSE(EnabledFormats{}.has_newer());
  CHECK_FALSE(EnabledFormats{}.is_newer_at(1'000'000'000));
  const EnabledFormats enabled{{{kLogFormat, 5}, {kLogFormat + 1, 8}, {kLogFormat + 2, 11}}, true};
  CHECK(enabled.has_newer());
  CHECK(enabled.newer_from() == 8);
  CHECK_FALSE(enabled.is_newer_at(7));
  CHECK(enabled.is_newer_at(8));
  CHECK(enabled.is_newer_at(11));
  CHECK_FALSE(EnabledFormats{{{kLogFormat, 5}}, true}.has_newer());
}

TEST_CASE("a description that speaks of formats otherwise lets no message be passed over") {
  for (const char* const other : {"log format",
                                  "log format ",
                                  "log format 2",
                                  "log format 2 from message ",
                                  "log format 2 from message 5.",
                                  "log format 2 from message 5 ",
                                  "log format 2 from message 5,",
                                  "log format 2 from message 5, 3",
                                  "log format 2 from message 5,3 from message 9",
                                  "log format 2 from message 5, 3 from message 5",
                                  "log format 2 from message 5, 2 from message 9",
                                  "log format 3 from message 5, 2 from message 9",
                                  "log format 2 from message 5; 3 from message 9",
                                  "log format 2 from message 0",
                                  "log format 0 from message 5",
                                  "log format 02 from message 5",
                                  "log format -2 from message 5",
                                  "log format 2 from message +5",
                                  "log format 2 from message 99999999999999999999",
                                  "log format 4294967296 from message 5",
                                  "Log format 2 from message 5",
                                  "LOG FORMAT",
                                  "log format soon 2 from message 5",
                                  "log format 2 from message 5, soon 3 from message 9",
                                  "log formats"}) {
    CAPTURE(other);
    CHECK_FALSE(enabled_formats(other).understood);
    CHECK(enabled_formats(other).is_newer_at(1));
    CHECK(enabled_formats(other).has_newer());
  }
}

TEST_CASE("newer entries are distinguished from damaged ones") {
  store::Bytes bytes = bytes_of_entry(small_edit());
  CHECK(decode_entry(bytes, nullptr).error() == EntryFault::damaged);  // it settles, and nothing says how
  bytes[0] = std::byte{kEntryFormat + 1};
  CHECK(decode_entry(bytes, sand_slides()).error() == EntryFault::newer);
  bytes[0] = std::byte{kEntryFormat};
  bytes[1] = std::byte{9};
  CHECK(decode_entry(bytes, sand_slides()).error() == EntryFault::newer);
  CHECK(decode_entry({}, nullptr).error() == EntryFault::damaged);
  // What it pastes: the payload of a chunk of one material, by its codec.
  edits::EditEntry pastes;
  pastes.edit.paste = edits::Paste{{0, 0, 0}, Chunk::uniform(MaterialId{7}), false};
  store::Bytes pasted = bytes_of_entry(pastes);
  store::Bytes payload;
  talus::encode(pastes.edit.paste->voxels, payload);
  const auto at = std::search(pasted.begin(), pasted.end(), payload.begin(), payload.end());
  REQUIRE(at != pasted.end());
  *at = std::byte{200};
  CHECK(decode_entry(pasted, nullptr).error() == EntryFault::newer);
}

TEST_CASE("an entry that names more voxels than it has bytes for takes no memory") {
  // Whole chunks of one material are six bytes each: as many as an edit may touch are taken, no more.
  edits::EditEntry entry = small_edit();
  entry.base.clear();
  std::vector<Override> all;
  for (std::uint16_t index = 0; index < kChunkVolume; ++index) all.push_back({index, MaterialId{1}});
  for (std::int32_t x = 0; x < 3; ++x) entry.base.emplace(ChunkCoord{x, 0, 0}, all);
  const store::Bytes bytes = bytes_of_entry(entry);
  CHECK(bytes.size() < 200);
  CHECK(decode_entry(bytes, sand_slides()).error() == EntryFault::damaged);
  store::Bytes many{std::byte{kEntryFormat}, std::byte{2}, std::byte{255}, std::byte{255}, std::byte{3}};
  CHECK(decode_entry(many, nullptr).error() == EntryFault::damaged);
}

}  // namespace talus::server::cluster
