// SPDX-License-Identifier: MIT
#include "settings.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "arguments.hpp"
#include "atom.h"
#include "error.h"
#include "lammps.h"
#include "model/coupled_edges.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "utils.h"

namespace polhode::lammps {
namespace {

constexpr int largest_molecule_file = 1 << 20;  // maximum size in bytes

// The text of a file. One process reads the file and sends the text to all other processes.
std::string text_of_file(const std::string& path, MPI_Comm world) {
  int process = 0;
  MPI_Comm_rank(world, &process);
  std::ostringstream text;
  if (process == 0) text << std::ifstream(path).rdbuf();
  std::string all = text.str();
  auto size = static_cast<int>(std::min<std::size_t>(all.size(), largest_molecule_file + 1));
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  if (size == 0) throw Error("the molecule file '" + path + "' cannot be read, or is empty");
  if (size > largest_molecule_file)
    throw Error("'" + path + "' is larger than " + std::to_string(largest_molecule_file) +
                " bytes; a molecule file of a rigid molecule has a few lines");
  all.resize(static_cast<std::size_t>(size));
  MPI_Bcast(all.data(), size, MPI_CHAR, 0, world);
  return all;
}

class Reader {
 public:
  Reader(int count, char** words, LAMMPS_NS::LAMMPS* lammps)
      : arguments_(count, words, lammps), lammps_(lammps) {}
  FixSettings settings();

 private:
  void massless();
  void bath(BathType type);
  void barostat();
  void edges();
  std::uint64_t whole_number(const std::string& meaning, double min);
  void check_together();
  void particle();
  double temperature(const std::string& meaning);
  int type_number(std::string_view meaning);
  void check(const Scheme& scheme) const;

  Arguments arguments_;
  LAMMPS_NS::LAMMPS* lammps_;
  std::string scheme_ = "velocity-verlet";
  std::optional<double> last_temperature_;
  std::optional<std::uint64_t> every_;
  std::optional<std::vector<CoupledEdges>> edges_;
  FixSettings settings_;
};

void Reader::massless() {
  const std::string types(arguments_.word("an atom type or a range of types"));
  int low = 0, high = 0;
  const int count = lammps_->atom->ntypes;
  LAMMPS_NS::utils::bounds(FLERR, types, 1, count, low, high, lammps_->error);
  settings_.massless.resize(static_cast<std::size_t>(count) + 1);
  for (int type = low; type <= high; ++type)
    settings_.massless[static_cast<std::size_t>(type)] = true;
}

void Reader::bath(BathType type) {
  const std::string name = type == BathType::langevin ? "langevin" : "rescale";
  if (settings_.bath) throw Error("keyword " + name + ": only one bath can act; remove the other");
  BathArguments bath{.type = type};
  bath.temperature = temperature("the temperature of " + name);
  bath.time_constant = arguments_.positive("the time constant of " + name);
  bath.seed = whole_number("the seed of " + name, 0);
  settings_.bath = bath;
}

void Reader::barostat() {
  BarostatArguments barostat{.pressure = arguments_.number("the pressure")};
  barostat.time_constant = arguments_.positive("the time constant of pressure");
  barostat.compressibility = arguments_.positive("the compressibility of pressure");
  settings_.barostat = barostat;
}

/// Reads groups of edges: "xy,z" scales x and y together, and z separately.
void Reader::edges() {
  const std::string text(arguments_.word("the groups of edges"));
  std::vector<CoupledEdges> groups;
  std::istringstream parts(text + ',');
  for (std::string part; std::getline(parts, part, ',');) {
    const auto group = coupled_edges(part);
    if (!group)
      throw Error("keyword edges has the group '" + part + "' in '" + text +
                  "'; a group must be one or more of x, y and z: write for example xyz, or xy,z");
    groups.push_back(*group);
  }
  if (overlap(groups))
    throw Error("keyword edges has an edge in two groups of '" + text +
                "'; each edge may be in at most one group");
  edges_ = std::move(groups);
}

std::uint64_t Reader::whole_number(const std::string& meaning, double min) {
  const double value = arguments_.number(meaning);
  if (!(value >= min && value < 9e15) || value != std::floor(value))
    throw Error(meaning + " must be a whole number from " + std::to_string(std::lround(min)) +
                " to 9e15");
  return static_cast<std::uint64_t>(value);
}

double Reader::temperature(const std::string& meaning) {
  const double value = arguments_.number(meaning);
  if (!(value >= 0))
    throw Error(meaning + " is " + std::to_string(value) + "; it must be 0 or more");
  return value;
}

int Reader::type_number(std::string_view meaning) {
  const double number = arguments_.number(meaning);
  const int types = lammps_->atom->ntypes;
  if (!(number >= 1 && number <= types) || number != std::floor(number))
    throw Error(std::string(meaning) + " must be a number from 1 to " + std::to_string(types) +
                ", the number of atom types");
  return static_cast<int>(number);
}

void Reader::particle() {
  ParticleArguments particle;
  particle.type = type_number("the type of the particles");
  particle.path = arguments_.word("the molecule file of the particles");
  for (const ParticleArguments& other : settings_.particles)
    if (other.type == particle.type)
      throw Error("particles of type " + std::to_string(particle.type) +
                  " are given twice; particles of one type must be molecules of one kind");
  particle.file = parse_molecule_file(text_of_file(particle.path, lammps_->world), particle.path);
  for (const int type : particle.file.types)
    if (type > lammps_->atom->ntypes)
      throw Error(
          "'" + particle.path + "' has sites of type " + std::to_string(type) +
          ", but the simulation has only " + std::to_string(lammps_->atom->ntypes) +
          " atom types; increase the number of types in the data file or with 'extra/atom/types'");
  settings_.particles.push_back(std::move(particle));
}

// LAMMPS computes forces at the end of its steps, so a step of the scheme must end with a kick.
void Reader::check(const Scheme& scheme) const {
  if (scheme.has(Flow::bath))
    throw Error(
        "the scheme has a bath O; leave the stages O out and use the keyword langevin or rescale");
  if (!scheme.starts_with_kick() || !scheme.ends_with_kick())
    throw Error("the scheme '" + scheme_ +
                "' must begin and end with a kick, since LAMMPS computes forces at the end of each "
                "step; choose one of 'polhode schemes' whose stages begin with B");
  if (scheme.stages().front().xi != 0 || scheme.stages().back().xi != 0)
    throw Error("the scheme '" + scheme_ +
                "' begins or ends with a gradient kick, so a step would end at displaced "
                "positions; choose a scheme that begins and ends with a plain kick");
}

/// Checks the keywords that change other keywords.
void Reader::check_together() {
  if (last_temperature_ && !settings_.bath)
    throw Error(
        "keyword ramp changes the temperature of a bath; add the keyword langevin or rescale");
  if (settings_.bath) settings_.bath->last = last_temperature_;
  if (settings_.barostat && !settings_.bath)
    throw Error(
        "keyword pressure samples the volume at a temperature; add the keyword langevin or "
        "rescale");
  if (every_ && !settings_.barostat)
    throw Error("keyword every is the interval of the moves of the box; add the keyword pressure");
  if (edges_ && !settings_.barostat)
    throw Error("keyword edges names the edges that a barostat scales; add the keyword pressure");
  if (every_) settings_.barostat->every = *every_;
  if (edges_) settings_.barostat->edges = *edges_;
}

FixSettings Reader::settings() {
  arguments_.each_keyword(
      {{"scheme", [&] { scheme_ = arguments_.word("the name or the text of a scheme"); }},
       {"lambda", [&] { settings_.lambda = arguments_.positive("lambda"); }},
       {"tolerance", [&] { settings_.tolerance = arguments_.positive("tolerance"); }},
       {"massless", [&] { massless(); }},
       {"particle", [&] { particle(); }},
       {"langevin", [&] { bath(BathType::langevin); }},
       {"rescale", [&] { bath(BathType::rescale); }},
       {"ramp", [&] { last_temperature_ = temperature("the last temperature of ramp"); }},
       {"pressure", [&] { barostat(); }},
       {"edges", [&] { edges(); }},
       {"every", [&] { every_ = whole_number("the number of steps of every", 1); }}});
  check_together();
  const Scheme scheme = scheme_of(scheme_);
  check(scheme);
  settings_.scheme = settings_.bath ? with_bath(scheme, BathPlace::ends, scheme.name()) : scheme;
  return std::move(settings_);
}

}  // namespace

FixSettings fix_settings(int count, char** arguments, LAMMPS_NS::LAMMPS* lammps) {
  return Reader(count, arguments, lammps).settings();
}

}  // namespace polhode::lammps
