# Every dependency is a Debian 12 package; packages.txt lists them.
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(MATIO REQUIRED IMPORTED_TARGET matio)
# Debian keeps several builds of it side by side.
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial hdf5)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
find_package(ZLIB REQUIRED)
pkg_check_modules(NCURSES REQUIRED IMPORTED_TARGET ncursesw)
# It asks for _DEFAULT_SOURCE, which compilers of C++ imply; defined on the
# command line it would keep the precompiled header from being shared.
set_property(TARGET PkgConfig::NCURSES PROPERTY INTERFACE_COMPILE_OPTIONS "")

# Headers only, no package files of their own.
find_path(VALIJSON_INCLUDE valijson/validator.hpp REQUIRED)
find_path(SPECTRA_INCLUDE Spectra/SymGEigsShiftSolver.h REQUIRED)

find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(tapfit_cholmod INTERFACE)
target_include_directories(tapfit_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE})
target_link_libraries(tapfit_cholmod INTERFACE ${CHOLMOD_LIBRARY})
