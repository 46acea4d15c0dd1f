# SPDX-License-Identifier: Apache-2.0
# Flags shared by every target, and one static library per folder of engine/.

add_library(sphinx_flags INTERFACE)
target_compile_options(sphinx_flags INTERFACE -Wall -Wextra -fopenmp-simd
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
find_package(Eigen3 REQUIRED)
target_link_libraries(sphinx_flags INTERFACE Eigen3::Eigen)
# Vectors of two and three are all we have of Eigen; its vector code for every processor is half of
# the time that its header takes.
target_compile_definitions(sphinx_flags INTERFACE EIGEN_DONT_VECTORIZE)

# With assertions, whatever the type of the build, and optimised as far as it costs no time.
add_library(sphinx_flags_checked INTERFACE)
target_link_libraries(sphinx_flags_checked INTERFACE sphinx_flags)
target_compile_options(sphinx_flags_checked INTERFACE -O1 -UNDEBUG
  # GCC 12 at -O1 wrongly sees copies out of the bounds of std::string.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
target_compile_definitions(sphinx_flags_checked INTERFACE _GLIBCXX_ASSERTIONS)

# For code that no step of a run waits for: takes a fifth less to compile.
set(SPHINX_COLD_OPTIONS $<$<CONFIG:Release>:-O1>)

# What the files of one folder include and instantiate is most of the work of compiling them, so that
# they are compiled as one where no loop is hot. OFF compiles each alone, which shows whether it includes
# all that it uses.
option(SPHINX_UNITE "Compile the files of a folder together where no loop is hot" ON)

# sphinx_unite(RESULT sources...): one generated file for each folder, which includes its sources.
function(sphinx_unite RESULT)
  set(UNITS)
  foreach(SOURCE ${ARGN})
    file(RELATIVE_PATH NAME ${CMAKE_SOURCE_DIR}/engine ${SOURCE})
    get_filename_component(ROOM ${NAME} DIRECTORY)
    string(REPLACE / _ UNIT ${ROOM})
    list(APPEND UNITS ${UNIT})
    # Relative to engine/, so that ccache finds it alike in every clone.
    string(APPEND TEXT_${UNIT} "#include \"${NAME}\"\n")
  endforeach()
  list(REMOVE_DUPLICATES UNITS)
  set(UNITED)
  foreach(UNIT ${UNITS})
    set(FILE ${CMAKE_CURRENT_BINARY_DIR}/united/${UNIT}.cpp)
    file(CONFIGURE OUTPUT ${FILE} CONTENT "${TEXT_${UNIT}}" @ONLY)
    # Of types in an unnamed namespace in a file that is included; here these are sources.
    set_source_files_properties(${FILE} PROPERTIES COMPILE_OPTIONS -Wno-subobject-linkage)
    list(APPEND UNITED ${FILE})
  endforeach()
  set(${RESULT} ${UNITED} PARENT_SCOPE)
endfunction()

# sphinx_library(core [COLD] [UNITE] LINK_PUBLIC ... LINK_PRIVATE ... ALONE ...): engine/core/**.cpp as
# sphinx_core; ALONE are folders and files of those to UNITE that are compiled by themselves. Where the
# tests include the engine a second time, SPHINX_SUFFIX ends the names of libraries and flags.
function(sphinx_library NAME)
  cmake_parse_arguments(ARG "COLD;UNITE" "" "LINK_PUBLIC;LINK_PRIVATE;ALONE" ${ARGN})
  file(GLOB_RECURSE SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/engine/${NAME}/*.cpp)
  if(ARG_UNITE AND SPHINX_UNITE)
    set(ALONE)
    foreach(PART ${ARG_ALONE})
      set(FOUND ${SOURCES})
      list(FILTER FOUND INCLUDE REGEX "/engine/${PART}(/|$)")
      list(APPEND ALONE ${FOUND})
    endforeach()
    list(REMOVE_ITEM SOURCES ${ALONE})
    sphinx_unite(SOURCES ${SOURCES})
    list(APPEND SOURCES ${ALONE})
  endif()
  set(LIBRARY sphinx_${NAME}${SPHINX_SUFFIX})
  list(TRANSFORM ARG_LINK_PUBLIC REPLACE "^sphinx_.*" "\\0${SPHINX_SUFFIX}")
  if(SOURCES)
    add_library(${LIBRARY} STATIC ${SOURCES})
    target_link_libraries(${LIBRARY} PUBLIC sphinx_flags${SPHINX_SUFFIX} ${ARG_LINK_PUBLIC}
                                     PRIVATE ${ARG_LINK_PRIVATE})
    if(ARG_COLD)
      target_compile_options(${LIBRARY} PRIVATE ${SPHINX_COLD_OPTIONS})
    endif()
  else()
    add_library(${LIBRARY} INTERFACE)
    target_link_libraries(${LIBRARY} INTERFACE sphinx_flags${SPHINX_SUFFIX} ${ARG_LINK_PUBLIC})
  endif()
endfunction()
