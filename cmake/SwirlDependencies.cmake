# What the libraries' own headers need. It is found here, at the top, so that every folder that links a library sees the
# targets behind it; SwirlConfig.cmake.in finds the same again for an installed Swirl.
# Lower bounds. Eigen's own file of versions takes a number for one of the same major version.
find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} in ${Eigen3_DIR} is too old: 3.4 or newer is wanted")
endif()
find_package(Ceres 2.1 REQUIRED)
find_package(GSL 2.7 REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)  # FFTW has no CMake package
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy-contrib libhwy)

# For proofs; Swirl without it says so when one is asked for. No header of an installed library needs it.
find_package(Arb)
