include(GNUInstallDirs)

# Flags shared by every target. The repository root is given with -iquote and
# never with -I: signal/ on an include path would shadow <signal.h>.
add_library(tapfit_flags INTERFACE)
# Complex products without the standard's detour for infinities: no result here
# may be infinite, and that detour costs half of every FRF. clang does not know
# the option, and clang-tidy reads the same command line.
set(plain_complex)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_CLANG_TIDY)
  set(plain_complex -fcx-limited-range)
endif()
# Dense products are half of a diagnosis, and Eigen chooses their instructions
# when it is compiled; see docs/decisions/vector-instructions.md.
include(CheckCXXSourceRuns)
check_cxx_source_runs("int main() {
  const bool can = __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\")
    && __builtin_cpu_supports(\"bmi2\");
  return can ? 0 : 1;
}" TAPFIT_MACHINE_HAS_AVX2)
option(TAPFIT_AVX2 "Build for processors with AVX2 and FMA"
  ${TAPFIT_MACHINE_HAS_AVX2})
set(vector_instructions)
if(TAPFIT_AVX2)
  set(vector_instructions -march=x86-64-v3)
endif()
target_compile_options(tapfit_flags INTERFACE
  "$<BUILD_INTERFACE:SHELL:-iquote ${PROJECT_SOURCE_DIR}>"
  "$<INSTALL_INTERFACE:SHELL:-iquote $<INSTALL_PREFIX>/${CMAKE_INSTALL_INCLUDEDIR}/tapfit>"
  ${plain_complex}
  ${vector_instructions})
# None of these is another project's business.
set(warnings -Wall -Wextra -Wpedantic -Wshadow=local -Wconversion)
if(TAPFIT_WARNINGS_AS_ERRORS)
  list(APPEND warnings -Werror)
endif()
# GCC 12 warns of copies inside std::string that cannot happen (bug 105329).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION
                                            VERSION_LESS 13)
  list(APPEND warnings
    -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
    -Wno-array-bounds -Wno-maybe-uninitialized)
endif()
# In a unity build a file's own names stand beside those of others, included
# where no other file sees them.
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND warnings -Wno-subobject-linkage)
endif()
target_compile_options(tapfit_flags INTERFACE "$<BUILD_INTERFACE:${warnings}>")
target_link_libraries(tapfit_flags INTERFACE Eigen3::Eigen fmt::fmt)
