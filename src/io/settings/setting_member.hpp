// SPDX-License-Identifier: MIT
// Reads and writes the member of a Config that belongs to a settings row.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/settings/settings.hpp"
#include "polhode/base/enum_names.hpp"
#include "polhode/io/settings/config.hpp"

namespace polhode {

/// The value of a setting in internal units; empty if it is not set.
using SettingValue =
    std::variant<std::monostate, double, std::int64_t, bool, std::string, std::vector<std::string>>;

struct SettingMember {
  std::function<bool(const Config&)> exists;  ///< whether the setting applies to the run
  std::function<SettingValue(const Config&)> value;
  std::function<void(Config&, const SettingValue&)> set;
  SettingKind kind = SettingKind::text;
  std::span<const std::string_view> names{};  ///< names of an enumeration
};

namespace setting_detail {

template <class T>
struct Unwrapped {
  using type = T;
};
template <class T>
struct Unwrapped<std::optional<T>> {
  using type = T;
};

template <class T>
SettingValue setting_value(const T& member) {
  if constexpr (!std::is_same_v<typename Unwrapped<T>::type, T>)
    return member ? setting_value(*member) : SettingValue{};
  else if constexpr (NamedEnum<T>)
    return std::string(name_of(member));
  else if constexpr (std::is_same_v<T, NamedScheme>)
    return member.text;
  else if constexpr (std::is_same_v<T, std::vector<NamedScheme>>) {
    std::vector<std::string> texts;
    for (const NamedScheme& scheme : member) texts.push_back(scheme.text);
    return texts;
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    return static_cast<std::int64_t>(member);
  else
    return member;
}

/// Converts a number to the type of a member. An integer beyond the range of the member's type is
/// replaced by the nearest end of the range.
template <class T>
T member_value(const SettingValue& value) {
  if constexpr (NamedEnum<T>) {
    return *value_of<T>(std::get<std::string>(value));
  } else if constexpr (std::is_same_v<T, NamedScheme>) {
    return std::get<std::string>(value);
  } else if constexpr (std::is_same_v<T, std::vector<NamedScheme>>) {
    const auto& texts = std::get<std::vector<std::string>>(value);
    return T(texts.begin(), texts.end());
  } else if constexpr (std::is_same_v<T, int>) {
    using Limits = std::numeric_limits<int>;
    return static_cast<int>(
        std::clamp<std::int64_t>(std::get<std::int64_t>(value), Limits::min(), Limits::max()));
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    return static_cast<T>(std::get<std::int64_t>(value));
  } else {
    return std::get<T>(value);
  }
}

template <class T>
constexpr SettingKind kind_of() {
  if constexpr (std::is_same_v<T, bool>)
    return SettingKind::boolean;
  else if constexpr (std::is_same_v<T, double>)
    return SettingKind::number;
  else if constexpr (std::is_integral_v<T>)
    return SettingKind::integer;
  else
    return std::is_same_v<T, std::string> || std::is_same_v<T, NamedScheme> || NamedEnum<T>
               ? SettingKind::text
               : SettingKind::texts;
}

}  // namespace setting_detail

/// @param access  function from a Config to a pointer to the member, which is null if the Config
///   does not have the member
template <class Access>
SettingMember member(Access access) {
  using Member = std::remove_pointer_t<std::invoke_result_t<Access, Config&>>;
  using T = typename setting_detail::Unwrapped<Member>::type;
  const auto of = [access](const Config& config) -> const Member* {
    return access(const_cast<Config&>(config));
  };
  SettingMember made{
      [of](const Config& config) { return of(config) != nullptr; },
      [of](const Config& config) { return setting_detail::setting_value(*of(config)); },
      [access](Config& config, const SettingValue& value) {
        *access(config) = setting_detail::member_value<T>(value);
      },
      setting_detail::kind_of<T>()};
  if constexpr (NamedEnum<T>) made.names = enum_names<T>;
  return made;
}

/// Returns a function that gives access to members of a part of a Config, as in
/// in(&Config::run)(&RunSettings::length).
template <class Part>
auto in(Part Config::*part) {
  return [part](auto Part::*one) {
    return member([part, one](Config& config) { return &(config.*part.*one); });
  };
}

}  // namespace polhode
