// SPDX-License-Identifier: MIT
// Names and defaults of the ensemble settings, as in run files.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// The names of the alternatives of a variant, in the order of their declaration.
template <class Variant>
inline constexpr auto type_names = nullptr;

template <class... Types>
inline constexpr std::array<std::string_view, sizeof...(Types)> type_names<std::variant<Types...>> =
    {Types::name...};

template <class... Types>
constexpr std::string_view type_name(const std::variant<Types...>& type) {
  return type_names<std::variant<Types...>>[type.index()];
}

/// Selects the alternative with a given name, with default parameters unless this alternative is
/// already selected.
template <class... Types>
void set_type(std::variant<Types...>& type, std::string_view name) {
  if (type_name(type) == name) return;
  std::size_t k = 0;
  ((type_names<std::variant<Types...>>[k++] == name ? void(type = Types{}) : void()), ...);
}

/// The compressibility of liquid water [nm³ mol/kJ].
double default_compressibility();

/// The default settings of a barostat, with the compressibility of liquid water.
BarostatSettings default_barostat();

}  // namespace polhode
