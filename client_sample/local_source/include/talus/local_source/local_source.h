// Makes published worlds' chunks inside a client (client::Options::maker), by the generator that the server
// has, on threads of its own.
//
//   client::Options options;
//   options.generate = client::Generate::automatic;
//   options.maker = std::make_shared<LocalSource>();
//   client::Client client{io.get_executor(), options, events};
//
// A program links talus::local_source for it, besides talus::client.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <thread>
#include <vector>

#include <talus/client/chunk_maker.h>

namespace talus {

struct LocalSourceOptions {
  std::size_t threads = 0;  // 0: one less than the machine's processors, but at least one
  /// For ground that neighbouring chunks share, of all threads together. Besides, each thread has the columns
  /// that it makes, some megabytes.
  std::size_t ground_bytes = std::size_t{64} << 20;
};

/// Several clients and worlds may share one. Its calls run in the order in which they came, as many at a time
/// as there are threads. Thread-safe. The destructor waits for the chunks being made.
class LocalSource final : public client::ChunkMaker {
 public:
  /// Goes on with fewer threads if the system starts no more. Throws std::system_error if it starts none.
  explicit LocalSource(const LocalSourceOptions& options = {});
  ~LocalSource() override;
  LocalSource(const LocalSource&) = delete;
  LocalSource& operator=(const LocalSource&) = delete;

  /// `cancel` is looked at before the world's file is read and before each file that it names.
  void open(std::shared_ptr<const client::WorldFiles> files, std::shared_ptr<const std::atomic<bool>> cancel,
            Opened done) override;

 private:
  class Jobs;
  std::shared_ptr<Jobs> jobs_;
  std::vector<std::jthread> threads_;
};

}  // namespace talus
