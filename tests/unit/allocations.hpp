// SPDX-License-Identifier: MIT
// How often this program has allocated memory.
#pragma once

namespace polhode {

/// Calls of operator new and malloc so far.
long allocations();

/// Those during an action.
template <class Action>
long allocations_of(Action action) {
  const long before = allocations();
  action();
  return allocations() - before;
}

}  // namespace polhode
