// SPDX-License-Identifier: MIT
#pragma once

namespace polhode {

/// The version of the library, such as "0.1.0".
const char* version();

}  // namespace polhode
