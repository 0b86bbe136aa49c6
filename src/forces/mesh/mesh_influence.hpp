// SPDX-License-Identifier: MIT
// The influence function: the factor of each Fourier coefficient of the mesh.
#pragma once

#include <array>
#include <vector>

#include "forces/laws/ewald_split.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

struct InfluenceValue {
  double factor;  ///< G: E = ½ Σ G |S|² [kJ/mol/e²]
  double slope;  ///< H: −dE/dε = ½ Σ |S|² (G + H k ⊗ k) for a strain that moves the charges with it
};

/// If forces are the gradient of the energy, their mean square error is smallest for the factor
/// [ballenegger2012]
///   G = Σ U² k² γ / (Σ U² · Σ U² k²),
/// with sums over k and its aliases, U(k) the transform of the assignment function, and γ the
/// desired energy 4 π K ρ(k)/(k² V). U depends on the grid alone, so the volume derivative of G is
/// that of ρ and k², and the trace of the virial is as exact as the forces.
class Influence {
 public:
  Influence(const MeshSettings& settings, const Box& box);

  /// Wave number of index n along an edge [1/nm]; indices above half the points are negative:
  /// n − points.
  double k(std::size_t d, std::size_t n) const { return axes_[d][n].k; }
  InfluenceValue operator()(const std::array<std::size_t, 3>& n) const;

 private:
  struct Alias {
    double k;
    double share;  // U²
  };
  struct Wave {
    double k;
    std::array<Alias, 2> near;  // itself and the alias with the next largest share
    double all, all_k2;         // Σ U² and Σ U² k² over all aliases
  };
  CompactSplit split_;
  double volume_;
  std::array<std::vector<Wave>, 3> axes_;
};

/// The influence of all waves of a mesh. It depends neither on the signs of a wave's numbers nor,
/// in a cube, on their order: computed once for each set of sizes, because a barostat needs it
/// again for every box.
class InfluenceTable {
 public:
  InfluenceTable(const Influence& influence, const std::array<std::size_t, 3>& points,
                 const Box& box, Workers& workers);
  InfluenceValue operator()(std::array<std::size_t, 3> n) const;

 private:
  std::size_t half(std::size_t d) const { return points_[d] / 2 + 1; }
  std::size_t place(const std::array<std::size_t, 3>& n) const {
    return (n[0] * half(1) + n[1]) * half(2) + n[2];
  }

  std::array<std::size_t, 3> points_;
  bool cubic_;
  std::vector<InfluenceValue> values_;
};

}  // namespace polhode
