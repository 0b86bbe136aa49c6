// SPDX-License-Identifier: MIT
#include "integrate/postprocessor.hpp"

#include <algorithm>

#include "polhode/integrate/scheme_text.hpp"

namespace polhode {
namespace {

template <std::size_t n>
constexpr Scheme stages(const Stage (&stages)[n]) {
  return Scheme(std::span<const Stage>(stages, n), 0);
}

// The term of order h⁴ in ln P removes as much of the scheme's error of order h⁴ as possible: of
// all postprocessors with the same c, P K P⁻¹ has the smallest sum of squared coefficients of
// commutators of degree 5. studies/postprocessors.py computes the stages.

// With c = -1/16 both prefactors of the O(h²) error are 1/48. In a harmonic system, an error with
// equal prefactors is constant, so the energy does not fluctuate.
constexpr Postprocessor of_velocity_verlet{
    -1.0 / 16, stages({B(0.3324649441442007), A(0.487052149426048), B(0.19590646874647172),
                       A(-0.19276470291127537), B(-0.5366068738562686), A(-0.2942874465147727),
                       B(0.00823546096559613)})};

// The prefactors are -1/24 and 1/24, so c = 1/24 removes the O(h²) error.
constexpr Postprocessor of_takahashi_imada{
    1.0 / 24, stages({B(0.04516024867833297), A(-0.3161368811522107), B(-0.229331038509473),
                      A(-0.4272120117300132), B(0.041478951397322994), A(0.7433488928822239),
                      B(0.14269183843381705)})};

constexpr Postprocessor of_gier4{
    0, stages({A(0.02941249880167372), B(-0.147590398217303), A(-0.14993427227154174),
               B(0.06984670062117769), A(0.4193429716778444), B(0.14759039821730316),
               A(0.14993427227154132), B(-0.06984670062117786), A(-0.4487554704795177)})};

struct Known {
  std::string_view scheme;
  const Postprocessor& postprocessor;
};
constexpr Known known[] = {{"velocity-verlet", of_velocity_verlet},
                           {"takahashi-imada", of_takahashi_imada},
                           {"takahashi-imada-fd", of_takahashi_imada},
                           {"gier4", of_gier4},
                           {"gier4-fd", of_gier4}};

}  // namespace

const Postprocessor* postprocessor_of(const Scheme& scheme) {
  for (const auto& [name, postprocessor] : known) {
    const Scheme of = scheme_of(name);
    if (std::ranges::equal(scheme.stages(), of.stages())) return &postprocessor;
  }
  return nullptr;
}

}  // namespace polhode
