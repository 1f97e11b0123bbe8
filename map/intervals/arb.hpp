// Arb's headers: in FLINT 3 they lie in FLINT's folder, before that beside it. FLINT 3.6 includes none of them in
// another.
#pragma once

#if __has_include(<flint/arb.h>)
#include <flint/acb.h>      // IWYU pragma: export
#include <flint/acb_mat.h>  // IWYU pragma: export
#include <flint/arb.h>      // IWYU pragma: export
#include <flint/arb_mat.h>  // IWYU pragma: export
#include <flint/arf.h>      // IWYU pragma: export
#include <flint/mag.h>      // IWYU pragma: export
#else
#include <acb.h>      // IWYU pragma: export
#include <acb_mat.h>  // IWYU pragma: export
#include <arb.h>      // IWYU pragma: export
#include <arb_mat.h>  // IWYU pragma: export
#include <arf.h>      // IWYU pragma: export
#include <mag.h>      // IWYU pragma: export
#endif
