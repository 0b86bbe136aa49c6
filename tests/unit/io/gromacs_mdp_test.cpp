// SPDX-License-Identifier: MIT
// Run parameters of GROMACS as a run file: what has the same meaning is translated, and everything
// else is listed.
#include "io/topology/gromacs_mdp.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include "../errors.hpp"
#include "../folder.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/io/settings/config.hpp"

using namespace polhode;

namespace {

/// The run file as the program reads it; its files exist.
Config config_of(const std::string& mdp) {
  const Folder folder;
  for (const char* name : {"topol.top", "conf.gro"}) std::ofstream(folder / name) << '\n';
  return parse_config(import_mdp(mdp, "md.mdp").run_file, folder / "gromacs.toml");
}

/// Whether a parameter is listed, with this reason.
bool lists(const std::string& mdp, const std::string& parameter, const std::string& reason) {
  const MdpImport read = import_mdp(mdp, "md.mdp");
  const bool commented = read.run_file.find("#   " + parameter) < read.run_file.find("[system]");
  return commented && std::any_of(read.differences.begin(), read.differences.end(), [&](auto& d) {
           return d.parameter.starts_with(parameter) && d.reason.find(reason) != d.reason.npos;
         });
}

const std::string npt = R"(; a liquid
integrator = md        ; leap-frog
dt         = 0.002
nsteps     = 50000
nstxout-compressed = 500
nstenergy  = 100
rvdw       = 1.1
rcoulomb   = 0.9
vdw_modifier = potential-switch
rvdw-switch = 0.95
coulombtype = PME
DispCorr   = EnerPres
tcoupl     = V-rescale
tc-grps    = System
tau_t      = 0.5
ref_t      = 310
pcoupl     = C-rescale
tau_p      = 3
ref_p      = 20
compressibility = 8e-5
gen_vel    = yes
gen_temp   = 310
gen-seed   = 17
)";

}  // namespace

TEST_CASE("parameters of GROMACS with the same meaning are translated") {
  const Config c = config_of(npt);
  CHECK(c.system.temperature == 310);
  CHECK(c.system.seed == 17);
  CHECK(c.system.new_velocities == true);
  CHECK(c.forces.cutoff == 1.1);
  CHECK(c.forces.switch_from == 0.95);
  CHECK(c.forces.electrostatics == Electrostatics::pme);
  CHECK(c.forces.dispersion_correction);
  CHECK(c.integrator.scheme == "velocity-verlet");
  CHECK(c.integrator.step == doctest::Approx(0.002));
  CHECK(c.run.length == doctest::Approx(100));
  CHECK(c.run.sample == doctest::Approx(0.2));
  REQUIRE(c.ensemble.thermostat);
  CHECK(c.ensemble.thermostat == ThermostatSettings(Rescaling{0.5}));
  REQUIRE(c.ensemble.barostat);
  CHECK(c.ensemble.barostat->pressure == doctest::Approx(20 * unit("bar", Dimension::pressure)));
  CHECK(c.ensemble.barostat->type == BoxMoves(CellRescaling{3}));
  CHECK(c.ensemble.barostat->compressibility ==
        doctest::Approx(8e-5 * unit("1/bar", Dimension::compressibility)));
  CHECK(c.output.trajectory_every == doctest::Approx(1));
  CHECK(c.output.formats == std::vector<std::string>{"xtc"});
  CHECK(c.output.prefix == "gromacs");
  // Only rcoulomb is listed, which is chosen with the mesh.
  CHECK(import_mdp(npt, "md.mdp").differences.size() == 1);
  CHECK(lists(npt, "rcoulomb = 0.9", "chosen with the mesh"));
}

TEST_CASE("absent parameters of GROMACS have the defaults of GROMACS") {
  const Config c = config_of("nsteps = 10\n");
  CHECK(c.integrator.step == doctest::Approx(0.001));
  CHECK(c.forces.cutoff == 1);
  // A plain cut-off of charges is shifted to 0 at the cutoff: a reaction field of 1.
  CHECK(c.forces.electrostatics == Electrostatics::reaction_field);
  CHECK(c.forces.dielectric == 1);
  CHECK(c.forces.truncation == Truncation::site_switch);
  CHECK_FALSE(c.forces.dispersion_correction);
  CHECK(c.ensemble.constant_energy());
  CHECK(c.output.trajectory_every == 0);
  CHECK(lists("nsteps = 10\n", "vdw-modifier = Potential-shift (default)", "switched smoothly"));
  CHECK(config_of("nsteps=1\ncoulombtype=reaction-field\nepsilon_rf=78.5\n").forces.dielectric ==
        78.5);
}

TEST_CASE("stochastic dynamics of GROMACS is Langevin dynamics") {
  const Config c = config_of("integrator = sd\nnsteps = 1\ntau-t = 2\nref-t = 250\n");
  REQUIRE(c.ensemble.thermostat);
  REQUIRE(std::holds_alternative<Langevin>(*c.ensemble.thermostat));
  CHECK(std::get<Langevin>(*c.ensemble.thermostat).friction == doctest::Approx(0.5));
  CHECK(c.system.temperature == 250);
}

TEST_CASE("edges of semi-isotropic pressure coupling") {
  const std::string semi =
      replaced(replaced(replaced(npt, "ref_p      = 20", "ref_p = 20 20"), "= 8e-5", "= 8e-5 8e-5"),
               "tau_p", "pcoupltype = semiisotropic\ntau_p");
  CHECK(config_of(semi).ensemble.barostat->edges != config_of(npt).ensemble.barostat->edges);
  CHECK(import_mdp(semi, "md.mdp").run_file.find(R"(edges = ["xy", "z"])") != std::string::npos);
  const std::string flat = replaced(semi, "8e-5 8e-5", "0 8e-5");
  CHECK(import_mdp(flat, "md.mdp").run_file.find(R"(edges = ["z"])") != std::string::npos);
  const std::string fixed = replaced(npt, "= 8e-5", "= 0");
  CHECK_FALSE(config_of(fixed).ensemble.barostat);
  CHECK(lists(fixed, "compressibility = 0", "no barostat"));
}

TEST_CASE("parameters without counterpart are listed with the reason") {
  for (const auto& [line, reason] : std::initializer_list<std::pair<const char*, const char*>>{
           {"nstlist = 10", "neighbour list"},
           {"fourierspacing = 0.12", "mesh"},
           {"lincs-order = 4", "rigid by construction"},
           {"freezegrps = wall", "not available"},
           {"pull = yes", "not available"},
           {"constraints = h-bonds", "rigid = [...]"},
           {"vdwtype = PME", "not available"},
           {"nstcomm = 10", "at rest"},
           {"pbc = xy", "three dimensions"}}) {
    CAPTURE(line);
    CHECK(lists(npt + line + '\n', line, reason));
    config_of(npt + line + '\n');
  }
  const std::size_t before = import_mdp(npt, "md.mdp").differences.size();
  for (const char* off : {"pull = no", "free-energy = no", "annealing =", "nwall = 0"}) {
    CAPTURE(off);
    CHECK(import_mdp(npt + off + '\n', "md.mdp").differences.size() == before);
  }
  for (const auto& [from, to] : std::initializer_list<std::pair<const char*, const char*>>{
           {"V-rescale", "Nose-Hoover"}, {"C-rescale", "Parrinello-Rahman"}}) {
    const std::string text = replaced(npt, from, to);
    CHECK(import_mdp(text, "md.mdp").differences.size() == before + 1);
    CHECK(config_of(text).ensemble.barostat);
  }
}

TEST_CASE("lines of an .mdp file that are not parameters are refused with their place") {
  check_error([] { import_mdp("dt = 0.001\nsteps 5\n", "md.mdp"); }, {"'steps 5'", "md.mdp:2"});
  check_error([] { import_mdp("dt = 1\nD-T = 2\n", "md.mdp"); }, {"twice", "md.mdp:2"});
  check_error([] { import_mdp("dt = fast\n", "md.mdp"); }, {"'fast'", "dt", "md.mdp:1"});
}
