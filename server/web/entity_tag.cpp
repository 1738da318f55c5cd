#include "web/entity_tag.h"

#include <cstddef>

#include <xxhash.h>

namespace talus::server::web {

