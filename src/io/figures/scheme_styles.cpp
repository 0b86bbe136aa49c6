// SPDX-License-Identifier: MIT
// Colours and markers of schemes, the same in all figures.
#include <toml++/toml.h>

#include "figure_script.hpp"
#include "io/files/embedded.hpp"

namespace polhode {
namespace {

SchemeStyle style(const toml::table& table, const toml::table& entry) {
  const toml::array& types = *table["markers"][entry["marker"].value_or("circle")].as_array();
  return {entry["colour"].value_or(std::string("#000000")), types[0].value_or(7),
          types[1].value_or(6)};
}

}  // namespace

std::vector<SchemeStyle> scheme_styles(const std::vector<std::string>& schemes) {
  const toml::table table = toml::parse(*embedded_text("plots/schemes.toml"));
  const toml::array& others = *table["other"].as_array();
  std::vector<SchemeStyle> styles;
  std::size_t unnamed = 0;
  for (const std::string& scheme : schemes) {
    const toml::table* entry = table["schemes"][scheme].as_table();
    if (entry == nullptr) entry = others[unnamed++ % others.size()].as_table();
    styles.push_back(style(table, *entry));
  }
  return styles;
}

}  // namespace polhode
