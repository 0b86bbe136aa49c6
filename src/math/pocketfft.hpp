// SPDX-License-Identifier: MIT
// pocketfft without threads of its own: whoever calls it has divided the work already.
#pragma once

#define POCKETFFT_NO_MULTITHREADING
#include <pocketfft_hdronly.h>
