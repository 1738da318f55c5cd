#include <talus/terrain/fbm.h>

#include <algorithm>

#include <talus/vectors/instruction_set.h>

#include "noise/fbm_rows.h"

namespace talus::terrain {

void sample_fbm(const Fbm& fbm, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
                std::span<float> out) {
  FbmRows rows{instruction_set()};
  rows.start(fbm, xs);
  for (std::size_t j = 0; j < zs.size(); ++j) {
    std::copy_n(rows.row(zs[j]), xs.size(), out.data() + j * xs.size());
  }
}

}  // namespace talus::terrain
