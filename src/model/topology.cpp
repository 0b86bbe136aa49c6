// SPDX-License-Identifier: MIT
#include "polhode/model/topology.hpp"

#include <algorithm>

#include "polhode/model/degrees_of_freedom.hpp"

namespace polhode {

std::size_t Topology::size() const {
  std::size_t n = 0;
  for (const Part& part : parts) n += part.count;
  return n;
}

double Topology::mass() const {
  double m = 0;
  for (const Part& part : parts) m += static_cast<double>(part.count) * part.molecule.mass;
  return m;
}

double Topology::extent() const {
  double far = 0;
  for (const Part& part : parts) far = std::max(far, part.molecule.extent());
  return far;
}

Bodies::Bodies(const Topology& topology)
    : m(topology.size(), 1.0),
      inverse_m(topology.size(), 1.0),
      J(topology.size(), {1.0, 1.0, 1.0}),
      inverse_J(topology.size(), {1.0, 1.0, 1.0}) {
  const auto inverse = [](double moment) { return moment > 0 ? 1 / moment : 0.0; };
  part.reserve(topology.size());
  for (std::size_t k = 0; k < topology.parts.size(); ++k) {
    const Molecule& molecule = topology.parts[k].molecule;
    for (std::size_t copy = 0; copy < topology.parts[k].count; ++copy) {
      const std::size_t i = part.size();
      m[i] = molecule.mass;
      inverse_m[i] = 1 / molecule.mass;
      J.set(i, molecule.J);
      inverse_J.set(i, {inverse(molecule.J.x), inverse(molecule.J.y), inverse(molecule.J.z)});
      part.push_back(k);
    }
  }
}

DegreesOfFreedom degrees_of_freedom(const Topology& topology, TotalMomentum total_momentum) {
  DegreesOfFreedom n;
  const double held = total_momentum == TotalMomentum::held ? 3 : 0;
  n.translation = std::max(0.0, 3 * static_cast<double>(topology.size()) - held);
  for (const auto& part : topology.parts)
    for (std::size_t k = 0; k < 3; ++k)
      if (part.molecule.J[k] > 0) n.rotation[k] += static_cast<double>(part.count);
  return n;
}

}  // namespace polhode
