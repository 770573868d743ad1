# Half of a build from nothing is instances of Eigen's templates that every file
# makes anew. With CMAKE_UNITY_BUILD the files of a room are compiled several at
# a time, few enough that a change stays cheap.
function(group_sources)
  set(most_together 6)
  foreach(source ${ARGN})
    cmake_path(GET source PARENT_PATH room)
    cmake_path(RELATIVE_PATH room BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${room}" room)
    if(NOT DEFINED count_${room})
      set(count_${room} 0)
    endif()
    math(EXPR part "${count_${room}} / ${most_together}")
    math(EXPR count_${room} "${count_${room}} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${part})
    if(source MATCHES "(wing_study|paper_wing|virtual_portal)\\.cpp$")
      set_property(SOURCE ${source} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

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
  if(name STREQUAL "tui")  # few products of matrices, many short names
    set_target_properties(tapfit_${name} PROPERTIES UNITY_BUILD OFF)
  else()
    group_sources(${sources})
    set_target_properties(tapfit_${name} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
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
