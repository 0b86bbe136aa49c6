// SPDX-License-Identifier: MIT
// Conversion factors from internal units to the units of messages, tables and reports.
#pragma once

namespace polhode::units {

inline constexpr double fs_per_ps = 1000, ps_per_ns = 1000;
inline constexpr double us_per_s = 1e6, seconds_per_day = 86400;

}  // namespace polhode::units
