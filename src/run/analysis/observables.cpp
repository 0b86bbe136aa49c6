// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/observable.hpp"

namespace polhode {

// Each observable is defined in the file of the same name.
ObservableKind rdf(), msd(), rotation(), velocity(), dielectric(), density();

const std::vector<ObservableKind>& observables() {
  static const std::vector<ObservableKind> all = {rdf(),      msd(),        rotation(),
                                                  velocity(), dielectric(), density()};
  return all;
}

}  // namespace polhode
