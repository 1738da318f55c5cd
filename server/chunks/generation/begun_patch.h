// A patch that was begun and waits for a thread to continue it.
#pragma once

#include <chrono>
#include <memory>

#include <talus/terrain/stacks.h>

#include "chunks/generation/generator.h"

namespace talus::server {

struct BegunPatch {
  std::unique_ptr<PatchBuild> build;
  std::unique_ptr<terrain::Stacks> stacks;  // filled when it is made
  std::chrono::nanoseconds spent{};         // thread time so far
};
/// Null if nothing was begun.
using BegunPatchPtr = std::unique_ptr<BegunPatch>;

}  // namespace talus::server
