// SPDX-License-Identifier: MIT
// Chemical elements, which must be inferred from names or masses in some file formats.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// The symbol of the element with an atomic number from 1 to 118; empty for all other numbers.
std::string element_of_number(int number);

/// The symbol of the element with the nearest standard mass [u]; empty if no element up to radon
/// has a mass within 0.1 u of this mass.
std::string element_of_mass(double mass);

/// Whether a text is the symbol of an element; D and T (hydrogen isotopes) are accepted as well.
bool is_element(std::string_view symbol);

/// The symbols of all elements, for suggestions.
std::vector<std::string> element_symbols();

}  // namespace polhode
