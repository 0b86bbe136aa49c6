// SPDX-License-Identifier: MIT
// Upper bounds on the performance of a core: independent multiply-adds, and pairs of four-site
// waters. The partners are in the first-level cache, and all lanes are in use. Force evaluations
// are compared with these upper bounds.
#pragma once

#include <cstddef>
#include <vector>

#include "base/instruction_set.hpp"
#include "forces/laws/setting_names.hpp"
#include "forces/pairs/pair_table.hpp"

namespace polhode {

/// The timing of a repeated measurement. Disturbances by other programs only add time, so the
/// minimum is the undisturbed time. The median shows how large the disturbances were.
struct Timing {
  double best = 0, median = 0;
  double spread() const { return best > 0 ? median / best - 1 : 0; }
};
Timing timing(std::vector<double> repeats);

/// Time per pair of molecules [ns].
struct BarePair {
  Timing inside;     ///< time of a pair inside the switching distance
  Timing truncated;  ///< time of a pair within the switching range of the molecule switch
};

struct Limit {
  Precision precision = Precision::double_precision;
  std::size_t lanes = 0;     ///< number of pairs in a pack
  double multiply_adds = 0;  ///< number of multiply-adds per ns
  BarePair forces, energies;
  /// The computing time of given numbers of pairs on one core [s].
  double seconds(std::size_t inside, std::size_t truncated, bool with_energies) const;
};

/// The force settings of the benchmark: a cutoff of 0.9 nm and a reaction field.
ForceSettings benchmark_forces(Precision precision, double switch_from);

/// Measures the peak performance for a given time [s].
Limit measure_limit(Precision precision, double seconds);

POLHODE_DECLARE_LOOPS(
    /// The number of lanes in a pack.
    std::size_t pack_width(const double*); std::size_t pack_width(const float*);
    /// Performs twelve chains of multiply-adds, each `rounds` long, on the first twelve packs of
    /// `numbers`.
    void bare_multiply_adds(std::size_t rounds, double* numbers);
    void bare_multiply_adds(std::size_t rounds, float* numbers);
    /// Computes the pairs of a four-site molecule with `packs` packs of partners.
    /// @param own       x, y, z of the four sites of the molecule relative to its centre [nm]
    /// @param partners  16 columns per pack: the difference of the centres, four sites, one unused
    /// @param out       6 columns per pack: force and torque; `out` must have room for at least
    ///   twelve columns
    void bare_pairs(const PairTable& table, const PairLaws<double>& laws, bool truncated,
                    bool energies, const double* own, const double* partners, std::size_t packs,
                    double* out);
    void bare_pairs(const PairTable& table, const PairLaws<float>& laws, bool truncated,
                    bool energies, const float* own, const float* partners, std::size_t packs,
                    float* out);)

}  // namespace polhode
