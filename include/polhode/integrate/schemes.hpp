// SPDX-License-Identifier: MIT
// The splitting schemes, one line each. A(a) is e^{aAh}, the exact drift; B(b, ξ) is e^{bB̂(ξ)h},
// the kick. A line lists the first half of the palindrome up to and including the middle stage.
#pragma once

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// The value of η that minimizes α² + β², where α and β are the prefactors of the O(h²) error
/// [omelyan2003]. The value is η = 1/2 − c/12 + 1/(6c) with c = (2 √326 + 36)^{1/3}. The scheme
/// with this η is also in [mclachlan1995].
inline constexpr double eta = 0.1931833275037836;

/// The fraction θ = 1/(2 − 2^{1/3}) [forest1990].
inline constexpr double theta = 1.3512071919596578;

/// The fraction p = 1/(4 − 4^{1/3}) of the first two and the last two of five Verlet steps
/// [suzuki1990].
inline constexpr double suzuki = 0.4144907717943757;

/// Weights w₃, w₂, w₁ of the first three of seven Verlet steps: solution A of [yoshida1990].
inline constexpr double yoshida[] = {0.7845136104775572638, 0.2355732133593581337,
                                     -1.1776799841788710069};

/// Coefficients β₁, α₁ and β₂ of five pairs of a first-order step and its adjoint [mclachlan1995],
/// with √19 = 4.3588989435406735522.
inline constexpr double mclachlan[] = {(14 - 4.3588989435406735522) / 108,
                                       (146 + 5 * 4.3588989435406735522) / 540,
                                       (-23 - 20 * 4.3588989435406735522) / 270};

/// The fraction 1/√3 of Chin's scheme B [chin1997].
inline constexpr double inverse_root_3 = 0.5773502691896257645;

/// Fraction of the outer kick that minimizes the energy error over all harmonic oscillators with ω
/// h < 2 [blanes2014, section 6]. The paper gives five digits of this fraction.
inline constexpr double oscillator_kick = 0.21178097959263092;

/// Fraction of the outer kicks around one gradient kick [omelyan2003].
inline constexpr double omelyan_kick = 0.2470939580390842;

// clang-format off
inline constexpr std::array schemes = {
    //     name             order  first half, then the middle                                source
    Scheme{"position-verlet", 2, {A(0.5),       B(1)},                                        "verlet1967"},
    Scheme{"velocity-verlet", 2, {B(0.5),       A(1)},                                        "swope1982"},
    Scheme{"hoa2",            2, {B(eta),       A(0.5),   B(1 - 2 * eta)},                    "omelyan2003"},
    Scheme{"gier4",           4, {B(1.0 / 6),   A(0.5),   B(2.0 / 3, 1.0 / 48)},              "omelyan2007"},
    Scheme{"gier4-fd",        4, {B(1.0 / 6),   A(0.5),   B(2.0 / 3, 1.0 / 48, Gradient::finite_difference)}, "vanzon2008"},
    // schemes of effective order 4: the O(h²) error vanishes in states that are read through a postprocessor
    Scheme{"takahashi-imada", 2, {A(0.5), B(1, 1.0 / 24)},                                    "takahashi1984"},
    Scheme{"takahashi-imada-fd", 2, {A(0.5), B(1, 1.0 / 24, Gradient::finite_difference)},    "takahashi1984"},
    // schemes of order 2, for large steps
    Scheme{"bcss2",           2, {B(oscillator_kick), A(0.5), B(rest)},                                 "blanes2014"},
    Scheme{"bcss3",           2, {B(0.11888010966548), A(0.29619504261126), B(rest), A(rest)}, "blanes2014"},
    Scheme{"bcss4",           2, {B(0.071353913450279726), A(0.1916678), B(0.26854879116123011), A(rest), B(rest)}, "blanes2014"},
    // compositions of Verlet steps
    Scheme{"forest-ruth",     4, {A(theta / 2), B(theta), A((1 - theta) / 2), B(1 - 2 * theta)}, "forest1990"},
    Scheme{"suzuki4",         4, {B(suzuki / 2), A(suzuki), B(suzuki), A(suzuki), B(rest), A(rest)}, "suzuki1990"},
    Scheme{"mclachlan4",      4, {B(mclachlan[0]), A(mclachlan[0] + mclachlan[1]), B(mclachlan[1] + mclachlan[2]), A(rest), B(rest), A(0.4)}, "mclachlan1995"},
    Scheme{"yoshida6",        6, {B(yoshida[0] / 2), A(yoshida[0]), B((yoshida[0] + yoshida[1]) / 2), A(yoshida[1]), B((yoshida[1] + yoshida[2]) / 2), A(yoshida[2]), B(rest), A(rest)}, "yoshida1990"},
    // schemes with more stages than their order requires, which makes the error smaller
    Scheme{"pefrl",           4, {A(0.1786178958448091), B(rest), A(-0.06626458266981849), B(-0.2123418310626054), A(rest)}, "omelyan2002"},
    Scheme{"vefrl",           4, {B(0.1644986515575760), A(rest), B(1.235692651138917), A(-0.02094333910398989), B(rest)}, "omelyan2002"},
    Scheme{"4mn5fv",          4, {B(0.08398315262876693), A(0.2539785108410595), B(0.6822365335719091), A(-0.03230286765269967), B(rest), A(rest)}, "omelyan2003"},
    Scheme{"4mn5fp",          4, {A(0.2750081212332419), B(-0.08442961950707149), A(-0.1347950099106792), B(0.3549000571574260), A(rest), B(rest)}, "omelyan2003"},
    Scheme{"blanes-moan4",    4, {B(0.0792036964311957), A(0.209515106613362), B(0.353172906049774), A(-0.143851773179818), B(-0.0420650803577195), A(rest), B(rest)}, "blanes2002"},
    // schemes of Runge-Kutta-Nyström type, which assume {V,{V,{V,T}}} = 0
    Scheme{"srkn6-4",         4, {B(0.0829844064174052), A(0.245298957184271), B(0.396309801498368), A(0.604872665711080), B(-0.0390563049223486), A(rest), B(rest)}, "blanes2002"},
    Scheme{"srkn11-6",        6, {B(0.0414649985182624), A(0.123229775946271), B(0.198128671918067), A(0.290553797799558), B(-0.0400061921041533), A(-0.127049212625417), B(0.0752539843015807), A(-0.246331761062075), B(-0.0115113874206879), A(0.357208872795928), B(rest), A(rest)}, "blanes2002"},
    Scheme{"srkn14-6",        6, {A(0.0378593198406116), B(0.09171915262446165), A(0.102635633102435), B(0.183983170005006), A(-0.0258678882665587), B(-0.05653436583288827), A(0.314241403071447), B(0.004914688774712854), A(-0.130144459517415), B(0.143761127168358), A(0.106417700369543), B(0.328567693746804), A(-0.00879424312851058), B(rest), A(rest)}, "blanes2002"},
    // schemes with gradient kicks, where all drifts and kicks are forward in time
    Scheme{"chin-4b",         4, {A(rest), B(0.5, (2 - 3 * inverse_root_3) / 24), A(inverse_root_3)}, "chin1997"},
    Scheme{"chin-4c",         4, {A(1.0 / 6),   B(3.0 / 8), A(1.0 / 3), B(1.0 / 4, 1.0 / 48)}, "chin1997"},
    Scheme{"4mn3f1gp",        4, {A(0.08935804763220157), B(omelyan_kick), A(rest), B(rest, 0.006938106540706989 / (1 - 2 * omelyan_kick))}, "omelyan2003"},
};
// clang-format on

}  // namespace polhode
