// SPDX-License-Identifier: MIT
// Names of enumeration values for run files, options and messages, with one table per enumeration.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace polhode {

/// The names of all values of an enumeration, in the order of the values. This array is specialized
/// for each enumeration that has names.
template <class Enum>
inline constexpr auto enum_names = nullptr;

template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires {
  enum_names<Enum>.size();
};

template <NamedEnum Enum>
constexpr std::string_view name_of(Enum value) {
  return enum_names<Enum>[static_cast<std::size_t>(value)];
}

/// The enumeration value with a given name; empty if there is none.
template <NamedEnum Enum>
constexpr std::optional<Enum> value_of(std::string_view name) {
  for (std::size_t k = 0; k < enum_names<Enum>.size(); ++k)
    if (enum_names<Enum>[k] == name) return static_cast<Enum>(k);
  return std::nullopt;
}

}  // namespace polhode
