// SPDX-License-Identifier: MIT
// The splitting schemes, one line each. A(a) is e^{aAh}, the exact drift; B(b, ξ) is e^{bB̂(ξ)h},
// the kick. A line holds the first half of the palindrome up to and including its middle stage.
#pragma once

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// η of least α² + β², the prefactors of the O(h²) error [omelyan2003]: 1/2 − c/12 + 1/(6c) with
/// c = (2 √326 + 36)^{1/3}.
inline constexpr double eta = 0.1931833275037836;

/// θ = 1/(2 − 2^{1/3}) [forest1990].
inline constexpr double theta = 1.3512071919596578;

// clang-format off
inline constexpr std::array schemes = {
    //     name             order  first half, then the middle                                source
    Scheme{"position-verlet", 2, {A(0.5),       B(1)},                                        "verlet1967"},
    Scheme{"velocity-verlet", 2, {B(0.5),       A(1)},                                        "swope1982"},
    Scheme{"hoa2",            2, {B(eta),       A(0.5),   B(1 - 2 * eta)},                    "omelyan2003"},
    Scheme{"gier4",           4, {B(1.0 / 6),   A(0.5),   B(2.0 / 3, 1.0 / 48)},              "omelyan2007"},
    Scheme{"gier4-fd",        4, {B(1.0 / 6),   A(0.5),   B(2.0 / 3, 1.0 / 48, Gradient::finite_difference)}, "vanzon2008"},
    Scheme{"forest-ruth",     4, {A(theta / 2), B(theta), A((1 - theta) / 2), B(1 - 2 * theta)}, "forest1990"},
};
// clang-format on

}  // namespace polhode
