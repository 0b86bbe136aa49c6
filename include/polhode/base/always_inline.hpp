// SPDX-License-Identifier: MIT
// Functions and lambdas of inner loops that the compiler must inline, as the shape of molecules is
// known there.
#pragma once

#define POLHODE_INLINE [[gnu::always_inline]]                 // before a function
#define POLHODE_INLINE_LAMBDA __attribute__((always_inline))  // after the parameters of a lambda
