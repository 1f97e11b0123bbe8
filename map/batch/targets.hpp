// Before Highway's headers in every file of kernels: vectors must be members of a struct here; those whose length is
// known at run time only can't be. SSSE3 has nothing for doubles that SSE2 and SSE4 have not, and
// AVX3_DL nothing that AVX3 has not: each would be the same kernels compiled once more.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
