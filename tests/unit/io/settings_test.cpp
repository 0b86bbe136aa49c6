// SPDX-License-Identifier: MIT
// The settings of run files as data: their rows, and what follows from them. With
// POLHODE_WRITE_MANUAL=1 in the environment the test brings the tables of the manual up to date.
#include "io/settings/settings.hpp"

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "polhode/io/settings/config.hpp"

using namespace polhode;

namespace {

std::string page_of(const std::string& table) {
  const bool ensemble =
      table == "thermostat" || table == "barostat" || table == "hybrid_monte_carlo";
  return ensemble ? POLHODE_TEST_DATA "/../../docs/manual/ensembles.md"
                  : POLHODE_TEST_DATA "/../../docs/manual/run-files.md";
}

const std::string system_table =
    "[system]\nmolecules = [{ model = \"tip4p\", count = 2 }]\ndensity = \"1 g/cm3\"\n";

}  // namespace

TEST_CASE("the manual has the settings of each table as their rows state them") {
  for (const auto& [name, kind] : setting_table_names()) {
    const std::string table(name);
    if (table == "shape" || table == "pair" || table == "schemes") continue;
    CAPTURE(table);
    const std::string begin = "<!-- settings: " + table + " -->\n",
                      end = "<!-- end of settings -->";
    std::ifstream in(page_of(table));
    const std::string page{std::istreambuf_iterator<char>(in), {}};
    const auto first = page.find(begin);
    REQUIRE(first != page.npos);
    const auto at = first + begin.size(), last = page.find(end, at);
    REQUIRE(last != page.npos);
    if (std::getenv("POLHODE_WRITE_MANUAL"))
      std::ofstream(page_of(table)) << page.substr(0, at) + manual_table(table) + page.substr(last);
    else
      CHECK(page.substr(at, last - at) == manual_table(table));
  }
}

TEST_CASE("a setting is found by its path, or by its key if only one table has it") {
  CHECK(setting("forces.cutoff").path() == "forces.cutoff");
  CHECK(setting("cutoff").path() == "forces.cutoff");
  CHECK(setting("cutoff").unit == "nm");
  CHECK(setting("cutoff").kinds == std::vector{SettingKind::quantity});
  CHECK(setting("friction").domain == "0 1/ps ≤ rate ≤ 1e6 1/ps");
  CHECK(setting("thermostat.time_constant").fallback == "`\"0.5 ps\"`");
  check_error([] { setting("cutof"); }, {"no setting 'cutof'", "did you mean 'cutoff'?"});
  check_error([] { setting("length"); }, {"several tables", "run.length, study.length"});
}

TEST_CASE("each setting has a path of its own, a kind and a meaning") {
  std::set<std::string> paths;
  for (const Setting& one : settings()) {
    CAPTURE(one.path());
    CHECK(paths.insert(one.path()).second);
    CHECK(!one.kinds.empty());
    CHECK(!one.doc.empty());
    CHECK(!one.domain.empty());
  }
}

TEST_CASE("a setting has its value in the run") {
  const Config config = parse_config(system_table + "[forces]\ncutoff = \"1.2 nm\"\n", "x.toml");
  CHECK(value_text(setting("cutoff"), config) == "1.2 nm");
  CHECK(value_text(setting("switch"), config) == "1.02 nm");
  CHECK(value_text(setting("friction"), config).empty());
  CHECK(value_text(setting("molecules"), config).find("tip4p") != std::string::npos);
  CHECK(config.place("forces.cutoff") == "x.toml:5, forces.cutoff");
  CHECK(config.place("forces.switch") == "x.toml");
}

// A key with its default in the file leaves all settings as they are without it.
TEST_CASE("the program has the defaults that rows state") {
  std::size_t stated = 0;
  for (const Setting& one : settings()) {
    const std::string& text = one.fallback;
    if (text.size() < 2 || text.front() != '`' || text.find('`', 1) != text.size() - 1) continue;
    CAPTURE(one.path());
    ++stated;
    const auto with = [&](const std::string& line) {
      std::string file = system_table;
      if (one.table == "system") return parse_config(file + line, "x.toml");
      file += '[' + one.table + "]\n";
      if (one.table == "barostat") file += "pressure = \"1 bar\"\n";
      if (!one.by.empty()) file += one.by + " = \"" + one.by_names.front() + "\"\n";
      return parse_config(file + line, "x.toml");
    };
    const Config given = with(one.key + " = " + text.substr(1, text.size() - 2) + "\n"),
                 without = with("");
    for (const Setting& other : settings())
      if (!(other.key == one.key && other.table == one.table) ||
          !value_text(other, without).empty())
        CHECK(value_text(other, given) == value_text(other, without));
  }
  CHECK(stated > 40);
}

namespace {

/// A run file with one setting and what it needs.
std::string with(const Setting& one, const std::string& value) {
  std::map<std::string, std::string> tables{
      {"system", "molecules = [{ model = \"tip4p\", count = 2 }]\n"}};
  if (one.path() != "system.density" && one.path() != "system.box")
    tables["system"] += "density = \"1 g/cm3\"\n";
  tables[one.table] += one.key + " = " + value + "\n";
  tables["thermostat"];  // cools at 0 K
  if (one.table == "barostat") tables["barostat"] += "pressure = \"1 bar\"\n";
  if (one.by.size() > 0) tables[one.table] += one.by + " = \"" + one.by_names.front() + "\"\n";
  std::string text;
  for (const auto& [name, lines] : tables) text += "[" + name + "]\n" + lines;
  return text;
}

/// The number in the unit of a setting; a list has it alone.
std::string written(const Setting& one, double value) {
  if (one.kinds.front() == SettingKind::texts)
    return fmt::format("[\"{:.17g} {}\"]", value, one.unit);
  if (one.kinds.front() == SettingKind::integer) return fmt::format("{:.0f}", value);
  return one.unit.empty() ? fmt::format("{:.17g}", value)
                          : fmt::format("\"{:.17g} {}\"", value, one.unit);
}

struct Bound {
  double inside, outside;
};

/// Numbers at each finite bound of a setting, the next beyond it, and inside it.
std::vector<Bound> bounds_of(const Setting& one) {
  const auto step = [&](double bound) {
    return one.kinds.front() == SettingKind::integer ? 1 : 1e-9 * std::max(1.0, std::abs(bound));
  };
  std::vector<Bound> all;
  const auto add = [&](double bound, bool excluded, int inwards) {
    if (!std::isfinite(bound)) return;
    const double next = bound + (excluded ? 1 : -1) * inwards * step(bound);
    all.push_back(excluded ? Bound{next, bound} : Bound{bound, next});
  };
  add(one.bounds.min, one.bounds.above, 1);
  add(one.bounds.max, one.bounds.below, -1);
  return all;
}

}  // namespace

// Bounds that the library checks itself have complaints of its own.
TEST_CASE("each bound of a setting is kept by the run file, just inside and just outside") {
  std::size_t tried = 0;
  for (const Setting& one : settings())
    for (const auto& [inside, outside] : bounds_of(one)) {
      ++tried;
      const std::string good = with(one, written(one, inside)),
                        bad = with(one, written(one, outside));
      CAPTURE(good);
      CAPTURE(bad);
      CHECK_NOTHROW(parse_config(good, "x.toml"));
      const std::string place = ", " + one.path();
      check_error([&, &bad = bad] { parse_config(bad, "x.toml"); },
                  {one.key.c_str(), "must", place.c_str()});
      if (one.bounds.in_library) continue;
      const std::string words = wrong_value(one.path(), std::nan(""));
      check_error([&, &bad = bad] { parse_config(bad, "x.toml"); }, {words.c_str()});
    }
  CHECK(tried > 40);
}

TEST_CASE("what is wrong with a value is said without a run file as well") {
  CHECK(wrong_value("thermostat.friction", 1).empty());
  CHECK(wrong_value("thermostat.friction", -1) ==
        "must be 0 1/ps or more and at most 1e6 1/ps; 0.1 to 10 1/ps are usual");
  CHECK(wrong_value("run.length", 0) == "must be longer than 0 ps");
}

TEST_CASE("the meaning of a setting has no marks in plain text") {
  CHECK(plain_text("[a b](c.md#d), `\"x\"` and [\"y\"]") == "a b, \"x\" and [\"y\"]");
}
