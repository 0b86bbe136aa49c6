// SPDX-License-Identifier: MIT
// Macros for functions and lambdas that the compiler must inline into inner loops, where the shape
// of the molecules is known.
#pragma once

#define POLHODE_INLINE [[gnu::always_inline]]                 // before a function
#define POLHODE_INLINE_LAMBDA __attribute__((always_inline))  // after the parameters of a lambda
