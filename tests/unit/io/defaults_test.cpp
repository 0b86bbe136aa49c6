// SPDX-License-Identifier: MIT
// The defaults in the manual's tables of keys are those of the program.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <array>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "io/settings/ensemble_text.hpp"
#include "polhode/io/settings/config.hpp"

namespace polhode {
namespace {

constexpr std::array pages = {POLHODE_TEST_DATA "/../../docs/manual/run-files.md",
                              POLHODE_TEST_DATA "/../../docs/manual/ensembles.md"};

struct Default {
  std::string table, key, value;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// The default of a row of the manual as TOML: `"2 fs"`, 10, or names without quotes; empty if the
// row describes it in words.
std::string toml_value(std::string cell) {
  if (cell.starts_with('`')) return cell.substr(1, cell.find('`', 1) - 1);
  cell = cell.substr(0, cell.find_first_of(";:"));
  if (cell.find_first_not_of("0123456789.e-") == cell.npos) return cell;
  if (cell.find(", ") == cell.npos) return "";
  for (std::size_t k = 0; (k = cell.find(", ", k)) != cell.npos; k += 4)
    cell.replace(k, 2, "\", \"");
  return "[\"" + cell + "\"]";
}

void add_defaults(const char* page, std::vector<Default>& all) {
  std::ifstream in(page);
  std::string line, table;
  while (std::getline(in, line)) {
    if (line.starts_with("## ")) table = line.starts_with("## [") ? line.substr(3) : "";
    if (table.empty() || table.starts_with("[[") || !line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 1, bar; (bar = line.find('|', at)) != line.npos; at = bar + 1)
      cells.push_back(trimmed(line.substr(at, bar - at)));
    REQUIRE(cells.size() == 4);
    const std::string value = toml_value(cells[2]);
    if (!value.empty()) all.push_back({table, cells[0].substr(1, cells[0].size() - 2), value});
  }
}

std::vector<Default> defaults_of_manual() {
  std::vector<Default> all;
  for (const char* page : pages) add_defaults(page, all);
  return all;
}

// A run file with one key besides the molecules.
Config with(const Default& d) {
  const std::string key = d.key.empty() ? "" : d.key + " = " + d.value + "\n";
  std::string text =
      "[system]\nmolecules = [{ model = \"tip4p\", count = 2 }]\ndensity = \"1 g/cm3\"\n";
  if (d.table == "[system]") return parse_config(text + key, "manual");
  // Keys of one kind of electrostatics need that.
  const std::map<std::string, std::string> user = {{"pme_accuracy", "pme"},
                                                   {"damping", "damped-shifted-force"},
                                                   {"dielectric", "reaction-field"}};
  text += d.table + "\n";
  if (d.table == "[barostat]") text += "pressure = \"1 bar\"\n";
  // Langevin has no time constant.
  if (d.table == "[thermostat]" && d.key == "time_constant") text += "type = \"rescaling\"\n";
  if (const auto kind = user.find(d.key); kind != user.end())
    text += "electrostatics = \"" + kind->second + "\"\n";
  return parse_config(text + key, "manual");
}

// All settings that a key with a default can change, as text with every digit.
std::string settings_text(const Config& c) {
  const auto joined = [](const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += name + ",";
    return text;
  };
  const auto texts_of = [](const std::vector<NamedScheme>& schemes) {
    std::vector<std::string> texts;
    for (const NamedScheme& scheme : schemes) texts.push_back(scheme.text);
    return texts;
  };
  const auto& [s, f, i, r, o, y] =
      std::tie(c.system, c.forces, c.integrator, c.run, c.output, c.study);
  std::string text = fmt::format("{} {} ", s.temperature, s.seed);
  text +=
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} ", static_cast<int>(f.truncation), f.cutoff,
                  f.switch_from, f.smoothness, static_cast<int>(f.electrostatics), f.dielectric,
                  f.skin, static_cast<int>(f.precision), static_cast<int>(f.mixing.rule),
                  f.pme_accuracy, f.damping, f.dispersion_correction);
  text +=
      fmt::format("{} {} {} {} ", i.scheme.text, joined(texts_of(i.candidates)), i.step, i.lambda);
  text += fmt::format("{} {} {} {} ", r.equilibrate, r.length, r.sample, r.configurational_sample);
  text += fmt::format("{} {} {} {} {} {} {} ", o.prefix, o.trajectory_every, joined(o.formats),
                      o.massless_sites, o.velocities, o.plot, o.checkpoint_every);
  text += fmt::format("{} {} {} {} {}", joined(texts_of(y.schemes)), y.runs, y.length,
                      y.decorrelate, y.configurational_sample);
  for (const auto& [key, value] : ensemble_texts(c.ensemble)) text += " " + key + " " + value;
  return text;
}

}  // namespace

// A key with its default in the file leaves all settings as they are without it.
TEST_CASE("defaults in the manual are those of the program") {
  const auto defaults = defaults_of_manual();
  CHECK(defaults.size() == 48);
  for (const Default& d : defaults) {
    CAPTURE(d.table);
    CAPTURE(d.key);
    CAPTURE(d.value);
    const Default none{d.table, "", ""};
    const Config given = with(d);
    Config without = with(none);
    if (d.key == "time_constant" && d.table == "[thermostat]")
      without.ensemble.thermostat->kind = given.ensemble.thermostat->kind;
    if (d.key == "pme_accuracy" || d.key == "damping" || d.key == "dielectric") {
      without.forces.truncation = given.forces.truncation;
      without.forces.electrostatics = given.forces.electrostatics;
    }
    CHECK(settings_text(given) == settings_text(without));
  }
}

}  // namespace polhode
