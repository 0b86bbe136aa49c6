// SPDX-License-Identifier: MIT
// Converts the parameters of an .mdp file to a run file.
#include <fmt/core.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/printable.hpp"
#include "io/files/split_words.hpp"
#include "io/files/text_file.hpp"
#include "io/settings/output_units.hpp"
#include "mdp_parameters.hpp"

namespace polhode {
namespace {

using gromacs::MdpParameters;

/// Writes a text or a list of texts as TOML.
std::string toml_text(const toml::node& value) {
  std::ostringstream out;
  out << toml::toml_formatter(value, toml::format_flags::none);
  return out.str();
}

class Translation {
 public:
  Translation(MdpParameters& mdp, const MdpFiles& files) : mdp_(mdp), files_(files) {}

  std::string run_file();

 private:
  void table(const char* name) { text_ += fmt::format("\n[{}]\n", name); }
  /// Adds a line to the run file, with a comment that names the GROMACS parameters.
  void line(const char* key, const std::string& value, const char* comment) {
    text_ += fmt::format("{:<38} # {}\n", fmt::format("{} = {}", key, value), comment);
  }
  void quantity(const char* key, double value, const char* unit, const char* comment) {
    line(key, fmt::format("\"{:.10g} {}\"", value, unit), comment);
  }
  void list(const char* key, std::string_view option, const char* parameter);
  void system();
  void forces();
  void truncation();
  void electrostatics();
  void integrator();
  void run();
  void thermostat();
  void barostat();
  std::string edges();
  void output();

  bool stochastic() { return mdp_.is("integrator", {"sd", "bd"}, "md"); }
  bool minimises() { return mdp_.is("integrator", {"steep", "cg", "l-bfgs", "lbfgs"}, "md"); }
  bool has_thermostat() { return stochastic() || !mdp_.is("tcoupl", "no"); }
  /// A time [ps] that is given as a number of steps.
  double time_of(std::string_view steps, double fallback) {
    return mdp_.number(steps, fallback) * mdp_.number("dt", 0.001);
  }

  MdpParameters& mdp_;
  const MdpFiles& files_;
  std::string text_;
};

/// The arguments of an option letter as a list: NAME and OTHER in "-DNAME -DOTHER".
void Translation::list(const char* key, std::string_view option, const char* parameter) {
  const std::string value = mdp_.text(parameter);
  std::string_view rest = value;
  toml::array names;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (word == option)
      word = take_word(rest);
    else if (word.starts_with(option))
      word.remove_prefix(option.size());
    if (!word.empty()) names.push_back(std::string(word));
  }
  if (!names.empty()) line(key, toml_text(names), parameter);
}

void Translation::system() {
  text_ += "[system]\n";
  line("topology", toml_text(toml::value(files_.topology)),
       "defines molecules, charges, short-range potentials and mixing rule");
  line("initial_configuration", toml_text(toml::value(files_.coordinates)),
       "contains positions, box, and velocities if there are any");
  list("include", "-I", "include");
  list("define", "-D", "define");
  const bool draws = mdp_.is("gen-vel", "yes");
  const double drawn = mdp_.number("gen-temp", 300);
  const std::vector<double> baths = mdp_.numbers("ref-t");
  const double temperature = has_thermostat() && !baths.empty() ? baths.front() : drawn;
  if (draws || has_thermostat())
    quantity("temperature", temperature, "K", has_thermostat() ? "ref-t" : "gen-temp");
  if (draws) line("velocities", "\"new\"", "gen-vel = yes");
  if (draws && drawn != temperature)
    mdp_.differs("gen-temp", "velocities are drawn at the temperature of the thermostat");
  if (std::any_of(baths.begin(), baths.end(), [&](double T) { return T != baths.front(); }))
    mdp_.differs("ref-t", "all molecules have the same temperature, the first value of this list");
  mdp_.text("tc-grps");
  const double seed = mdp_.number("gen-seed", -1);
  const bool whole = seed >= 0 && seed < 1e15 && seed == std::floor(seed);
  line("seed", whole ? fmt::format("{:.0f}", seed) : "1",
       whole ? "gen-seed" : "seed of all random numbers; a different seed gives a different run");
  if (!whole && !mdp_.text("gen-seed").empty())
    mdp_.differs("gen-seed", "runs are reproducible: the seed is 1 unless another seed is given");
}

void Translation::truncation() {
  quantity("cutoff", mdp_.number("rvdw", 1), "nm",
           "rvdw; at most half the shortest edge of the box");
  const double from = mdp_.number("rvdw-switch", 0);
  const bool old = mdp_.is("vdwtype", "switch", "cut-off");
  const bool switched = old || mdp_.is("vdw-modifier", "potential-switch", "potential-shift");
  if (switched && from > 0) {
    quantity("switch", from, "nm", "rvdw-switch; the polynomial of Potential-switch");
  } else if (switched) {
    mdp_.differs("rvdw-switch",
                 "the switching distance must be above 0 nm, so 0.85 of the cutoff is used", "0");
  } else {
    mdp_.differs("vdw-modifier",
                 "discontinuous or shifted forces are not available: from 0.85 of the cutoff to "
                 "the cutoff the potential is switched smoothly to 0 (switch)",
                 "Potential-shift");
  }
  if (!old && !mdp_.is("vdwtype", "cut-off", "cut-off"))
    mdp_.differs("vdwtype", "not available: short-range potentials end at the cutoff");
  const bool energy = mdp_.is("DispCorr", {"ener", "allener"});
  if (energy) mdp_.differs("DispCorr", "the correction applies to energy and pressure");
  if (energy || mdp_.is("DispCorr", {"enerpres", "allenerpres"}))
    line("dispersion_correction", "true", "DispCorr");
}

void Translation::electrostatics() {
  const auto any = [&](std::initializer_list<std::string_view> names) {
    return mdp_.is("coulombtype", names, "cut-off");
  };
  const bool plain = any({"cut-off"});
  if (plain || any({"reaction-field", "generalized-reaction-field", "reaction-field-zero"})) {
    const double rf = plain ? 1 : mdp_.number("epsilon-rf", 0);
    line("electrostatics", "\"reaction-field\"", "coulombtype");
    line("truncation", "\"site-switch\"", "between sites, as in GROMACS");
    line("dielectric", rf == 0 ? "\"infinite\"" : fmt::format("{:.10g}", rf),
         plain ? "a plain cut-off is a reaction field with a relative permittivity of 1"
               : "epsilon-rf");
    const double cutoff = mdp_.number("rcoulomb", 1);
    if (cutoff != mdp_.number("rvdw", 1))
      mdp_.differs("rcoulomb", "a reaction field uses the cutoff of the short-range potentials",
                   "1");
    if (!plain && !any({"reaction-field"}))
      mdp_.differs("coulombtype", "not available: coulombtype = Reaction-Field is used instead");
  } else {
    line("electrostatics", "\"pme\"", "coulombtype");
    if (!any({"pme", "ewald", "p3m-ad"}))
      mdp_.differs("coulombtype", "not available: coulombtype = PME is used instead");
    if (!mdp_.text("rcoulomb").empty())
      mdp_.differs("rcoulomb",
                   "not needed: this cutoff is chosen with the mesh, and affects forces by less "
                   "than pme_accuracy; to choose the cutoff yourself, set coulomb_cutoff");
  }
  mdp_.text("coulomb-modifier");
  if (const double r = mdp_.number("epsilon-r", 1); r != 1)
    mdp_.differs("epsilon-r", "charges interact in vacuum: scale all charges by 1/sqrt(epsilon-r)");
  if (mdp_.number("epsilon-surface", 0) != 0)
    mdp_.differs("epsilon-surface", "the periodic images are surrounded by a conductor");
  if (!mdp_.is("ewald-geometry", "3d", "3d"))
    mdp_.differs("ewald-geometry", "the Ewald sum is periodic in three dimensions");
}

void Translation::forces() {
  table("forces");
  truncation();
  electrostatics();
  if (!mdp_.is("pbc", "xyz", "xyz")) mdp_.differs("pbc", "boxes are periodic in three dimensions");
  if (!mdp_.is("constraints", "none", "none"))
    mdp_.differs("constraints",
                 "only settles and [ constraints ] of the topology make molecules rigid; list the "
                 "names of other rigid molecules in rigid = [...] of [system]");
}

void Translation::integrator() {
  table("integrator");
  line("scheme", "\"velocity-verlet\"",
       "integrator; \"hoa2\" has the same accuracy at longer steps");
  quantity("step", mdp_.number("dt", 0.001) * units::fs_per_ps, "fs", "dt");
  if (mdp_.is("integrator", "bd", "md"))
    mdp_.differs("integrator",
                 "Brownian dynamics is not available: Langevin dynamics is used instead");
  else if (!minimises() && !stochastic() &&
           !mdp_.is("integrator", {"md", "md-vv", "md-vv-avek"}, "md"))
    mdp_.differs("integrator", "not available: molecular dynamics is used instead");
  if (!mdp_.is("comm-mode", "linear", "linear"))
    mdp_.differs("comm-mode", "the centre of mass is at rest, but the system may rotate");
}

void Translation::run() {
  table("run");
  const double length = time_of("nsteps", 0);
  if (minimises()) {
    line("minimise", "true", "integrator; polhode minimise only minimises");
    mdp_.differs(
        "integrator",
        "'polhode minimise' minimises the energy; in a run the minimisation precedes the dynamics");
  } else if (length > 0) {
    quantity("length", length, "ps", "nsteps times dt");
  } else {
    mdp_.differs("nsteps", "the length of a run must be above 0 ps; the default is 15 ps", "0");
  }
  if (const double sample = time_of("nstenergy", 0); sample > 0)
    quantity("sample", sample, "ps",
             "nstenergy times dt; averages use only samples at this interval");
}

void Translation::thermostat() {
  if (!has_thermostat()) return;
  table("thermostat");
  const std::vector<double> times = mdp_.numbers("tau-t");
  const double time = times.empty() ? 0 : times.front();
  if (std::any_of(times.begin(), times.end(), [&](double t) { return t != time; }))
    mdp_.differs("tau-t",
                 "all molecules have the same thermostat, with the first value of this list");
  if (stochastic() || mdp_.is("tcoupl", {"andersen", "andersen-massive"})) {
    line("type", "\"langevin\"", stochastic() ? "integrator = sd" : "tcoupl");
    if (time > 0) quantity("friction", 1 / time, "1/ps", "1/tau-t");
    if (!stochastic())
      mdp_.differs("tcoupl", "not available: Langevin friction of rate 1/tau-t is used instead");
    return;
  }
  line("type", "\"rescaling\"", "tcoupl: stochastic velocity rescaling");
  if (time > 0) quantity("time_constant", time, "ps", "tau-t");
  if (!mdp_.is("tcoupl", "v-rescale"))
    mdp_.differs("tcoupl",
                 "not available: stochastic velocity rescaling (v-rescale) with the same time "
                 "constant is used instead");
}

/// Groups of edges that are scaled together, as TOML; empty if all edges are scaled together.
std::string Translation::edges() {
  const std::vector<double> soft = mdp_.numbers("compressibility"), P = mdp_.numbers("ref-p");
  const auto rigid = [&](std::size_t k) { return k < soft.size() && soft[k] == 0; };
  const auto moving = [&](std::initializer_list<const char*> names) {
    std::string list;
    std::size_t k = 0;
    for (const char* name : names)
      if (!rigid(k++)) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
    return '[' + list + ']';
  };
  const bool semi = mdp_.is("pcoupltype", "semiisotropic", "isotropic");
  const bool each = mdp_.is("pcoupltype", "anisotropic", "isotropic");
  if (!semi && !each) {
    if (!mdp_.is("pcoupltype", "isotropic", "isotropic"))
      mdp_.differs("pcoupltype", "not available: all box edges are scaled by one factor");
    return {};
  }
  const std::size_t count = std::min<std::size_t>(P.size(), semi ? 2 : 3);
  for (std::size_t k = 1; k < count; ++k)
    if (P[k] != P[0])
      mdp_.differs("ref-p", "the barostat has a single pressure, the first value of this list");
  return semi ? moving({"xy", "z"}) : moving({"x", "y", "z"});
}

void Translation::barostat() {
  if (mdp_.is("pcoupl", "no")) return;
  const std::vector<double> soft = mdp_.numbers("compressibility");
  const auto found = std::find_if(soft.begin(), soft.end(), [](double x) { return x > 0; });
  if (!soft.empty() && found == soft.end()) {
    mdp_.differs("compressibility", "the box is fixed, so there is no barostat");
    return;
  }
  table("barostat");
  line("type", "\"cell-rescaling\"", "pcoupl: stochastic cell rescaling");
  if (!mdp_.is("pcoupl", "c-rescale"))
    mdp_.differs("pcoupl", "not available: stochastic cell rescaling (C-rescale) is used instead");
  quantity("pressure", mdp_.number("ref-p", 1), "bar", "ref-p");
  quantity("time_constant", mdp_.number("tau-p", 1), "ps", "tau-p");
  if (found != soft.end()) quantity("compressibility", *found, "1/bar", "compressibility");
  if (const double every = time_of("nstpcouple", -1); every > 0)
    quantity("every", every, "ps", "nstpcouple times dt");
  if (const std::string groups = edges(); !groups.empty()) line("edges", groups, "pcoupltype");
  if (!has_thermostat())
    mdp_.differs("tcoupl", "a barostat needs a thermostat: add the table [thermostat]", "no");
}

void Translation::output() {
  table("output");
  line("prefix", toml_text(toml::value(files_.prefix)), "prefix of all output files");
  const double compressed = std::max(time_of("nstxout-compressed", 0), time_of("nstxtcout", 0));
  const double full = time_of("nstxout", 0);
  const bool velocities = mdp_.number("nstvout", 0) > 0;
  toml::array formats;
  if (compressed > 0) formats.push_back("xtc");
  if (full > 0 || velocities) formats.push_back("trr");
  const double every = compressed > 0 ? compressed : full > 0 ? full : time_of("nstvout", 0);
  quantity("trajectory_every", every, "ps",
           every > 0 ? "times dt: nstxout-compressed, or nstxout" : "no trajectory is written");
  if (!formats.empty()) line("formats", toml_text(formats), "nstxout-compressed; nstxout, nstvout");
  if (full > 0 && !velocities) line("velocities", "false", "nstvout = 0");
  if (compressed > 0 && full > 0 && compressed != full)
    mdp_.differs("nstxout", "all trajectory files have the same interval, nstxout-compressed");
  if (full > 0 && velocities && mdp_.number("nstvout", 0) != mdp_.number("nstxout", 0))
    mdp_.differs("nstvout", "all trajectory files have the same interval, nstxout");
}

std::string Translation::run_file() {
  system();
  forces();
  integrator();
  run();
  thermostat();
  barostat();
  output();
  return std::move(text_);
}

}  // namespace

MdpImport import_mdp(std::string_view text, const std::string& file, const MdpFiles& files) {
  MdpParameters mdp(text, file);
  const std::string body = Translation(mdp, files).run_file();
  MdpImport result{{}, mdp.differences()};
  result.run_file =
      fmt::format("# A GROMACS system with the parameters from {}.\n", printable(file));
  if (!result.differences.empty())
    result.run_file +=
        "# Parameters without a counterpart in polhode, or with a different meaning:\n";
  for (const auto& [parameter, reason] : result.differences)
    result.run_file += fmt::format("#   {}: {}\n", printable(parameter), reason);
  result.run_file += '\n' + body;
  return result;
}

MdpImport read_mdp(const std::string& path, const MdpFiles& files) {
  return import_mdp(file_text(path), path, files);
}

}  // namespace polhode
