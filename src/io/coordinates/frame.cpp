// SPDX-License-Identifier: MIT
#include "polhode/io/coordinates/frame.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "model/wrap.hpp"

namespace polhode {
namespace {

// The product J⁻¹ L. If a moment of inertia vanishes, the angular momentum along its axis is also
// zero.
double over(double L, double J) { return J > 0 ? L / J : 0.0; }

bool visible(const Site& site, MasslessSites massless) {
  return massless == MasslessSites::keep || site.mass != 0;
}

// The element at the beginning of an atom name. Ions are residues with a single atom, named after
// the element.
std::string element_of(const AtomKind& kind) {
  static constexpr std::string_view organic = "HBCNOFPSIK";
  static constexpr std::array<std::string_view, 12> ions = {"LI", "NA", "RB", "CS", "MG", "CA",
                                                            "SR", "BA", "ZN", "CL", "BR", "AR"};
  std::string word;
  for (const char c : kind.name)
    if (std::isalpha(static_cast<unsigned char>(c)))
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    else if (!word.empty())
      break;
  const bool alone =
      kind.residue_name.size() >= word.size() && !word.empty() &&
      std::equal(word.begin(), word.end(), kind.residue_name.begin(),
                 [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); });
  if (alone && std::find(ions.begin(), ions.end(), word) != ions.end())
    return {word[0], static_cast<char>(std::tolower(static_cast<unsigned char>(word[1])))};
  if (word.empty() || organic.find(word[0]) == organic.npos) return {};
  return {word[0]};
}

}  // namespace

void complete_elements(Frame& frame) {
  for (AtomKind& kind : frame.kinds)
    if (kind.element.empty()) kind.element = element_of(kind);
}

std::string title_of(const State& state) {
  return fmt::format("polhode t= {:.6f}", state.time);  // GROMACS reads the time from here
}

std::size_t atom_count(const Topology& topology, MasslessSites massless) {
  std::size_t n = 0;
  for (const auto& [molecule, count] : topology.parts)
    for (const Site& site : molecule.sites)
      if (visible(site, massless)) n += count;
  return n;
}

std::vector<AtomKind> atom_kinds(const Topology& topology, MasslessSites massless) {
  std::vector<AtomKind> kinds;
  for (const auto& [molecule, count] : topology.parts)
    for (const Site& site : molecule.sites)
      if (visible(site, massless)) kinds.push_back({molecule.name, site.name, site.element});
  return kinds;
}

void each_atom(const State& state, const Topology& topology, MasslessSites massless,
               const std::function<void(const Atom&)>& visit) {
  std::size_t i = 0;
  std::uint32_t first_kind = 0;
  for (const auto& [molecule, count] : topology.parts) {
    std::vector<Vec3<double>> sites;
    for (const Site& site : molecule.sites)
      if (visible(site, massless)) sites.push_back(site.r);
    for (std::size_t copy = 0; copy < count; ++copy, ++i) {
      const Vec3<double> q = state.q[i];
      const Vec3<double> home = wrapped(q, state.box);
      const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
      const Vec3<double> J = molecule.J;
      const Vec3<double> omega =
          to_lab(state.orientation[i], {over(L.x, J.x), over(L.y, J.y), over(L.z, J.z)});
      for (std::size_t k = 0; k < sites.size(); ++k) {
        const Vec3<double> x = to_lab(state.orientation[i], sites[k]);
        visit({.kind = first_kind + static_cast<std::uint32_t>(k),
               .residue = static_cast<int>(i % 100000) + 1,
               .r = home + x,
               .v = state.p[i] / molecule.mass + cross(omega, x)});
      }
    }
    first_kind += static_cast<std::uint32_t>(sites.size());
  }
}

Frame frame_of(const State& state, const Topology& topology, MasslessSites massless) {
  Frame frame;
  frame.title = title_of(state);
  frame.box = state.box;
  frame.time = state.time;
  frame.has_velocities = true;
  frame.kinds = atom_kinds(topology, massless);
  frame.atoms.reserve(atom_count(topology, massless));
  each_atom(state, topology, massless, [&](const Atom& atom) { frame.atoms.push_back(atom); });
  return frame;
}

}  // namespace polhode
