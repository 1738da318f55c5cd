# Writes the source of talus/build_version.h, if it would differ:
#   cmake -DSOURCE=FOLDER -DVERSION=0.2.0 -DOUTPUT=FILE -P write.cmake
# The commit is that of the repository whose root is SOURCE, or, in an archive that git made, that of commit.txt.
file(STRINGS ${SOURCE}/.cmake/build_version/commit.txt commit LIMIT_COUNT 1)
if(NOT commit MATCHES "^[0-9a-f]+$")
  set(commit "")
  if(EXISTS ${SOURCE}/.git)
    # Named, not searched for: git then reads a clone of another owner, too.
    execute_process(COMMAND git --git-dir=${SOURCE}/.git rev-parse --verify HEAD
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
      set(commit "")
    endif()
  endif()
endif()
set(text ${VERSION})
if(commit)
  string(SUBSTRING ${commit} 0 8 commit)
  string(APPEND text " (${commit})")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include <talus/build_version.h>

const char* const talus::kBuildVersion = "@text@";
]] @ONLY)
