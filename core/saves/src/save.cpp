#include <talus/saves/save.h>

#include <string>
#include <system_error>
#include <utility>

#include <talus/terrain/world.h>

#include "database.h"
#include "save_form.h"

namespace talus::saves {
namespace {

using Kind = SaveError::Kind;

// A transaction that ends with its block.
class Transaction {
 public:
  explicit Transaction(SaveFile& file) : file_{file} {}
  ~Transaction() { file_.roll_back(); }  // nothing after a commit
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

 private:
  SaveFile& file_;
};

// A file that goes away if it is made and not finished.
struct NewFile {
  std::filesystem::path path;
  bool is_made = false;
  ~NewFile() {
    std::error_code code;
    if (is_made) std::filesystem::remove(path, code);
  }
};

}  // namespace

tl::expected<WorldSource, local::SpecProblem> read_world(std::span<const std::byte> toml,
                                                         const local::FileReader& files) {
  WorldSource source;
  local::FileReader recorded;
  if (files) {
    recorded = [&](const std::string& name) {
      auto bytes = files(name);
      if (bytes) source.saved.files[name] = *bytes;
      return bytes;
    };
  }
  auto world = local::open_world(toml, recorded);
  if (!world) return tl::unexpected{std::move(world.error())};
  source.world = *std::move(world);
  source.saved.spec.assign(reinterpret_cast<const char*>(toml.data()), toml.size());
  source.saved.generator = terrain::to_integer(source.world->generator_version());
  source.saved.fingerprint = to_string(source.world->fingerprint());
  source.saved.materials = *local::material_ids(*source.world);  // far fewer than there are ids
  return source;
}

Result<std::shared_ptr<const local::World>> world_of(const SaveFile& file) {
  const SavedWorld& saved = file.world();
  const int newest = terrain::to_integer(terrain::kNewestGeneratorVersion);
  const auto other_version = [&](int here) {
    return refused(file.path(), Kind::other,
                   "its world is of generator version " + std::to_string(saved.generator) +
                       ", and this program makes version " + std::to_string(here) +
                       " of it; use the release of Talus that made it");
  };
  if (saved.generator > newest) return other_version(newest);
  const auto read = [&](const std::string& name) -> tl::expected<std::vector<std::byte>, std::string> {
    const auto found = saved.files.find(name);
    if (found == saved.files.end()) return tl::unexpected<std::string>{"is not in the save"};
    return found->second;
  };
  auto world = local::open_world(std::as_bytes(std::span{saved.spec}), read);
  if (!world) {
    return refused(file.path(), Kind::other,
                   "this program refuses its world: " + world.error().message +
                       "; use the release of Talus that made it");
  }
  const int here = terrain::to_integer((*world)->generator_version());
  if (here != saved.generator) return other_version(here);
  const std::string fingerprint = to_string((*world)->fingerprint());
  if (fingerprint != saved.fingerprint) {
    return refused(file.path(), Kind::other,
                   "its world has the fingerprint " + saved.fingerprint +
                       ", and this program makes another, " + fingerprint +
                       "; use the release of Talus that made it");
  }
  return *std::move(world);
}

Save::Save(SaveFile file, std::shared_ptr<const local::World> world, local::Edits edits,
           std::uint64_t revision)
    : file_{std::move(file)}, world_{std::move(world)}, edits_{std::move(edits)}, revision_{revision} {}

Result<Save> Save::create(const std::filesystem::path& file, const WorldSource& source, local::Edits edits,
                          std::uint64_t revision) {
  SavedWorld saved = source.saved;
  saved.settles = edits.settings().settles;
  NewFile unfinished{file};  // outlives the open file
  auto made = SaveFile::create(file, saved);
  if (!made) return tl::unexpected{std::move(made.error())};
  unfinished.is_made = true;
  Save save{*std::move(made), source.world, std::move(edits), revision};
  for (const ChunkCoord chunk : save.edits_.changed_chunks()) save.changed_.insert(chunk);
  if (auto done = save.commit(); !done) return tl::unexpected{std::move(done.error())};
  unfinished.is_made = false;
  return save;
}

Result<Save> Save::open(const std::filesystem::path& file, Access access) {
  auto opened = SaveFile::open(file, access);
  if (!opened) return tl::unexpected{std::move(opened.error())};
  auto world = world_of(*opened);
  if (!world) return tl::unexpected{std::move(world.error())};
  const auto placeables = local::placeable_ids(**world, opened->world().materials);
  if (!placeables) return damaged(file, "its materials leave no ids for others");
  local::Edits edits{{opened->world().settles, *placeables}};
  std::string fault;
  while (fault.empty()) {
    const auto chunk = opened->next_chunk();
    if (!chunk) return tl::unexpected{chunk.error()};
    if (!*chunk) break;
    const auto restored = edits.restore(**world, (*chunk)->chunk, (*chunk)->runs);
    if (!restored) fault = restored.error().message;
  }
  if (fault.empty() && edits.hash() != opened->state().hash) {
    fault = "the hash of its edits is " + edits::to_string(edits.hash()) + " and should be " +
            edits::to_string(opened->state().hash);
  }
  if (!fault.empty()) {
    return damaged(file, fault);
  }
  const std::uint64_t revision = opened->state().revision;
  return Save{*std::move(opened), *std::move(world), std::move(edits), revision};
}

tl::expected<local::EditOutcome, edits::EditError> Save::apply(local::Workspace& workspace,
                                                               const edits::Edit& edit) {
  auto outcome = edits_.apply(workspace, edit);
  if (outcome && outcome->changed > 0) {
    ++revision_;
    const bool had_all = std::exchange(all_changed_, true);  // until each is noted
    for (const ChunkKey& key : outcome->chunks) {
      if (key.lod == Lod{}) changed_.insert(key.coord);
    }
    all_changed_ = had_all;
  }
  return outcome;
}

Result<void> Save::commit() {
  const SaveState state{revision_, edits_.hash()};
  if (!has_changes() && state == file_.state()) return {};
  const Transaction transaction{file_};
  auto done = file_.begin();
  const auto put = [&](const auto& chunks) {
    for (const ChunkCoord chunk : chunks) {
      if (done) done = file_.put(chunk, edits_.overrides(chunk));
    }
  };
  if (done && all_changed_) {
    done = file_.clear();
    put(edits_.changed_chunks());
  } else {
    put(changed_);
  }
  if (done) done = file_.commit(state);
  if (!done) return done;
  changed_.clear();
  all_changed_ = false;
  return {};
}

}  // namespace talus::saves
