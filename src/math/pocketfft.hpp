// SPDX-License-Identifier: MIT
// pocketfft without threads, because the caller has already divided the work.
#pragma once

#define POCKETFFT_NO_MULTITHREADING
#include <pocketfft_hdronly.h>
