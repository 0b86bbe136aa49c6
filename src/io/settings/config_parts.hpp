// SPDX-License-Identifier: MIT
// Functions that both the run-file parser and other readers of settings use.
#pragma once

#include <string>
#include <string_view>

#include "polhode/io/settings/config.hpp"

namespace polhode {

/// Replaces names of user-defined schemes in a text by the texts of these schemes. A name is the
/// whole text, or stands on either side of a slash (nested schemes).
std::string with_own_schemes(const std::string& text, const OwnSchemes& own);

/// The reason why the temperature of a run is invalid; empty if it is valid. A temperature of 0 K
/// is valid only with a thermostat.
std::string wrong_temperature(const Config& config);

/// Sets the precision of a run, overriding the run file. If the run file sets no lambda, a suitable
/// lambda is also set.
/// @throws Error  if the run file's lambda is too small for mixed precision
void set_precision(Config& config, Precision precision);

/// The text of a run file with the settings of an overlay inserted.
/// @throws Error  if the text is not valid TOML, or settings of the overlay contradict the run file
///   or each other
std::string overlaid_text(std::string_view text, const std::string& file, const Overlay& overlay);

}  // namespace polhode
