# SPDX-License-Identifier: Apache-2.0
# Writes sphinx_build.h (version, commit, compiler, flags) when something in it changed; run at every
# build, so that the commit in results is the one that was compiled.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE COMMIT
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(COMMIT STREQUAL "")
  set(COMMIT unknown)
else()
  execute_process(COMMAND git -C ${SOURCE} diff --quiet HEAD -- engine app RESULT_VARIABLE CHANGED
                  ERROR_QUIET)
  if(CHANGED)
    string(APPEND COMMIT "+changes")
  endif()
endif()
file(WRITE ${OUTPUT}.new "#pragma once
#define SPHINX_VERSION \"${VERSION}\"
#define SPHINX_COMMIT \"${COMMIT}\"
#define SPHINX_COMPILER \"${COMPILER}\"
#define SPHINX_FLAGS \"${FLAGS}\"
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUTPUT}.new ${OUTPUT})
