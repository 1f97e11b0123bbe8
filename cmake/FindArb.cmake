# Arb, interval arithmetic with balls: the target Arb::arb, and Arb_FOUND. In FLINT 3 it is part of FLINT; before that it is
# a library of its own over FLINT 2, which Debian calls flint-arb.
find_path(Arb_INCLUDE_DIR NAMES flint/arb.h arb.h)
find_library(Arb_FLINT_LIBRARY NAMES flint)
set(Arb_LIBRARIES ${Arb_FLINT_LIBRARY})
set(Arb_IS_IN_FLINT FALSE)
if(Arb_INCLUDE_DIR AND EXISTS ${Arb_INCLUDE_DIR}/flint/arb.h)
  set(Arb_IS_IN_FLINT TRUE)
else()
  find_library(Arb_LIBRARY NAMES flint-arb arb)
  list(PREPEND Arb_LIBRARIES ${Arb_LIBRARY})
endif()

include(FindPackageHandleStandardArgs)
if(Arb_IS_IN_FLINT)
  find_package_handle_standard_args(Arb REQUIRED_VARS Arb_FLINT_LIBRARY Arb_INCLUDE_DIR)
else()
  find_package_handle_standard_args(Arb REQUIRED_VARS Arb_LIBRARY Arb_FLINT_LIBRARY Arb_INCLUDE_DIR)
endif()
mark_as_advanced(Arb_INCLUDE_DIR Arb_LIBRARY Arb_FLINT_LIBRARY)

if(Arb_FOUND AND NOT TARGET Arb::arb)
  add_library(Arb::arb INTERFACE IMPORTED)
  # Their own headers include each other without the folder, and are not ours to warn about.
  set_target_properties(Arb::arb PROPERTIES INTERFACE_LINK_LIBRARIES "${Arb_LIBRARIES}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${Arb_INCLUDE_DIR})
endif()
