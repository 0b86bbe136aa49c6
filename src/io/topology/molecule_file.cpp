// SPDX-License-Identifier: MIT
#include "polhode/io/topology/molecule_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

#include "base/printable.hpp"
#include "base/suggest.hpp"
#include "forces/laws/setting_names.hpp"
#include "io/files/embedded.hpp"
#include "io/files/text_file.hpp"
#include "io/settings/list_tables.hpp"
#include "io/settings/short_range_keys.hpp"
#include "model/elements.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::string_view folder = "molecules/", extension = ".toml";

std::string required_text(TomlTable& table, std::string_view key, std::string_view example) {
  const auto value = table.text(key);
  if (!value)
    table.refuse(key,
                 fmt::format("there is no {}; write for example {} = \"{}\"", key, key, example));
  table.require(!value->empty(), key,
                fmt::format("must not be empty; write for example \"{}\"", example));
  return *value;
}

/// Rejects either of two keys without the other, because both are required together.
void require_other(TomlTable& table, double value, const char* key, const char* other,
                   const char* example) {
  table.require(value == 0 || table.has(other), key,
                fmt::format("has no effect without {0}; write for example {0} = \"{1}\", or leave "
                            "both out",
                            other, example));
}

Site read_site(TomlTable table, const std::string& file) {
  Site site;
  site.name = required_text(table, "name", "OW");
  site.element = table.text("element").value_or("");
  table.at("element", [&] { check_name("the element of site '" + site.name + "'", site.element); });
  if (!site.element.empty() && !is_element(site.element))
    table.refuse(
        "element",
        fmt::format("is not a chemical element{}; give a symbol such as O, also for united "
                    "atoms (C for CH3), or leave it out if the site has no mass",
                    did_you_mean(site.element, element_symbols())));
  const auto position = table.vector("position", Dimension::length);
  if (!position)
    table.refuse("position", fmt::format("site '{}' has no position; write for example "
                                         "position = \"0 0.015 0 nm\"",
                                         site.name));
  site.r = *position;
  site.mass = table.quantity("mass", Dimension::mass).value_or(0);
  table.require(site.mass >= 0, "mass",
                "must be 0 or more; leave the mass out if the site has none");
  site.charge = table.quantity("charge", Dimension::charge).value_or(0);
  const ShortRangeKeys keys = read_short_range(table, LawOwner::site, file);
  site.sigma = keys.sigma, site.epsilon = keys.epsilon, site.law = keys.law;
  table.refuse_unknown();
  if (std::holds_alternative<LennardJonesLaw>(site.law)) {
    require_other(table, site.sigma, "sigma", "epsilon", "0.8 kJ/mol");
    require_other(table, site.epsilon, "epsilon", "sigma", "0.33 nm");
  }
  if (site.mass > 0 && site.element.empty())
    table.refuse("element", fmt::format("site '{}' has mass but no element, and coordinate files "
                                        "need the element; write for example element = \"O\"",
                                        site.name));
  return site;
}

std::optional<MixingRule> mixing_of(TomlTable& table) {
  const auto given = table.text("mixing");
  if (!given) return std::nullopt;
  const auto rule = value_of<MixingRule>(*given);
  table.require(rule.has_value(), "mixing",
                fmt::format("must be one of: {}", fmt::join(enum_names<MixingRule>, ", ")));
  return rule;
}

}  // namespace

Molecule read_molecule_table(TomlTable table, const std::string& file) {
  const std::string name = required_text(table, "name", "tip4p");
  const std::string description = table.text("description").value_or("");
  const std::string source = required_text(table, "source", "jorgensen1983");
  const auto mixing = mixing_of(table);
  const auto site_tables = table.tables("site");
  table.refuse_unknown();
  if (!site_tables || site_tables->empty())
    throw Error("the molecule has no site; add at least one table [[site]]", table.where(""));
  std::vector<Site> sites;
  for (const TomlTable& site : *site_tables) sites.push_back(read_site(site, file));
  Molecule molecule = table.at("", [&] { return rigid_molecule(name, std::move(sites)); });
  molecule.description = description;
  molecule.source = source;
  molecule.mixing = mixing;
  return molecule;
}

Molecule parse_molecule(std::string_view text, const std::string& file) {
  const toml::table document = parse_toml(text, file);
  return read_molecule_table(TomlTable(document, file), file);
}

std::vector<std::string> molecule_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_files())
    if (file.path.starts_with(folder) && file.path.ends_with(extension))
      names.emplace_back(
          file.path.substr(folder.size(), file.path.size() - folder.size() - extension.size()));
  std::sort(names.begin(), names.end());
  return names;
}

bool is_molecule_path(std::string_view name) {
  if (name.ends_with(extension)) return true;
  const auto names = molecule_names();
  const auto is_built_in = [&](const std::string& model) { return same_letters(name, model); };
  return name.find('/') != name.npos && std::none_of(names.begin(), names.end(), is_built_in);
}

Molecule read_molecule(const std::string& name_or_path) {
  if (is_molecule_path(name_or_path)) return parse_molecule(file_text(name_or_path), name_or_path);
  const std::string path = std::string(folder) + name_or_path + std::string(extension);
  if (const auto text = embedded_text(path)) return parse_molecule(*text, path);
  const auto names = molecule_names();
  const auto near = did_you_mean(name_or_path, names);
  throw Error(
      fmt::format("there is no molecule '{}'{} ('polhode molecules' lists all molecules; the name "
                  "of your own molecule file must end in .toml)",
                  name_or_path, near));
}

}  // namespace polhode
