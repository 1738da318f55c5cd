#include <talus/local_source/local_source.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include <talus/local/local.h>

namespace talus {
namespace {

using client::MadeChunk;

// One thread's memory to generate in, for the world it made last, and that world's uniform chunks.
class Thread {
 public:
  explicit Thread(std::size_t ground_bytes) : ground_bytes_{ground_bytes} {}

  std::vector<MadeChunk> make(const std::shared_ptr<const local::World>& world,
                              const std::vector<ChunkKey>& keys, const std::atomic<bool>& cancel) {
    if (!workspace_ || world_ != world) {
      workspace_.reset();  // two at once would be too much memory
      workspace_.emplace(world, ground_bytes_);
      world_ = world;
    }
    Taker taker{uniform_, {}};
    taker.made.reserve(keys.size());
    local::generate(*workspace_, keys, taker, &cancel);
    return std::move(taker.made);
  }

  // Generating failed, as when memory ran out.
  void forget() {
    workspace_.reset();
    world_.reset();
  }

 private:
  struct Uniform {
    ContentHash hash;
    std::shared_ptr<const Chunk> chunk;
  };
  using Uniforms = std::unordered_map<MaterialId, Uniform>;

  struct Taker final : local::ChunkSink {
    Taker(Uniforms& shared, std::vector<MadeChunk> chunks) : uniforms{shared}, made{std::move(chunks)} {}
    void take(ChunkKey key, const Chunk& chunk) override {
      if (!chunk.is_uniform()) {
        made.push_back({key, content_hash(chunk), std::make_shared<const Chunk>(chunk)});
        return;
      }
      Uniform& uniform = uniforms[chunk.at({})];
      if (uniform.chunk == nullptr) uniform = {content_hash(chunk), std::make_shared<const Chunk>(chunk)};
      made.push_back({key, uniform.hash, uniform.chunk});
    }
    Uniforms& uniforms;
    std::vector<MadeChunk> made;
  };

  std::size_t ground_bytes_;
  std::shared_ptr<const local::World> world_;
  std::optional<local::Workspace> workspace_;
  Uniforms uniform_;  // at most one per material
};

using Job = std::function<void(Thread&)>;

std::string why(const std::exception& thrown) {
  const bool memory = dynamic_cast<const std::bad_alloc*>(&thrown) != nullptr;
  return memory ? "memory ran out" : thrown.what();
}

}  // namespace

class LocalSource::Jobs {
 public:
  void add(Job job) {
    {
      const std::lock_guard lock{mutex_};
      if (stopped_) return;
      waiting_.push_back(std::move(job));
    }
    changed_.notify_one();
  }

  // Runs jobs until stop().
  void run(Thread& thread) {
    while (true) {
      Job job;
      {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [this] { return stopped_ || !waiting_.empty(); });
        if (stopped_) return;
        job = std::move(waiting_.front());
        waiting_.pop_front();
      }
      job(thread);
    }
  }

  void stop() {
    std::deque<Job> dropped;  // without the lock: what they hold may be the last of a world
    {
      const std::lock_guard lock{mutex_};
      stopped_ = true;
      dropped.swap(waiting_);
    }
    changed_.notify_all();
  }

  [[nodiscard]] bool is_stopped() const {
    const std::lock_guard lock{mutex_};
    return stopped_;
  }

  // A world, and where its chunks are made.
  class World final : public client::LocalWorld {
   public:
    World(std::shared_ptr<const local::World> world, std::shared_ptr<Jobs> jobs)
        : world_{std::move(world)}, jobs_{std::move(jobs)} {}

    [[nodiscard]] ContentHash fingerprint() const override { return world_->fingerprint(); }

    void make(std::vector<ChunkKey> keys, std::shared_ptr<const std::atomic<bool>> cancel,
              Made done) override {
      jobs_->add([world = world_, keys = std::move(keys), cancel = std::move(cancel),
                  done = std::move(done)](Thread& thread) {
        tl::expected<std::vector<MadeChunk>, std::string> made;
        try {
          if (!*cancel) made = thread.make(world, keys, *cancel);
        } catch (const std::exception& thrown) {
          thread.forget();
          made = tl::unexpected{why(thrown)};
        }
        done(std::move(made));
      });
    }

   private:
    std::shared_ptr<const local::World> world_;
    std::shared_ptr<Jobs> jobs_;
  };

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> waiting_;
  bool stopped_ = false;
};

LocalSource::LocalSource(const LocalSourceOptions& options) : jobs_{std::make_shared<Jobs>()} {
  const std::size_t processors = std::thread::hardware_concurrency();
  const std::size_t count = options.threads != 0 ? options.threads : std::max<std::size_t>(2, processors) - 1;
  for (std::size_t i = 0; i < count; ++i) {
    try {
      threads_.emplace_back([jobs = jobs_, ground_bytes = options.ground_bytes / count] {
        Thread thread{ground_bytes};
        jobs->run(thread);
      });
    } catch (...) {
      if (threads_.empty()) throw;
      break;
    }
  }
}

LocalSource::~LocalSource() {
  jobs_->stop();
}

void LocalSource::open(std::shared_ptr<const client::WorldFiles> files,
                       std::shared_ptr<const std::atomic<bool>> cancel, Opened done) {
  jobs_->add([files = std::move(files), cancel = std::move(cancel), jobs = jobs_,
              done = std::move(done)](Thread&) {
    std::set<std::string> missing;
    const auto cancelled = [&] { return *cancel || jobs->is_stopped(); };
    const auto reader = [&](const std::string& name) -> tl::expected<std::vector<std::byte>, std::string> {
      if (cancelled()) return tl::unexpected<std::string>{"cancelled"};
      const auto file = files->find(name);
      if (file != files->end() && file->second != nullptr) return *file->second;
      missing.insert(name);
      return tl::unexpected<std::string>{"it is not here"};
    };
    tl::expected<std::shared_ptr<client::LocalWorld>, OpenFailure> opened =
        tl::unexpected{OpenFailure{{}, "cancelled"}};
    try {
      const auto toml = files->find("");
      if (!cancelled()) {
        const bool is_here = toml != files->end() && toml->second != nullptr;
        const auto bytes = is_here ? std::span{*toml->second} : std::span<const std::byte>{};
        const auto world = local::open_world(bytes, reader);
        if (world) {
          opened = std::make_shared<Jobs::World>(*world, jobs);
        } else if (!cancelled()) {
          opened = tl::unexpected{OpenFailure{std::move(missing), world.error().message}};
        }
      }
    } catch (const std::exception& thrown) {
      opened = tl::unexpected{OpenFailure{{}, why(thrown)}};
    }
    done(std::move(opened));
  });
}

}  // namespace talus
