# Half of a build from nothing is templates of Eigen, CLI11 and the like that
# every file makes anew. With CMAKE_UNITY_BUILD the files of a room are compiled in two
# parts. Which part a file belongs to depends on its name alone, so that a new
# file never changes what others are compiled with.
function(group_sources)
  foreach(source ${ARGN})
    cmake_path(GET source PARENT_PATH room)
    cmake_path(GET source STEM name)
    cmake_path(RELATIVE_PATH room BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${room}" room)
    string(MD5 part ${name})
    string(REGEX REPLACE "^[0-7].*" "a" part ${part})
    string(REGEX REPLACE "^[89abcdef]...*" "b" part ${part})
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${part})
    # They name what their neighbours name otherwise, or are compiled otherwise.
    set(alone terminal terminal_traits saved_session saved_effect saved_fields decompositions products wing_study paper_wing virtual_portal undersampled_pulses_test
      replay_test turned_axes_test plate_modes_test reduced_normal_test
      run_consistency_test effect_stack_test
      mesh_shift_test ringing_modes_test)
    if(name IN_LIST alone)
      set_property(SOURCE ${source} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

function(compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# One library per folder: tapfit_folder(signal DEPENDS acquisition).
# Every .cpp below the folder belongs to it but those of the program alone.
function(tapfit_folder name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/(main|processor_check)\\.cpp$")
  if(NOT sources)
    file(TOUCH ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
  endif()
  add_library(tapfit_${name} STATIC ${sources})
  group_sources(${sources})
  compile_together(tapfit_${name})
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
