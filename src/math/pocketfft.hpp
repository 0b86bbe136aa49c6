// SPDX-License-Identifier: MIT
// pocketfft without its own threads: the caller has already divided the work.
#pragma once

#define POCKETFFT_NO_MULTITHREADING
#include <pocketfft_hdronly.h>
