# One place for what every target is compiled with.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Debian's Python packages belong to this interpreter; another python3 first on PATH may not see them.
set(SWIRL_PYTHON /usr/bin/python3 CACHE FILEPATH "The Python of the tests, of the module, and of what draws figures")

# A compiler cache where there is one; -DSWIRL_CCACHE=OFF does without it. Paths below the checkout count from there, so
# that two checkouts share what they compile.
find_program(SWIRL_CCACHE ccache)
if(SWIRL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime,locale ${SWIRL_CCACHE})
endif()

# swirl_unite(TARGET COUNT): compiles its sources COUNT at a time, as one. Reading headers and instantiating templates are
# more than half of a file's compile time. A name in an unnamed namespace that two of them have is an error, and which these
# are changes with the list of sources: what two files need has one home. A source with options of its own stays alone.
function(swirl_unite target count)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SWIRL_UNITY} UNITY_BUILD_BATCH_SIZE ${count})
endfunction()

# swirl_unite_groups(TARGET NAME REGEX …): compiles those of its sources whose paths match REGEX as one, and so on for each
# pair; what matches none stays alone. For templates that are instantiated for many types, each group for its own.
function(swirl_unite_groups target)
  get_target_property(sources ${target} SOURCES)
  while(ARGN)
    list(POP_FRONT ARGN name pattern)
    set(group ${sources})
    list(FILTER group INCLUDE REGEX "${pattern}")
    list(REMOVE_ITEM sources ${group})
    set_source_files_properties(${group} PROPERTIES UNITY_GROUP ${name})
  endwhile()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SWIRL_UNITY} UNITY_BUILD_MODE GROUP)
endfunction()

# The libraries go into the command and into the Python module alike, so all code may lie anywhere. What a library calls of
# its own it calls directly, as in a program: nobody puts another function in its place.
add_compile_options(-fPIC -fno-semantic-interposition)

add_library(swirl_options INTERFACE)
set_target_properties(swirl_options PROPERTIES EXPORT_NAME options)
target_compile_features(swirl_options INTERFACE cxx_std_20)
# Equal bits whatever the compiler could fuse: a product and a sum are two roundings everywhere.
target_compile_options(swirl_options INTERFACE -ffp-contract=off)

add_library(swirl_warnings INTERFACE)
target_compile_options(swirl_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  -Wnon-virtual-dtor -Woverloaded-virtual
  # GCC 12 warns of std::string + in its own library (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${SWIRL_WARNINGS_AS_ERRORS}>:-Werror>)

if(SWIRL_FUZZ OR SWIRL_COVERAGE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "SWIRL_FUZZ and SWIRL_COVERAGE want clang; CMAKE_CXX_COMPILER is ${CMAKE_CXX_COMPILER}")
  endif()
  # clang links GCC's libquadmath but does not see its header.
  execute_process(COMMAND gcc -print-file-name=include OUTPUT_VARIABLE gcc_headers OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND CMAKE_CXX_FLAGS " -idirafter ${gcc_headers}")
endif()
if(SWIRL_FUZZ)
  # The libraries tell libFuzzer which of their branches an input takes; the fuzzers alone link it.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(SWIRL_COVERAGE)
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
endif()

if(SWIRL_SANITIZE)
  # -O1 comes after the build type's own flags and so decides; the standard library checks its preconditions too.
  add_compile_options(-fsanitize=${SWIRL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -O1 -g1)
  # Checks of every dereference double the time of the build; bad addresses are what AddressSanitizer is for.
  if(SWIRL_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=null,alignment,object-size)
  endif()
  add_compile_definitions(_GLIBCXX_ASSERTIONS SWIRL_SANITIZED)
  add_link_options(-fsanitize=${SWIRL_SANITIZE})
endif()

# swirl_not_sanitized(SOURCES…): no UndefinedBehaviorSanitizer in these. They take much of its build's time, as templates over
# large numbers do, and hold nothing that the other files would not show. AddressSanitizer stays: Eigen allocates otherwise
# beneath it, so that all files must have it or none.
function(swirl_not_sanitized)
  if(SWIRL_SANITIZE MATCHES "undefined")
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-sanitize=undefined)
  endif()
endfunction()
