# Headers of libraries that most files include, compiled once: they are half of a file's compile time. A file that needs
# one includes it all the same (clang's check compiles without this). -DSWIRL_PRECOMPILED_HEADERS=OFF does without.
option(SWIRL_PRECOMPILED_HEADERS "Compile the libraries' headers once" ON)

# What ccache needs: GCC's preprocessed text names the header, clang's header holds no time and so has equal bytes each time.
function(swirl_cache_precompiled target)
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Winvalid-pch>" "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

# swirl_precompile(TARGET HEADERS…): TARGET compiles these headers first, for itself and for who shares them.
function(swirl_precompile target)
  if(SWIRL_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    swirl_cache_precompiled(${target})
  endif()
endfunction()

# swirl_share_precompiled(TARGET OTHER): TARGET uses what OTHER compiled. Both are to have the same options.
function(swirl_share_precompiled target other)
  if(SWIRL_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${other})
    swirl_cache_precompiled(${target})
  endif()
endfunction()

set(swirl_standard_headers <algorithm> <array> <cmath> <complex> <cstdint> <functional> <limits> <map> <memory> <optional>
  <span> <stdexcept> <string> <string_view> <utility> <variant> <vector>)
