// SPDX-License-Identifier: MIT
// The values of properties from the replicas of a state point.
#pragma once

#include <vector>

#include "polhode/run/properties/measure.hpp"
#include "run/properties/contributions.hpp"

namespace polhode {

/// Estimates a property with its error. The error is not known until there is enough data.
MeasuredProperty estimate(const RequestedProperty& request, const PointData& data);

/// The conditions, lengths, steps and curves of a state point, without its properties.
MeasuredPoint described(const PointData& data);

/// Estimates a diffusion coefficient or the viscosity from the dynamics in the long box of
/// OrthoBoXY: D0 = (Dx + Dy)/2, and the viscosity is proportional to 1/(Dx + Dy − 2 Dz)
/// [busch2023].
void estimate_orthoboxy(MeasuredProperty& m, const Contributions& contributions,
                        const PointData& data);
/// Estimates the thermal conductivity by the Green-Kubo relation: the spectrum of the heat flux J
/// at zero frequency is twice the integral of its autocorrelation function, so λ = V S(0)/(2 k T²)
/// [evans1989].
void estimate_conduction(MeasuredProperty& m, const Contributions& contributions,
                         const PointData& data);
/// The thermal conductivity [W/(m K)] per spectrum of the heat flux times the root of the volume.
double conductivity_per_spectrum(double temperature);
/// Estimates the residual chemical potential from the stages of a coupling: the free energy of the
/// last stage minus that of the first one, by acceptance ratios between neighbouring stages
/// [bennett1976]. Also estimates the pressure of the vapour with the same chemical potential, with
/// the second virial coefficient.
void estimate_coupling(MeasuredProperty& m, const Contributions& contributions,
                       const PointData& data);
/// Estimates the surface tension, or the densities or the pressure of liquid and vapour in
/// coexistence, from the slabs of the replicas.
void estimate_slab(MeasuredProperty& m, const Contributions& contributions, const PointData& data);
/// Functions of the distance from the middle of the slab: the density, the normal minus the
/// tangential pressure, and its integral from the middle, which ends at the surface tension. The
/// pressures are missing for mixtures, and all of them without a slab.
std::vector<MeasuredCurve> slab_profiles(const PointData& data);

/// Estimates of the property from increasing parts of the data.
std::vector<SeriesEstimate> stages_of(const RequestedProperty& request, const PointData& data);

}  // namespace polhode
