# What `cmake --install` puts where, and the Debian packages that CPack makes:
# `tapfit`, the program with its pages and the demonstration, and
# `libtapfit-dev`, the numerical libraries for find_package(tapfit).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(data ${CMAKE_INSTALL_DATADIR})
install(TARGETS tapfit RUNTIME COMPONENT tapfit)
install(FILES packaging/tapfit.1
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tapfit)
install(FILES packaging/tapfit.bash
  DESTINATION ${data}/bash-completion/completions RENAME tapfit
  COMPONENT tapfit)
install(FILES packaging/tapfit.desktop
  DESTINATION ${data}/applications COMPONENT tapfit)
install(DIRECTORY recordings/
  DESTINATION ${data}/tapfit/recordings COMPONENT tapfit
  PATTERN README.md EXCLUDE  # with the other pages
  PATTERN session.json EXCLUDE)
# Pages stand to each other as they do here: they link to each other.
set(pages ${CMAKE_INSTALL_DOCDIR})
install(
  FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE packaging/copyright
  DESTINATION ${pages} COMPONENT tapfit)
install(FILES cmake/packages.txt
  DESTINATION ${pages}/cmake COMPONENT tapfit)
install(DIRECTORY docs
  DESTINATION ${pages} COMPONENT tapfit)
install(DIRECTORY recordings
  DESTINATION ${pages} COMPONENT tapfit
  FILES_MATCHING PATTERN README.md)
install(DIRECTORY examples
  DESTINATION ${pages} COMPONENT tapfit)

# The numerical libraries: every header at the path it is included by, below a
# root of their own, since signal/ must not stand beside <signal.h>.
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/tapfit)
foreach(folder acquisition signal modal updating)
  install(DIRECTORY ${folder}
    DESTINATION ${headers} COMPONENT libtapfit-dev
    FILES_MATCHING PATTERN *.hpp)
  set_target_properties(tapfit_${folder} PROPERTIES EXPORT_NAME ${folder})
endforeach()
set_target_properties(tapfit_flags PROPERTIES EXPORT_NAME flags)
set_target_properties(tapfit_cholmod PROPERTIES EXPORT_NAME cholmod)
install(
  TARGETS tapfit_flags tapfit_cholmod
          tapfit_acquisition tapfit_signal tapfit_modal tapfit_updating
  EXPORT tapfitTargets
  ARCHIVE COMPONENT libtapfit-dev)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/tapfit)
install(EXPORT tapfitTargets
  NAMESPACE tapfit:: DESTINATION ${package} COMPONENT libtapfit-dev)
configure_package_config_file(cmake/tapfitConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tapfitConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tapfitConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(
  FILES ${PROJECT_BINARY_DIR}/tapfitConfig.cmake
        ${PROJECT_BINARY_DIR}/tapfitConfigVersion.cmake
  DESTINATION ${package} COMPONENT libtapfit-dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tapfit)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the authors of tapfit <tapfit@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL tapfit libtapfit-dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TAPFIT_PACKAGE_NAME tapfit)
set(CPACK_DEBIAN_TAPFIT_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TAPFIT_PACKAGE_RECOMMENDS "libopenblas0-pthread")
set(CPACK_DEBIAN_TAPFIT_DESCRIPTION
  "from hammer taps to a finite element model you can believe
Reads impact tests of structures, identifies modes, compares them with a
Nastran deck, and says which physical effect is missing from the model.")
set(CPACK_DEBIAN_LIBTAPFIT-DEV_PACKAGE_NAME libtapfit-dev)
set(CPACK_DEBIAN_LIBTAPFIT-DEV_PACKAGE_DEPENDS
  "pkg-config, libeigen3-dev, libfmt-dev, libfftw3-dev, libsndfile1-dev, libmatio-dev, libhdf5-dev, zlib1g-dev, libssl-dev, nlohmann-json3-dev, libsuitesparse-dev")
set(CPACK_DEBIAN_LIBTAPFIT-DEV_DESCRIPTION
  "numerical libraries of tapfit
FRFs of impact tests, modal identification, finite element model updating.")
include(CPack)
