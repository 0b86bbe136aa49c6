// SPDX-License-Identifier: MIT
#include "integrate/postprocessor.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

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
    -1.0 / 16, stages({B(0.3324649441624619), A(0.4870521493797447), B(0.1959064687183469),
                       A(-0.1927647029207435), B(-0.5366068738805916), A(-0.29428744645900123),
                       B(0.008235460999782784)})};

// The prefactors are -1/24 and 1/24, so c = 1/24 removes the O(h²) error.
constexpr Postprocessor of_takahashi_imada{
    1.0 / 24, stages({B(0.04516024765005094), A(-0.3161368829070789), B(-0.2293310395586735),
                      A(-0.4272120039296066), B(0.04147895272227208), A(0.7433488868366855),
                      B(0.14269183918635048)})};

constexpr Postprocessor of_gier4{
    0, stages({A(0.02941249880167372), B(-0.147590398217303), A(-0.1499342814434021),
               B(0.06984669673008086), A(0.4193429688377945), B(0.1475903982184961),
               A(0.1499342814411444), B(-0.06984669673127396), A(-0.4487554676372105)})};

struct Known {
  std::string_view scheme;
  const Postprocessor& postprocessor;
};
constexpr Known known[] = {{"velocity-verlet", of_velocity_verlet},
                           {"takahashi-imada", of_takahashi_imada},
                           {"takahashi-imada-fd", of_takahashi_imada},
                           {"gier4", of_gier4},
                           {"gier4-fd", of_gier4}};

std::vector<Stage> without_baths(const Scheme& scheme) {
  std::vector<Stage> stages;
  std::copy_if(scheme.stages().begin(), scheme.stages().end(), std::back_inserter(stages),
               [](const Stage& stage) { return stage.flow != Flow::bath; });
  return stages;
}

}  // namespace

const Postprocessor* postprocessor_of(const Scheme& scheme) {
  if (scheme.bath_within()) return nullptr;
  for (const auto& [name, postprocessor] : known)
    if (without_baths(scheme) == without_baths(scheme_of(name))) return &postprocessor;
  return nullptr;
}

}  // namespace polhode
