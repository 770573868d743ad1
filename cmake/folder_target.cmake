# One library per folder: tapfit_folder(signal DEPENDS acquisition).
# Every .cpp below the folder belongs to it.
function(tapfit_folder name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(NOT sources)
    file(TOUCH ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
  endif()
  add_library(tapfit_${name} STATIC ${sources})
  list(TRANSFORM ARG_DEPENDS PREPEND tapfit_)
  target_link_libraries(tapfit_${name}
    PUBLIC tapfit_flags ${ARG_DEPENDS}
    PRIVATE ${ARG_PRIVATE})
  if(name STREQUAL "acquisition")
    target_precompile_headers(tapfit_${name} PRIVATE
      [["acquisition/eigen_instances/eigen_instances.hpp"]]
      <fmt/format.h> <string> <vector>)
  else()
    target_precompile_headers(tapfit_${name} REUSE_FROM tapfit_acquisition)
  endif()
endfunction()
