// SPDX-License-Identifier: MIT
#include "model/elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace polhode {
namespace {

// clang-format off
constexpr std::array<const char*, 118> symbols = {
    "H", "He", "Li", "Be", "B", "C", "N", "O", "F", "Ne", "Na", "Mg", "Al", "Si", "P", "S",
    "Cl", "Ar", "K", "Ca", "Sc", "Ti", "V", "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga",
    "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y", "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd",
    "Ag", "Cd", "In", "Sn", "Sb", "Te", "I", "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm",
    "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W", "Re", "Os",
    "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th", "Pa",
    "U", "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf", "Db", "Sg",
    "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"};

// Standard atomic weights [u], abridged to five digits [prohaska2022].
constexpr std::array<double, 86> masses = {
    1.008, 4.0026, 6.94, 9.0122, 10.81, 12.011, 14.007, 15.999, 18.998, 20.18, 22.99, 24.305,
    26.982, 28.085, 30.974, 32.06, 35.45, 39.95, 39.098, 40.078, 44.956, 47.867, 50.942,
    51.996, 54.938, 55.845, 58.933, 58.693, 63.546, 65.38, 69.723, 72.63, 74.922, 78.971,
    79.904, 83.798, 85.468, 87.62, 88.906, 91.224, 92.906, 95.95, 97, 101.07, 102.91, 106.42,
    107.87, 112.41, 114.82, 118.71, 121.76, 127.6, 126.9, 131.29, 132.91, 137.33, 138.91,
    140.12, 140.91, 144.24, 145, 150.36, 151.96, 157.25, 158.93, 162.5, 164.93, 167.26,
    168.93, 173.05, 174.97, 178.49, 180.95, 183.84, 186.21, 190.23, 192.22, 195.08, 196.97,
    200.59, 204.38, 207.2, 208.98, 209, 210, 222};
// clang-format on

}  // namespace

std::string element_of_number(int number) {
  if (number < 1 || number > static_cast<int>(symbols.size())) return {};
  return symbols[static_cast<std::size_t>(number) - 1];
}

std::string element_of_mass(double mass) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < masses.size(); ++k)
    if (std::abs(masses[k] - mass) < std::abs(masses[nearest] - mass)) nearest = k;
  return std::abs(masses[nearest] - mass) <= 0.1 ? symbols[nearest] : "";
}

bool is_element(std::string_view symbol) {
  return symbol == "D" || symbol == "T" ||
         std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

std::vector<std::string> element_symbols() { return {symbols.begin(), symbols.end()}; }

}  // namespace polhode
