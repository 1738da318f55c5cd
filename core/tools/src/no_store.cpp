#include "land_edits.h"

namespace talus::tools {

Expected<std::unique_ptr<const LandEdits>> open_store(const std::string&, const terrain::World&) {
  return wrong_use(
      "--store: this talus-gen was built without talusd, whose store it would read; build it with "
      "-DTALUS_SERVER=ON");
}

}  // namespace talus::tools
