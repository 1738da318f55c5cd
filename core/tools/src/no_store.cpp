#include "land_edits.h"

namespace talus::tools {

Expected<std::unique_ptr<const LandEdits>> open_store(const std::string& directory,
                                                      const terrain::World& /*world*/) {
  return failed("--store " + directory +
                ": stores are not read on Windows; run this on the server's machine");
}

}  // namespace talus::tools
