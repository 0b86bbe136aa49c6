// SPDX-License-Identifier: MIT
#include "polhode/model/molecule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/printable.hpp"
#include "math/eigen.hpp"
#include "model/dipole.hpp"
#include "model/molecule_in_frame.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

// Relative tolerance of moments of inertia: smaller differences between moments are treated as
// zero. Coordinates have at least 10 digits. Moments, as squares of coordinates, have a few times
// the round-off error of coordinates.
constexpr double same_moment = 1e-9;

// Maximum number of sites, far above the needs of a rigid molecule. The pair loops allow 64
// interacting sites, and the size of a molecule is found by looping over all pairs.
constexpr std::size_t max_sites_of_molecule = 1024;

void check_site(const Site& site, const std::string& molecule) {
  const auto refuse = [&](const std::string& what) {
    throw Error("molecule '" + molecule + "', site '" + site.name + "': " + what);
  };
  check_name("a site of molecule '" + molecule + "'", site.name);
  check_name("the element of site '" + site.name + "'", site.element);
  for (const double x : {site.r.x, site.r.y, site.r.z, site.mass, site.charge})
    if (!std::isfinite(x)) refuse("a number is not finite; all properties must be finite");
  if (site.mass < 0)
    refuse("mass = " + std::to_string(site.mass) + " is negative; it must be 0 or more");
  try {
    check(site.sigma, site.epsilon, site.law);
  } catch (const Error& e) {
    refuse(e.what());
  }
}

// Two sites with mass at the same position are an error in the input, such as a copied line or
// missing positions. A massless charge or short-range site may be at the same position as another
// site.
void check_apart(const std::vector<Site>& sites, const std::string& molecule) {
  constexpr double same_place = 1e-3;  // one percent of a bond length [nm]
  for (std::size_t k = 1; k < sites.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (sites[i].mass > 0 && sites[k].mass > 0 &&
          norm2(sites[i].r - sites[k].r) < same_place * same_place)
        throw Error("molecule '" + molecule + "': the sites '" + sites[i].name + "' and '" +
                    sites[k].name +
                    "' have mass and the same position; correct one of the positions, or merge the "
                    "two sites");
}

// `rounding` is an upper bound on the round-off error of the moments: a single point mass may have
// moments up to this bound.
Top kind(Vec3<double>& J, double rounding) {
  const double tiny = same_moment * J.z;
  if (J.z <= rounding) {
    J = {};
    return Top::atom;
  }
  if (J.x <= tiny) {
    J.x = 0;
    J.y = J.z = (J.y + J.z) / 2;
    return Top::linear;
  }
  const bool low = J.y - J.x <= tiny, high = J.z - J.y <= tiny;
  if (low && high) return Top::spherical;
  return low || high ? Top::symmetric : Top::asymmetric;
}

// Whether the frame of an inertia tensor is a principal frame: all off-diagonal elements are within
// the round-off of site positions.
bool is_principal(const Mat3<double>& inertia) {
  const double rounding = 1e-14 * (inertia[0][0] + inertia[1][1] + inertia[2][2]);
  const auto none = [&](double x) { return std::abs(x) <= rounding; };
  return none(inertia[0][1]) && none(inertia[1][2]) && none(inertia[0][2]) &&
         inertia[0][0] <= inertia[1][1] + rounding && inertia[1][1] <= inertia[2][2] + rounding;
}

Eigen3 axes_of_frame(const Mat3<double>& inertia) {
  if (!is_principal(inertia)) return symmetric_eigen(inertia);
  return {{inertia[0][0], inertia[1][1], inertia[2][2]}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

// A body with no moment of inertia about an axis cannot respond to a torque about this axis. All
// sites of such a body must therefore lie on the axis.
void check_lever(Site& site, Top top, const std::string& molecule) {
  if (top != Top::linear && top != Top::atom) return;
  double& along = site.r.x;
  const double off = top == Top::linear ? std::hypot(site.r.y, site.r.z) : norm(site.r);
  if (off > 1e-7 && (site.charge != 0 || site.has_short_range()))
    throw Error("molecule '" + molecule + "', site '" + site.name + "' lies " +
                std::to_string(off) + " nm from the " +
                (top == Top::linear ? "axis of a linear body" : "only mass point") +
                "; a torque about this axis would act without inertia, so give mass to sites away "
                "from the axis");
  site.r = {top == Top::linear ? along : 0.0, 0.0, 0.0};
}

Molecule build(std::string name, std::vector<Site> sites,
               Eigen3 (*principal_axes)(const Mat3<double>&)) {
  if (sites.size() > max_sites_of_molecule)
    throw Error("molecule '" + name + "' has " + std::to_string(sites.size()) +
                " sites; the maximum for a rigid molecule is " +
                std::to_string(max_sites_of_molecule) + "; split the molecule, or check the file");
  check_name("a molecule", name);
  check_apart(sites, name);
  Molecule molecule;
  Vec3<double> centre{};
  double far = 0;  // upper bound Σ m r², before the centre is known
  for (const Site& site : sites) {
    check_site(site, name);
    molecule.mass += site.mass;
    centre += site.mass * site.r;
    far += site.mass * norm2(site.r);
  }
  if (molecule.mass == 0)
    throw Error("molecule '" + name +
                "' has mass 0 u; it needs mass to move, so give at least one site a mass");
  centre = centre / molecule.mass;

  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;  // Σ m r r
  for (Site& site : sites) {
    site.r -= centre;
    const auto& [x, y, z] = site.r;
    xx += site.mass * x * x, yy += site.mass * y * y, zz += site.mass * z * z;
    xy += site.mass * x * y, yz += site.mass * y * z, zx += site.mass * z * x;
  }
  const Eigen3 principal =
      principal_axes({{yy + zz, -xy, -zx}, {-xy, xx + zz, -yz}, {-zx, -yz, xx + yy}});
  molecule.J = principal.values;
  molecule.top = kind(molecule.J, 1e-28 * far);
  for (Site& site : sites) {
    site.r = principal.vectors * site.r;
    check_lever(site, molecule.top, name);
  }
  molecule.name = std::move(name);
  molecule.sites = std::move(sites);
  return molecule;
}

}  // namespace

const char* name(Top top) {
  constexpr const char* names[] = {"atom", "linear", "spherical", "symmetric", "asymmetric"};
  return names[static_cast<std::size_t>(top)];
}

double Molecule::charge() const {
  double q = 0;
  for (const Site& site : sites) q += site.charge;
  return q;
}

Vec3<double> dipole_moment(const Molecule& molecule) {
  Vec3<double> mu{};
  for (const Site& site : molecule.sites) mu += site.charge * site.r;
  return mu;
}

bool has_dipole(const Molecule& molecule) { return molecule.dipole() > 1e-9; }

double Molecule::dipole() const { return norm(dipole_moment(*this)); }

double Molecule::extent() const {
  double far = 0;
  for (const Site& site : sites)
    if (site.charge != 0 || site.has_short_range()) far = std::max(far, norm(site.r));
  return far;
}

Molecule rigid_molecule(std::string name, std::vector<Site> sites) {
  return build(std::move(name), std::move(sites), symmetric_eigen);
}

Molecule molecule_in_frame(std::string name, std::vector<Site> sites) {
  return build(std::move(name), std::move(sites), axes_of_frame);
}

}  // namespace polhode
