#include "sample_frames.h"

#include <array>
#include <limits>

namespace talus::protocol::testing {
namespace {

constexpr std::int32_t kFarthest = std::numeric_limits<std::int32_t>::min();
const wire::ChunkKey kKey{-3, 1, kFarthest, 2};
const wire::Hash128 kHash{0x0123456789ABCDEFU, 0xFEDCBA9876543210U};
const wire::Voxel kVoxel{-(std::int64_t{1} << 36), 70, 12};

const std::array<wire::VoxelWrite, 2> kWrites{wire::VoxelWrite{kVoxel, 3},
                                              wire::VoxelWrite{wire::Voxel{0, 1, 2}, 65535}};

Frame get_chunks() {
  return make_frame([](auto& b) {
    const std::array requests{wire::ChunkRequest{7, kKey, true, kHash},
                              wire::ChunkRequest{8, wire::ChunkKey{0, 0, 0, 0}, false, wire::Hash128{}}};
    return wire::CreateGetChunks(b, b.CreateVectorOfStructs(requests.data(), requests.size()));
  });
}

Frame get_heights() {
  return make_frame([](auto& b) {
    const std::array columns{wire::ColumnPos{-5, 9}, wire::ColumnPos{std::int64_t{1} << 36, 0}};
    const auto column_vector = b.CreateVectorOfStructs(columns.data(), columns.size());
    return wire::CreateGetHeights(b, 9, column_vector, true, b.CreateVector(std::vector<std::uint8_t>{1, 0}));
  });
}

Frame welcome() {
  return make_frame([](auto& b) {
    const std::vector materials{
        wire::CreateMaterial(b, 0, b.CreateString("air"), 0, wire::Phase::gas),
        wire::CreateMaterial(b, 2, b.CreateString("granite"), 0x6E6A6F, wire::Phase::solid)};
    const auto material_vector = b.CreateVector(materials);
    const auto session = wire::CreateRates(b, 4096, std::uint64_t{1} << 24, 1000, 32000);
    const auto address = wire::CreateRates(b, 8192, 0, 2000, 32000);
    const auto limits =
        wire::CreateLimits(b, 65536, 256, 4096, 32, 16, 40000, 1U << 20, 60000, session, address, true, true);
    const auto server = b.CreateString("talusd 0.1.0");
    const wire::Hash128 store{1, 2};
    const auto looks = b.CreateVectorOfStrings({"", "snow"});
    const auto fields = b.CreateVectorOfStrings({"height", "temperature"});
    return wire::CreateWelcome(b, 1, 1, &kHash, &store, 32, material_vector, 0, 320, &kVoxel, limits, server,
                               looks, fields, b.CreateString("/v1/0123/world.toml"));
  });
}

Frame column() {
  return make_frame([](auto& b) {
    const std::array runs{wire::UniformRun{kFarthest, -1, 2}, wire::UniformRun{10, 11, 0}};
    return wire::CreateUniformColumn(b, -4, 5, 1, 6, b.CreateVectorOfStructs(runs.data(), runs.size()));
  });
}

Frame error() {
  return make_frame([](auto& b) {
    return wire::CreateError(b, wire::ErrorCode::overloaded, b.CreateString("come back later"), 7, 250,
                             wire::ErrorAbout::repeated_request, 7, 12, &kKey);
  });
}

Frame edit() {
  return make_frame([](auto& b) {
    const auto writes = b.CreateVectorOfStructs(kWrites.data(), kWrites.size());
    const auto guards = b.CreateVectorOfStructs(kWrites.data(), 1);
    const std::array fills{wire::Fill{{-1, 2, -3}, {4, 5, 6}, 3, 0, 1}};
    const auto fill_vector = b.CreateVectorOfStructs(fills.data(), fills.size());
    const auto payload = b.CreateVector(std::vector<std::uint8_t>{4, 0, 1});
    const auto paste = wire::CreatePaste(b, &kVoxel, payload, true);
    const auto subject = b.CreateString("alice");
    return wire::CreateEdit(b, 11, writes, 21, guards, fill_vector, paste, subject);
  });
}

Frame edit_broadcast() {
  return make_frame([](auto& b) {
    // Voxels 5 to 7 of material 3, and 8 and 40 of material 300.
    const std::vector<std::uint8_t> runs{2, 3, 0xAC, 2, 3, 5, 4, 0, 1, 0x1F, 1};
    const auto writes = b.CreateVectorOfStructs(kWrites.data(), kWrites.size());
    return wire::CreateEditBroadcast(b, &kKey, 13, 12, writes, b.CreateVector(runs));
  });
}

}  // namespace

Frame sample_hello() {
  return make_frame([](auto& b) {
    const std::array<std::uint8_t, 1> codecs{1};
    const auto codec_vector = b.CreateVector(codecs.data(), codecs.size());
    const auto token = b.CreateString("open sesame");
    const auto client = b.CreateString("sample 1.0");
    return wire::CreateHello(b, 1, 2, codec_vector, token, client, 1U << 20);
  });
}

Frame sample_view(bool newer_fields) {
  return make_frame([&](auto& b) {
    const wire::Direction direction{0.0F, -0.5F, 1.0F};
    const std::array rings{wire::LodRing{1, 16}, wire::LodRing{2, 32}};
    const auto ring_vector = b.CreateVectorOfStructs(rings.data(), rings.size());
    const wire::KnownChunk known{kKey, kHash};
    return wire::CreateView(b, &kVoxel, &direction, 8, 4, ring_vector, b.CreateVectorOfStructs(&known, 1), 12,
                            newer_fields, newer_fields);
  });
}

Frame sample_chunk() {
  return make_frame([](auto& b) {
    const std::array<std::uint8_t, 5> payload{1, 2, 3, 4, 5};
    const auto payload_vector = b.CreateVector(payload.data(), payload.size());
    return wire::CreateChunk(b, 7, &kKey, 42, &kHash, 1, payload_vector);
  });
}

std::vector<Sample> sample_frames() {
  using wire::Body;
  const auto simple = [](Body kind, auto&& build) { return Sample{kind, make_frame(build)}; };
  const std::vector<std::uint32_t> ids{7, 8};
  const std::vector<std::int32_t> heights{0, -256, 1 << 23};
  return {
      {Body::Hello, sample_hello()},
      {Body::View, sample_view(true)},
      {Body::GetChunks, get_chunks()},
      simple(Body::Cancel, [&](auto& b) { return wire::CreateCancel(b, b.CreateVector(ids)); }),
      {Body::GetHeights, get_heights()},
      simple(Body::Credit, [](auto& b) { return wire::CreateCredit(b, std::uint64_t{1} << 40); }),
      {Body::Edit, edit()},
      simple(Body::Ping, [](auto& b) { return wire::CreatePing(b, 5); }),
      {Body::Welcome, welcome()},
      {Body::Chunk, sample_chunk()},
      simple(Body::Unchanged, [](auto& b) { return wire::CreateUnchanged(b, 8, &kKey, 42, &kHash); }),
      {Body::UniformColumn, column()},
      simple(Body::Heights,
             [&](auto& b) {
               const auto heights_fx = b.CreateVector(heights);
               const auto looks = b.CreateVector(std::vector<std::uint8_t>{0, 1, 1});
               return wire::CreateHeights(b, 9, heights_fx, looks,
                                          b.CreateVector(std::vector<float>{0.5F, -0.25F, 3}));
             }),
      {Body::Error, error()},
      simple(Body::EditResult, [](auto& b) { return wire::CreateEditResult(b, 11, 43, 2); }),
      {Body::EditBroadcast, edit_broadcast()},
      simple(Body::Pong, [](auto& b) { return wire::CreatePong(b, 5); }),
      simple(Body::GoAway, [](auto& b) { return wire::CreateGoAway(b, b.CreateString("restart"), 3000); }),
      simple(Body::ViewComplete, [](auto& b) { return wire::CreateViewComplete(b, 12); }),
      simple(Body::Attach, [](auto& b) { return wire::CreateAttach(b, &kHash, 42); }),
      simple(Body::Attached,
             [](auto& b) {
               const auto limits = wire::CreateEditLimits(b, 65'536, 64, 64, 65'536);
               return wire::CreateAttached(b, &kHash, 3, 20, true, 42, limits);
             }),
      simple(Body::GetFile,
             [](auto& b) { return wire::CreateGetFile(b, 13, b.CreateString("models/rock.vox"), 65'536); }),
      simple(Body::FilePart,
             [](auto& b) {
               return wire::CreateFilePart(b, 13, 65'539, b.CreateVector(std::vector<std::uint8_t>{7, 8, 9}));
             }),
  };
}

}  // namespace talus::protocol::testing
