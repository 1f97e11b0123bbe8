# Install and export: find_package(Swirl) gives Swirl::map, Swirl::analysis and Swirl::studies, with the headers under
# include/swirl.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# swirl_install_library(TARGET folder): the target, and every header of the folder as a public one.
function(swirl_install_library target folder)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  # The command's: their libraries need Arb.
  list(FILTER headers EXCLUDE REGEX "/(map/(intervals|proof|proof_check)|apps/studies/certify)/")
  target_sources(${target} ${ARGN} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  install(TARGETS ${target} EXPORT SwirlTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swirl)
endfunction()

install(TARGETS swirl_options EXPORT SwirlTargets)
swirl_install_library(swirl_map map PUBLIC)
swirl_install_library(swirl_analysis analysis PUBLIC)
swirl_install_library(swirl_studies apps/studies PUBLIC)

set(swirl_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Swirl)
install(EXPORT SwirlTargets NAMESPACE Swirl:: DESTINATION ${swirl_package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SwirlConfig.cmake.in
  ${PROJECT_BINARY_DIR}/SwirlConfig.cmake INSTALL_DESTINATION ${swirl_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SwirlConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SwirlConfig.cmake ${PROJECT_BINARY_DIR}/SwirlConfigVersion.cmake
  DESTINATION ${swirl_package_dir})
