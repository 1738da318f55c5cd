// Runs a fuzz target without a fuzzer: over every file of its corpus, and over small mutations of each,
// the same ones every time.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t kSeed = 20190617;
constexpr int kMutationsOfEachKind = 60;

class Replay {
 public:
  explicit Replay(std::vector<Bytes> corpus) : corpus_{std::move(corpus)} {}

  std::size_t run() {
    run_one({});
    for (const Bytes& file : corpus_) {
      run_one(file);
      for (int i = 0; i < kMutationsOfEachKind && !file.empty(); ++i) {
        run_one(flipped(file));
        run_one(truncated(file));
        run_one(spliced(file));
      }
    }
    return runs_;
  }

 private:
  // Not std::uniform_int_distribution: its numbers differ from one standard library to another.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

  Bytes flipped(Bytes bytes) {
    for (std::size_t flips = 1 + below(3); flips > 0; --flips) {
      bytes[below(bytes.size())] ^= static_cast<std::uint8_t>(1U << below(8));
    }
    return bytes;
  }

  Bytes truncated(Bytes bytes) {
    bytes.resize(below(bytes.size()));
    return bytes;
  }

  Bytes spliced(const Bytes& bytes) {
    const Bytes& other = corpus_[below(corpus_.size())];
    const auto cut = [this](const Bytes& whole) {
      return static_cast<std::ptrdiff_t>(below(whole.size() + 1));
    };
    Bytes joined(bytes.begin(), bytes.begin() + cut(bytes));
    joined.insert(joined.end(), other.begin() + cut(other), other.end());
    return joined;
  }

  void run_one(const Bytes& bytes) {
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    ++runs_;
  }

  std::vector<Bytes> corpus_;
  std::mt19937_64 random_{kSeed};
  std::size_t runs_ = 0;
};

Bytes read_file(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
    std::cerr << "usage: " << argv[0] << " CORPUS, a folder of inputs\n";
    return 2;
  }
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator{argv[1]}) {
    if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  if (paths.empty()) {
    std::cerr << argv[1] << " holds no inputs; it must hold at least one\n";
    return 1;
  }
  std::vector<Bytes> corpus;
  for (const auto& path : paths) corpus.push_back(read_file(path));
  std::cout << paths.size() << " inputs, seed " << kSeed << std::endl;
  std::cout << Replay{std::move(corpus)}.run() << " runs\n";
  return 0;
}
