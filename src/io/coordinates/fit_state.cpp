// SPDX-License-Identifier: MIT
// Converts atoms to rigid bodies.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>

#include "math/eigen.hpp"
#include "model/elements.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/coordinates/frame.hpp"

namespace polhode {
namespace {

bool begins_with(std::string_view word, std::string_view start) {
  if (start.empty() || word.size() < start.size()) return false;
  const auto same = [](unsigned char a, unsigned char b) {
    return std::toupper(a) == std::toupper(b);
  };
  return std::equal(start.begin(), start.end(), word.begin(), same);
}

// Whether a file states that an atom is of an element, in any case of letters ("Mg", "MG").
bool has_element(const AtomKind& kind) {
  std::string symbol = kind.element;
  for (std::size_t k = 0; k < symbol.size(); ++k) {
    const auto letter = static_cast<unsigned char>(symbol[k]);
    symbol[k] = static_cast<char>(k == 0 ? std::toupper(letter) : std::tolower(letter));
  }
  return is_element(symbol);
}

// The element at the beginning of an atom name. Names differ between programs ("OW", "O", "OH2"),
// but all contain the element at the beginning, sometimes preceded by digits ("1HW"). An atom of a
// known element is no massless site: magnesium ("Mg") is not the site "MW".
bool matches(const AtomKind& kind, const Site& site) {
  std::string_view atom = kind.name;
  if (atom == site.name) return true;
  if (site.mass == 0 && has_element(kind)) return false;
  // massless sites: "X" in XYZ files, which have only elements, and "X1" in LAMMPS data files,
  // which have only masses
  if (site.mass == 0 && atom.substr(0, 1) == "X" &&
      atom.find_first_not_of("0123456789", 1) == atom.npos)
    return true;
  // "T1" in LAMMPS data files, for a mass that fits no element, such as the mass of a united atom
  if (atom.substr(0, 1) == "T" && atom.size() > 1 && element_of_mass(site.mass).empty() &&
      atom.find_first_not_of("0123456789", 1) == atom.npos)
    return site.mass > 0;
  while (!atom.empty() && std::isdigit(static_cast<unsigned char>(atom.front())))
    atom.remove_prefix(1);
  return begins_with(atom, site.mass > 0 ? std::string_view(site.element)
                                         : std::string_view(site.name).substr(0, 1));
}

// The residue of an atom, " (3 SOL)"; empty if the file has no names of residues.
std::string residue_text(const Frame& frame, const Atom& atom) {
  const std::string& name = frame.kind(atom).residue_name;
  return name.empty() ? "" : fmt::format(" ({} {})", atom.residue, name);
}

// The atom of each site of one molecule; null for a massless site without an atom.
using Match = std::vector<const Atom*>;

// Removes the atoms of the next molecule from the front of `atoms`.
Match take_molecule(std::span<const Atom>& atoms, const Molecule& molecule, const Frame& frame) {
  Match match;
  const Atom* first = atoms.empty() ? nullptr : &atoms.front();
  const auto place = [&] {
    return atoms.empty() ? std::string("the end of the atoms")
                         : fmt::format("atom {}{}", &atoms.front() - frame.atoms.data() + 1,
                                       residue_text(frame, atoms.front()));
  };
  for (const Site& site : molecule.sites) {
    const bool here = !atoms.empty() && matches(frame.kind(atoms.front()), site);
    const bool massless = site.mass == 0;
    if (massless && !(here && atoms.front().residue == first->residue)) {
      match.push_back(nullptr);
      continue;
    }
    if (!here)
      throw Error(
          fmt::format(
              "{} is {} instead of site '{}' of molecule '{}'; atoms must have the order "
              "of the sites in the model, and only massless sites may be missing",
              place(),
              atoms.empty() ? "reached" : fmt::format("'{}'", frame.kind(atoms.front()).name),
              site.name, molecule.name),
          frame.source);
    match.push_back(&atoms.front());
    atoms = atoms.subspan(1);
  }
  return match;
}

// Checks that an atom is near enough to the origin for precise distances, and not faster than
// light.
void check_range(const Atom& atom, const Frame& frame) {
  constexpr double max_distance = 1e6, max_speed = 299792.458;  // [nm], [nm/ps]
  const auto refuse = [&](const char* quantity, double value, double bound, const char* unit) {
    throw Error(fmt::format("the {} of atom {} ('{}') is {:.3g} {}; it must be at most {:.6g} {}: "
                            "correct the file",
                            quantity, &atom - frame.atoms.data() + 1, frame.kind(atom).name, value,
                            unit, bound, unit),
                frame.source);
  };
  if (const double r = norm(atom.r); !(r <= max_distance))
    refuse("distance from the origin", r, max_distance, "nm");
  if (const double v = norm(atom.v); !(v <= max_speed)) refuse("speed", v, max_speed, "nm/ps");
}

// Fits body i of `fitted` to the atoms of one molecule.
void fit(FittedState& fitted, std::size_t i, const Molecule& molecule, const Match& match,
         const Frame& frame) {
  State& state = fitted.state;
  for (const Atom* atom : match)
    if (atom != nullptr) check_range(*atom, frame);
  const auto& sites = molecule.sites;
  const auto anchor =
      std::find_if(sites.begin(), sites.end(), [](const Site& s) { return s.mass > 0; });
  const Vec3<double> base = match[static_cast<std::size_t>(anchor - sites.begin())]->r;
  const auto whole = [&](const Atom& atom) {
    return base + frame.box.minimum_image(atom.r - base);
  };
  Vec3<double> q{}, p{};
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (sites[k].mass == 0) continue;
    q += sites[k].mass / molecule.mass * whole(*match[k]);
    p += sites[k].mass * match[k]->v;
  }
  std::vector<Vec3<double>> body, lab;
  std::vector<double> mass;
  Vec3<double> ell{};
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (sites[k].mass == 0) continue;
    body.push_back(sites[k].r);
    lab.push_back(whole(*match[k]) - q);
    mass.push_back(sites[k].mass);
    ell += sites[k].mass * cross(lab.back(), match[k]->v);
  }
  const Quaternion<double> orientation =
      molecule.top == Top::atom ? Quaternion<double>{} : best_rotation(body, lab, mass);
  // There is no angular momentum about an axis with no moment of inertia.
  Vec3<double> L = to_body(orientation, ell);
  for (std::size_t k = 0; k < 3; ++k)
    if (molecule.J[k] == 0) L[k] = 0;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (match[k] == nullptr) continue;
    const double off = norm(whole(*match[k]) - q - to_lab(orientation, sites[k].r));
    if (sites[k].mass == 0) {
      fitted.massless_deviation = std::max(fitted.massless_deviation, off);
      continue;
    }
    fitted.deviation = std::max(fitted.deviation, off);
    if (!(off <= fit_tolerance))
      throw Error(
          fmt::format(
              "atom '{}' of molecule {}{} is {:.4f} nm from its site in the rigid model "
              "'{}'; this distance must be at most {} nm: check the model and the order of atoms",
              frame.kind(*match[k]).name, i + 1, residue_text(frame, *match[k]), off, molecule.name,
              fit_tolerance),
          frame.source);
  }
  state.q.set(i, q);
  state.p.set(i, p);
  state.orientation.set(i, orientation);
  state.ell.set(i, to_lab(orientation, L));
}

// Minimum images make a molecule whole only if the molecule is shorter than half of the shortest
// box edge.
void check_size(const Molecule& molecule, const Frame& frame) {
  double max_length = 0;
  for (const Site& a : molecule.sites)
    for (const Site& b : molecule.sites) max_length = std::max(max_length, norm(a.r - b.r));
  const double edge = frame.box.shortest_edge();
  if (2 * max_length >= edge)
    throw Error(
        fmt::format("molecule '{}' is {:.3f} nm long; it must be shorter than half of the shortest "
                    "box edge ({:.3f} nm), or it would interact with its own image",
                    molecule.name, max_length, edge),
        frame.source);
}

}  // namespace

FittedState fit_state(const Frame& frame, const Topology& topology) {
  if (topology.size() > frame.atoms.size())
    throw Error(fmt::format("the file has {} atoms, too few for {} molecules; set the number of "
                            "molecules to the number in the file",
                            frame.atoms.size(), topology.size()),
                frame.source);
  FittedState fitted;
  fitted.state = State(topology.size(), frame.box);
  fitted.has_velocities = frame.has_velocities;
  std::span<const Atom> atoms = frame.atoms;
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts) {
    check_size(molecule, frame);
    for (std::size_t copy = 0; copy < count; ++copy, ++i) {
      if (atoms.empty())
        throw Error(fmt::format("the {} atoms form only {} of {} molecules; set the number of "
                                "molecules to the number in the file",
                                frame.atoms.size(), i, topology.size()),
                    frame.source);
      fit(fitted, i, molecule, take_molecule(atoms, molecule, frame), frame);
    }
  }
  if (!atoms.empty())
    throw Error(fmt::format("the file has {} atoms, but the {} molecules have {} atoms; set the "
                            "number of molecules to the number in the file",
                            frame.atoms.size(), topology.size(), frame.atoms.size() - atoms.size()),
                frame.source);
  return fitted;
}

Topology complete_topology(Topology topology, const Frame& frame) {
  if (topology.parts.size() != 1 || topology.parts.front().count != 0) return topology;
  std::span<const Atom> atoms = frame.atoms;
  for (Topology::Part& part = topology.parts.front(); !atoms.empty(); ++part.count)
    take_molecule(atoms, part.molecule, frame);
  return topology;
}

}  // namespace polhode
