// SPDX-License-Identifier: MIT
#include "base/version.hpp"

namespace polhode {

const char* version() { return POLHODE_VERSION; }

}  // namespace polhode
