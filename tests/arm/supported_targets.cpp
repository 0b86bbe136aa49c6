// SPDX-License-Identifier: MIT
// What Highway's library, which is not there for this processor, reports about it.
#include <hwy/targets.h>

namespace hwy {

int64_t SupportedTargets() { return HWY_STATIC_TARGET; }

}  // namespace hwy
