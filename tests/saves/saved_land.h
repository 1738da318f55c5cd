// A small world with placeables, and saves of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <talus/saves/save.h>

/// classic.toml with "planks" and "glass".
[[nodiscard]] std::string land_toml();
[[nodiscard]] talus::saves::WorldSource land();
/// A new save of it; fails the test otherwise.
[[nodiscard]] talus::saves::Save new_save(const std::filesystem::path& file);

inline constexpr talus::MaterialId kPlanks{256};

[[nodiscard]] talus::edits::Edit written(talus::VoxelPos voxel, talus::MaterialId material = kPlanks);
[[nodiscard]] talus::edits::Edit filled(talus::VoxelPos first, talus::VoxelPos last,
                                        talus::MaterialId material = kPlanks);
