// SPDX-License-Identifier: MIT
// What one core can do at best: multiply-adds that wait for nothing, and pairs of four-site waters
// whose partners stand ready in the first-level cache, every lane used. A force evaluation is held
// against these.
#pragma once

#include <cstddef>
#include <vector>

#include "polhode/base/target.hpp"
#include "polhode/forces/pair_table.hpp"
#include "polhode/forces/settings.hpp"

namespace polhode {

/// Repeats of one measurement. What disturbs a computer only adds time, so the best is the time
/// itself, and the median tells how much there was to disturb it.
struct Timing {
  double best = 0, median = 0;
  double spread() const { return best > 0 ? median / best - 1 : 0; }
  /// The same in another unit.
  Timing operator*(double factor) const { return {factor * best, factor * median}; }
};
Timing timing(std::vector<double> repeats);

/// Time of a pair of molecules [ns].
struct BarePair {
  Timing whole;   ///< closer than where the switch begins
  Timing ending;  ///< within the molecule switch
};

struct Limit {
  Precision precision = Precision::full;
  std::size_t lanes = 0;     ///< pairs in a pack
  double multiply_adds = 0;  ///< per ns
  BarePair forces, energies;
  /// What so many pairs take on one core [s].
  double seconds(std::size_t whole, std::size_t ending, bool with_energies) const;
};

/// The settings of the benchmark: cutoff 0.9 nm, reaction field.
ForceSettings benchmark_forces(Precision precision, double switch_from);

/// Measures for so long [s].
Limit measured_limit(Precision precision, double seconds);

POLHODE_DECLARE_LOOPS(
    /// How many numbers a pack has.
    std::size_t pack_width(const double*); std::size_t pack_width(const float*);
    /// Twelve chains of multiply-adds, `rounds` long, from and to the first twelve packs of
    /// `numbers`.
    void bare_multiply_adds(std::size_t rounds, double* numbers);
    void bare_multiply_adds(std::size_t rounds, float* numbers);
    /// One four-site molecule with `packs` packs of partners.
    /// @param own       x, y, z of its four sites relative to its centre [nm]
    /// @param partners  of each pack 16 columns: the difference of the centres, four sites, none
    /// @param out       of each pack 6 columns: force and torque; room for twelve at least
    void bare_pairs(const PairTable& table, const PairLaws<double>& laws, bool ending,
                    bool energies, const double* own, const double* partners, std::size_t packs,
                    double* out);
    void bare_pairs(const PairTable& table, const PairLaws<float>& laws, bool ending, bool energies,
                    const float* own, const float* partners, std::size_t packs, float* out);)

}  // namespace polhode
