/* Sizes, offsets and numbers of talus.h as a C compiler sees them, beside those that version 1.0 promised. */
#ifndef TALUS_TESTS_C_API_LAYOUT_H
#define TALUS_TESTS_C_API_LAYOUT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct layout_entry {
  const char* name;
  long found;
  long promised;
};

/* They end with an entry without a name. */
extern const struct layout_entry layout[];

#ifdef __cplusplus
}
#endif

#endif
