// SPDX-License-Identifier: MIT
#include "polhode/base/version.hpp"

namespace polhode {

const char* version() { return POLHODE_VERSION; }

}  // namespace polhode
