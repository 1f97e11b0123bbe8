# Debian packages by `cmake --build build/release --target packages`: swirl (the command, its manual, completion,
# documents), swirl-figures (the Python that draws) and libswirl-dev (headers and libraries), in packages/ of the build.
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME swirl)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "Swirl maintainers")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL swirl swirl-figures development)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_BINARY_DIR}/package-documents/package_documents.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Swirl maintainers <swirl@packages.invalid>")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What the program and the libraries need is read from the program itself: versions are those of the machine that builds.
set(CPACK_DEBIAN_SWIRL_PACKAGE_NAME swirl)
set(CPACK_DEBIAN_SWIRL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_SWIRL_PACKAGE_SECTION science)
set(CPACK_DEBIAN_SWIRL_PACKAGE_RECOMMENDS "swirl-figures")
set(CPACK_DEBIAN_SWIRL_PACKAGE_SUGGESTS "bash-completion, zsh")
set(CPACK_COMPONENT_SWIRL_DESCRIPTION "modes of a body in a swirled circular container
A rigid polygon or disk in a swirled circular container, followed exactly from
one collision to the next with restitution and Coulomb friction, and its mode
named: steady, quasi-steady or chaotic. With cycles, their branches and
bifurcations, recurrence quantification, spectra and Lyapunov exponents.")

set(CPACK_DEBIAN_SWIRL-FIGURES_PACKAGE_NAME swirl-figures)
set(CPACK_DEBIAN_SWIRL-FIGURES_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_SWIRL-FIGURES_PACKAGE_SECTION science)
set(CPACK_DEBIAN_SWIRL-FIGURES_PACKAGE_DEPENDS
  "python3 (>= 3.9), python3-matplotlib, python3-numpy, python3-h5py, python3-xarray, python3-h5netcdf")
set(CPACK_DEBIAN_SWIRL-FIGURES_PACKAGE_RECOMMENDS "python3-nbformat, python3-nbclient, python3-ipykernel")
set(CPACK_DEBIAN_SWIRL-FIGURES_PACKAGE_SUGGESTS "ffmpeg, jupyter")
set(CPACK_COMPONENT_SWIRL-FIGURES_DESCRIPTION "figures, films and notebooks of swirl's records
What swirl plot, animate and notebook run, and five worked notebooks.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libswirl-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev (>= 3.4), libceres-dev (>= 2.1), libgsl-dev, libfftw3-dev, libtbb-dev, libhwy-dev, librandom123-dev, libboost-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "libraries and headers of swirl
The collision map of a body in a swirled circular container with its exact
derivative, and the analysis of any map or series; find_package(Swirl).")

# Documents that every Debian package has; `cmake --install`, which makes no package, leaves them out.
string(TIMESTAMP swirl_date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH's, where that is set
file(READ ${PROJECT_SOURCE_DIR}/LICENSE swirl_licence)
string(REGEX MATCH "Copyright[^\n]*" swirl_copyright "${swirl_licence}")
string(REGEX REPLACE "^Copyright *(\\([cC]\\))? *" "" swirl_copyright "${swirl_copyright}")
string(REGEX REPLACE "^.*\n(Permission is hereby.*)$" "\\1" swirl_licence "${swirl_licence}")
string(STRIP "${swirl_licence}" swirl_licence)
string(REPLACE "\n\n" "\n.\n" swirl_licence "${swirl_licence}")
string(REPLACE "\n" "\n " swirl_licence "${swirl_licence}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in ${PROJECT_BINARY_DIR}/package-documents/copyright @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/package_documents.cmake.in
  ${PROJECT_BINARY_DIR}/package-documents/package_documents.cmake @ONLY)

include(CPack)
add_custom_target(packages COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR} USES_TERMINAL VERBATIM COMMENT "Debian packages")
add_dependencies(packages swirl swirl_pages swirl_map swirl_analysis)
