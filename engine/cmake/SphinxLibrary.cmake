# SPDX-License-Identifier: Apache-2.0
# Flags shared by every target, and one static library per folder of engine/.

add_library(sphinx_flags INTERFACE)
target_compile_options(sphinx_flags INTERFACE -Wall -Wextra -Werror -fopenmp-simd
  # Bits must not depend on where the compiler finds a chance to fuse or reorder: only loops that
  # ask for it (omp simd reduction) are reordered. errno and traps are not used.
  -fno-math-errno -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 wrongly sees overlapping copies in std::string (GCC bug 105651); -Wpsabi is about vector
  # arguments across libraries, and ours never leave a translation unit.
  target_compile_options(sphinx_flags INTERFACE -Wno-restrict -Wno-psabi)
endif()
if(SPHINX_NATIVE)
  target_compile_options(sphinx_flags INTERFACE -march=native)
endif()
if(SPHINX_SANITIZE)
  target_compile_options(sphinx_flags INTERFACE -fsanitize=address,undefined
    -fno-sanitize-recover=all -fno-omit-frame-pointer
    # False with GCC 12 in libstdc++ and CGAL once the sanitizers are in.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(sphinx_flags INTERFACE -fsanitize=address,undefined)
endif()
target_include_directories(sphinx_flags INTERFACE ${CMAKE_SOURCE_DIR}/engine)
target_include_directories(sphinx_flags SYSTEM INTERFACE /usr/include/eigen3)
# Vectors of two and three are all we have of Eigen; its vector code for every processor is half of
# the time that its header takes.
target_compile_definitions(sphinx_flags INTERFACE EIGEN_DONT_VECTORIZE)

# For code that no step of a run waits for: takes a fifth less to compile.
set(SPHINX_COLD_OPTIONS $<$<CONFIG:Release>:-O1>)

# sphinx_library(core [COLD] LINK_PUBLIC ... LINK_PRIVATE ...): engine/core/**.cpp as sphinx_core.
function(sphinx_library NAME)
  cmake_parse_arguments(ARG "COLD" "" "LINK_PUBLIC;LINK_PRIVATE" ${ARGN})
  file(GLOB_RECURSE SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/engine/${NAME}/*.cpp)
  if(SOURCES)
    add_library(sphinx_${NAME} STATIC ${SOURCES})
    target_link_libraries(sphinx_${NAME} PUBLIC sphinx_flags ${ARG_LINK_PUBLIC}
                                         PRIVATE ${ARG_LINK_PRIVATE})
    if(ARG_COLD)
      target_compile_options(sphinx_${NAME} PRIVATE ${SPHINX_COLD_OPTIONS})
    endif()
  else()
    add_library(sphinx_${NAME} INTERFACE)
    target_link_libraries(sphinx_${NAME} INTERFACE sphinx_flags ${ARG_LINK_PUBLIC})
  endif()
endfunction()
