// FORMAT.md read by a machine: a slow decoder of layered payloads that takes the format's tables from the
// document's own text and follows its words, so that the document stays true.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <talus/voxel/chunk.h>

namespace talus::testing {

/// The text of FORMAT.md.
[[nodiscard]] std::string format_document();

/// What stands in the document's only ```NAME block.
[[nodiscard]] std::string block_of(const std::string& document, const std::string& name);

/// Layers of a valid layered payload. Most others throw std::runtime_error; none is read past its end.
[[nodiscard]] Layers decode_by_document(const std::string& document, std::span<const std::byte> payload);

/// The voxels of a volume, of runs or of a raw payload, in dense order.
[[nodiscard]] std::vector<int> voxels_by_document(const std::string& document,
                                                  std::span<const std::byte> payload);

}  // namespace talus::testing
