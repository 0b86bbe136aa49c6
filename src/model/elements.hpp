// SPDX-License-Identifier: MIT
// Chemical elements, for files that leave them to be inferred.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// The symbol of an atomic number, 1 to 118; empty for all others.
std::string element_of_number(int number);

/// The symbol of the element whose standard mass [u] is nearest; empty if none up to radon lies
/// within 0.1 u.
std::string element_of_mass(double mass);

/// Whether a text is the symbol of an element, or D or T.
bool is_element(std::string_view symbol);

/// All symbols, for suggestions.
std::vector<std::string> element_symbols();

}  // namespace polhode
