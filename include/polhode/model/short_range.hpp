// SPDX-License-Identifier: MIT
// The short-range potentials ("laws" in files) that a site can have, with parameters as in molecule
// files. The formulas are in forces/laws.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace polhode {

/// The Lennard-Jones potential u = 4 ε ((σ/r)¹² − (σ/r)⁶), with σ and ε of the site.
struct LennardJonesLaw {
  bool operator==(const LennardJonesLaw&) const = default;
};

/// The Mie potential u = C ε ((σ/r)ⁿ − (σ/r)ᵐ), with σ and ε of the site.
struct MieLaw {
  double n = 12, m = 6;  ///< repulsive and attractive exponent
  bool operator==(const MieLaw&) const = default;
};

/// The Buckingham potential u = A exp(−B r) − C/r⁶.
struct BuckinghamLaw {
  double A = 0;  ///< [kJ/mol]
  double B = 0;  ///< [1/nm]
  double C = 0;  ///< [kJ/mol nm⁶]
  bool operator==(const BuckinghamLaw&) const = default;
};

/// A potential given by energies at equally spaced r, interpolated by a cubic spline. The first two
/// derivatives of the spline are continuous. The third derivative is bounded, but jumps at each
/// tabulated distance.
class PotentialTable {
 public:
  /// @param name   name of the table file
  /// @param first  first distance r [nm]
  /// @param u      energies [kJ/mol], at least 4 numbers
  /// @param f      forces −u' at the same r [kJ/mol/nm]. The first and last forces are the slopes
  ///   of the spline at its ends. All other forces are compared with the spline.
  /// @throws Error  if a force differs from the spline by more than 1 %
  PotentialTable(std::string name, double first, double spacing, const std::vector<double>& u,
                 const std::vector<double>& f);

  const std::string& name() const { return name_; }
  double first() const { return first_; }
  double spacing() const { return spacing_; }
  std::size_t intervals() const { return exact_.size() / 4; }
  double last() const { return first_ + static_cast<double>(intervals()) * spacing_; }
  /// Coefficients of 1, x, x², x³ in each interval, with x from 0 to 1 within the interval.
  template <class T>
  const T* coefficients() const {
    if constexpr (sizeof(T) == 8)
      return exact_.data();
    else
      return rounded_.data();
  }
  bool operator==(const PotentialTable&) const = default;

 private:
  std::string name_;
  double first_, spacing_;
  std::vector<double> exact_;
  std::vector<float> rounded_;
};

/// A potential that is given by a table. Two such potentials are equal if their tables are equal.
struct TabulatedLaw {
  std::shared_ptr<const PotentialTable> table;
  bool operator==(const TabulatedLaw& other) const { return *table == *other.table; }
};

using ShortRangeLaw = std::variant<LennardJonesLaw, MieLaw, BuckinghamLaw, TabulatedLaw>;

/// The rule that gives σ and ε of two different sites.
enum class MixingRule {
  lorentz_berthelot,  ///< arithmetic mean of σ, geometric mean of ε
  geometric,          ///< geometric means of σ and ε
};

/// Whether the short-range potential of a site or pair is zero everywhere.
inline bool is_zero(double epsilon, const ShortRangeLaw& law) {
  return epsilon == 0 &&
         (std::holds_alternative<LennardJonesLaw>(law) || std::holds_alternative<MieLaw>(law));
}

/// The name of a potential: "lennard-jones", "mie", "buckingham" or "tabulated".
const char* name(const ShortRangeLaw& law);
/// The parameters of a potential as text, such as "sigma 0.33 nm, epsilon 0.8 kJ/mol".
std::string parameters(double sigma, double epsilon, const ShortRangeLaw& law);

/// Checks the parameters of a short-range potential.
/// @throws Error  if a parameter is not finite or out of its domain, or if the potential has no
///   repulsion at short range
void check(double sigma, double epsilon, const ShortRangeLaw& law);

}  // namespace polhode
