#include "edits/random_editor.h"

#include "runtime/random_number.h"

namespace talus::server {

edits::EditorId random_editor() {
  return {random_number(), random_number()};
}

}  // namespace talus::server
