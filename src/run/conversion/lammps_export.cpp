// SPDX-License-Identifier: MIT
#include "run/conversion/lammps_export.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/files/write_file.hpp"
#include "io/settings/ensemble_text.hpp"
#include "io/settings/quantity.hpp"
#include "io/settings/scheme_labels.hpp"
#include "io/topology/lammps_export.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/force_program.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/output_files.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

// Relative accuracy of the long-range forces in LAMMPS. With this accuracy, the errors in LAMMPS
// are smaller than the errors of polhode's mesh at the default accuracy.
constexpr double kspace_accuracy = 1e-6;

/// Whether a Langevin thermostat without friction is in effect none.
bool has_no_friction(const Config& config) {
  const auto& thermostat = config.ensemble.thermostat;
  const auto* const langevin = thermostat ? std::get_if<Langevin>(&*thermostat) : nullptr;
  return langevin && langevin->friction == 0;
}

void check(const Config& config) {
  const auto refuse = [&](const std::string& what) { throw Error(what, config.source); };
  if (config.ensemble.hybrid_monte_carlo)
    refuse("hybrid Monte Carlo has no counterpart in LAMMPS; remove [hybrid_monte_carlo]");
  if (config.forces.slab_dispersion)
    refuse(
        "slab_dispersion has no counterpart in pair styles; leave it out, and use pair_style "
        "lj/long/coul/long with kspace_style pppm/disp in LAMMPS");
  const auto& thermostat = config.ensemble.thermostat;
  const auto& barostat = config.ensemble.barostat;
  if (barostat && !(std::holds_alternative<CellRescaling>(barostat->type) && thermostat))
    refuse(
        "the barostat of fix polhode is cell rescaling with a thermostat; choose these, or remove "
        "[barostat]");
  if (barostat && has_no_friction(config))
    refuse(
        "the barostat of fix polhode needs a thermostat, but the friction is 0; give a friction "
        "above 0, or remove [barostat]");
  const auto* const langevin = thermostat ? std::get_if<Langevin>(&*thermostat) : nullptr;
  if (thermostat && !std::holds_alternative<Rescaling>(*thermostat) &&
      !(langevin && langevin->friction == langevin->rotational_friction))
    refuse(
        "the thermostats of fix polhode are rescaling, and langevin with the same friction for "
        "translation and rotation; choose one of these, or remove [thermostat]");
  if (config.output.prefix.find_first_of("\"\n") != std::string::npos)
    refuse(
        "the prefix of the output has a quotation mark or a line break, which LAMMPS does not "
        "allow in file names; choose another prefix");
}

/// Whether the script can equilibrate: an equilibration at constant energy would need a thermostat.
bool equilibrates(const Config& config) {
  return config.run.equilibrate > 0 && config.ensemble.thermostat && !has_no_friction(config);
}

void note_preparation(const Config& config, const Callbacks& callbacks) {
  const auto note = [&](const char* what) {
    callbacks.note(
        fmt::format("note: {} has no counterpart in the script, which begins with the initial "
                    "configuration as it is; use 'polhode prepare' before the export",
                    what));
  };
  if (config.run.minimise) note("minimise = true");
  if (config.run.equilibrate > 0 && !equilibrates(config)) note("equilibrate without a thermostat");
}

void note_moves(const Config& config, const Callbacks& callbacks) {
  const auto& barostat = config.ensemble.barostat;
  if (barostat && std::get<CellRescaling>(barostat->type).metropolis)
    callbacks.note(
        "note: fix polhode accepts every move of the box, as polhode does with metropolis = false");
}

// The scheme of a run for LAMMPS, with finite differences in place of exact gradients.
Scheme lammps_scheme(const Config& config, const Callbacks& callbacks) {
  const Scheme scheme = single_scheme_of(config.integrator.scheme);
  if (scheme.has(Flow::bath))
    throw Error(
        fmt::format("the scheme '{}' has a thermostat within its steps, but the thermostats "
                    "of fix polhode act at the ends of a step; choose a scheme without "
                    "stages O, such as velocity-verlet, hoa2 or bcss3",
                    scheme.name()),
        config.source);
  if (!scheme.starts_with_kick() || !scheme.ends_with_kick())
    throw Error(
        fmt::format("the scheme '{}' does not begin with a kick, but a scheme of fix polhode must "
                    "begin with a kick; choose another scheme, such as bcss3 or gier4-fd",
                    scheme.name()),
        config.source);
  if (!scheme.has(Gradient::exact)) return scheme;
  callbacks.note(
      "note: the exact gradients of the scheme become finite differences, since LAMMPS does not "
      "compute derivatives of the forces");
  std::vector<Stage> stages(scheme.stages().begin(), scheme.stages().end());
  for (Stage& stage : stages)
    if (stage.xi != 0) stage.gradient = Gradient::finite_difference;
  return Scheme(stages, scheme.order());
}

bool has_mesh(const ForceSettings& settings) {
  return settings.electrostatics == Electrostatics::pme;
}

// The molecule file of a part of the topology.
std::string molecule_file(const std::string& prefix, std::size_t part) {
  return fmt::format("{}-{}.molecule", prefix, part + 1);
}

// The pair potentials as written in the script.
struct PairCommands {
  std::string style, coefficients;
};

PairCommands table_commands(const ForceSettings& settings, const LammpsTypes& types,
                            const std::string& file, const std::vector<std::string>& sections) {
  const bool mesh = has_mesh(settings);
  PairCommands commands{fmt::format("pair_style hybrid/overlay table spline {}", lammps_table_size),
                        mesh ? "pair_coeff * * coul/long\n" : ""};
  if (mesh)
    commands.style += fmt::format(" coul/long {:.17g}\npair_modify pair coul/long table 0",
                                  cutoff_of_charges(settings) / unit("A", Dimension::length));
  commands.style += '\n';
  std::size_t pair = 0;
  for (std::size_t i = 1; i <= types.types().size(); ++i)
    for (std::size_t j = i; j <= types.types().size(); ++j, ++pair)
      if (!sections[pair].empty())
        commands.coefficients +=
            fmt::format("pair_coeff {} {} table \"{}\" {}\n", i, j, file, sections[pair]);
      else if (!mesh)
        commands.coefficients += fmt::format("pair_coeff {} {} none\n", i, j);
  return commands;
}

// A file of the export other than the data file and the script.
struct TextFile {
  std::string name, text;
};

// Adds the molecule files of particles, and pair coefficients of zero for the particle types.
void add_particles(const Topology& topology, const LammpsTypes& types, const std::string& prefix,
                   PairCommands& pairs, std::vector<TextFile>& files) {
  for (std::size_t part = 0; part < topology.parts.size(); ++part) {
    pairs.coefficients += fmt::format("pair_coeff {0} {0} 0 0\n", types.types().size() + part + 1);
    std::ostringstream text;
    write_lammps_molecule(text, topology, part, types);
    files.push_back({molecule_file(prefix, part), text.str()});
  }
}

/// Makes the pair commands of the script.
/// @param files  list to which the function adds the files that the commands or the fix need
PairCommands pair_commands(const System& system, const LammpsTypes& types, LammpsPairStyle style,
                           const std::string& prefix, std::vector<TextFile>& files) {
  const bool particles = style == LammpsPairStyle::particles, mesh = has_mesh(system.forces);
  if (particles && mesh)
    throw Error(
        "the mesh of LAMMPS does not support charges within particles; use --pair-style polhode, "
        "or electrostatics without a mesh");
  std::ostringstream text;
  if (style == LammpsPairStyle::table) {
    const auto sections = write_lammps_tables(text, system.topology, system.forces, types, !mesh);
    files.push_back({prefix + ".table", text.str()});
    return table_commands(system.forces, types, files.back().name, sections);
  }
  write_lammps_pair_coefficients(text, system.topology, system.forces, types);
  PairCommands pairs{lammps_pair_style(system.forces), text.str()};
  if (particles) add_particles(system.topology, types, prefix, pairs, files);
  return pairs;
}

// Makes the input script.
class Script {
 public:
  Script(std::ostream& out, const Config& config, const System& system, const LammpsTypes& types,
         bool particles)
      : out_(out), config_(config), system_(system), types_(types), particles_(particles) {}

  void write(const Scheme& scheme, const PairCommands& pairs) const {
    const std::string& prefix = config_.output.prefix;
    fmt::print(out_,
               "# Written by polhode export from {}; the polhode plugin contains fix "
               "polhode.\nvariable plugin index polhodeplugin.so\nplugin load ${{plugin}}\nunits "
               "real\natom_style {}\n{}read_data \"{}.data\" {}\n",
               config_.source, particles_ ? "atomic" : "full", pairs.style + molecule_styles(),
               prefix, particles_ ? orientations() : "nocoeff");
    out_ << pairs.coefficients;
    if (molecules_have_sites()) fmt::print(out_, "bond_coeff *\n");
    if (has_mesh(system_.forces)) fmt::print(out_, "kspace_style pppm {:g}\n", kspace_accuracy);
    integrate(scheme);
  }

 private:
  bool molecules_have_sites() const {
    return !particles_ &&
           std::any_of(system_.topology.parts.begin(), system_.topology.parts.end(),
                       [](const auto& part) { return part.molecule.sites.size() > 1; });
  }

  std::string molecule_styles() const {
    std::string text;
    if (molecules_have_sites()) text += "bond_style zero\nspecial_bonds lj/coul 0 0 0\n";
    if (particles_)
      text +=
          "atom_modify map yes\n"
          "fix orientations all property/atom d2_orientation 4 d2_angular_momentum 3\n";
    return text + fmt::format("dielectric {:.17g} # the Coulomb constant of polhode\n",
                              lammps_dielectric());
  }

  static std::string orientations() {
    return fmt::format("fix orientations NULL {} nocoeff", lammps_particle_section);
  }

  void integrate(const Scheme& scheme) const {
    const std::size_t evaluations = force_program(scheme).size();
    const double fs = unit("fs", Dimension::time), h = config_.integrator.step;
    fmt::print(out_, "fix rigid all polhode scheme \"{}\"", text_of(scheme));
    for (std::size_t k = 0; k < types_.types().size(); ++k)
      if (types_.types()[k].site.mass == 0) fmt::print(out_, " massless {}", k + 1);
    if (particles_)
      for (std::size_t part = 0; part < system_.topology.parts.size(); ++part)
        fmt::print(out_, " particle {} \"{}\"", types_.types().size() + part + 1,
                   molecule_file(config_.output.prefix, part));
    if (config_.ensemble.thermostat && !has_no_friction(config_)) {
      const auto* const rescaling = std::get_if<Rescaling>(&*config_.ensemble.thermostat);
      const double time = rescaling ? rescaling->time_constant
                                    : 1 / std::get<Langevin>(*config_.ensemble.thermostat).friction;
      fmt::print(out_, " {} {:.17g} {:.17g} {}", rescaling ? "rescale" : "langevin",
                 config_.ensemble.temperature, time / fs, config_.system.seed);
    }
    barostat();
    const double samples = std::max(1.0, std::round(config_.run.sample / h));
    fmt::print(out_,
               "\ntimestep {:.17g} # one force evaluation; a step of the scheme has {}\n"
               "{}"
               "thermo_modify format float %.15g\n"
               "thermo {:.0f}\n",
               h / fs / static_cast<double>(evaluations), evaluations, thermo(),
               samples * static_cast<double>(evaluations));
    const auto steps = [&](double t) {
      return std::round(t / h) * static_cast<double>(evaluations);
    };
    if (equilibrates(config_))
      fmt::print(out_, "run {:.0f} # equilibration\n", steps(config_.run.equilibrate));
    fmt::print(out_, "run {:.0f}\n", steps(config_.run.length));
  }

  void barostat() const {
    if (!config_.ensemble.barostat) return;
    const BarostatSettings& b = *config_.ensemble.barostat;
    const double fs = unit("fs", Dimension::time), atm = unit("atm", Dimension::pressure);
    fmt::print(out_, " pressure {:.17g} {:.17g} {:.17g} every {:.0f}", b.pressure / atm,
               std::get<CellRescaling>(b.type).time_constant / fs, b.compressibility * atm,
               std::max(1.0, std::round(b.every / config_.integrator.step)));
    if (b.edges != BarostatSettings{}.edges) {
      std::string groups = edges_text(b.edges);
      std::ranges::replace(groups, ' ', ',');
      fmt::print(out_, " edges {}", groups);
    }
  }

  // LAMMPS does not count the rotational energy of particles.
  std::string thermo() const {
    const std::string columns =
        std::string("thermo_style custom step time temp epair ke etotal econserve press") +
        (config_.ensemble.barostat ? " vol" : "");
    return particles_
               ? "variable total equal etotal+f_rigid[2]\n" + columns + " f_rigid[2] v_total\n"
               : columns + '\n';
  }

  std::ostream& out_;
  const Config& config_;
  const System& system_;
  const LammpsTypes& types_;
  bool particles_;
};

}  // namespace

std::vector<std::string> export_to_lammps(const Config& config, LammpsPairStyle style,
                                          const OutputOptions& options,
                                          const Callbacks& callbacks) {
  check(config);
  const std::string& prefix = config.output.prefix;
  check_prefix(prefix);
  const Scheme scheme = lammps_scheme(config, callbacks);
  const System system = build_system(config);
  note_molecules(system, callbacks);
  note_preparation(config, callbacks);
  note_moves(config, callbacks);
  const LammpsTypes types(system.topology, system.forces.mixing.pairs.empty());
  std::vector<TextFile>
      texts;  // these texts are made before any file, because a potential may be rejected
  const PairCommands pairs =
      at_place(config.source, [&] { return pair_commands(system, types, style, prefix, texts); });
  const bool particles = style == LammpsPairStyle::particles;
  const std::string data = prefix + ".data", input = prefix + ".in";
  std::vector<std::string> files = {data};
  for (const TextFile& file : texts) files.push_back(file.name);
  files.push_back(input);
  check_outputs(files, options.existing, inputs_of(config));
  for (const TextFile& file : texts)
    write_file(file.name, [&](std::ostream& out) { out << file.text; });
  write_file(data, [&](std::ostream& out) {
    (particles ? write_lammps_particles : write_lammps_data)(out, title_of(system.state),
                                                             system.state, system.topology, types);
  });
  write_file(input, [&](std::ostream& out) {
    Script(out, config, system, types, particles).write(scheme, pairs);
  });
  return files;
}

}  // namespace polhode
