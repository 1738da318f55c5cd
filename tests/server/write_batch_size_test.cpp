#include "net/write_batch_size.h"

#include <catch2/catch.hpp>

using talus::server::WriteBatchSize;

TEST_CASE("a batch grows while the transport takes it at once, and shrinks while it does not") {
  WriteBatchSize batch;
  CHECK(batch.bytes() == WriteBatchSize::kMin);
  batch.wrote(batch.bytes() - 1, true);  // there was no more to say
  CHECK(batch.bytes() == WriteBatchSize::kMin);
  for (int write = 0; write < 10; ++write) batch.wrote(batch.bytes() + 100, true);
  CHECK(batch.bytes() == WriteBatchSize::kMax);
  batch.wrote(100, false);
  CHECK(batch.bytes() == WriteBatchSize::kMax / 2);
  for (int write = 0; write < 10; ++write) batch.wrote(100, false);
  CHECK(batch.bytes() == WriteBatchSize::kMin);
}
