// SPDX-License-Identifier: MIT
// Values of properties from records of replicas that are made up here, so that each value is known.
#include "run/properties/estimates.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "io/settings/quantity.hpp"
#include "measure/displacement.hpp"
#include "measure/finite_size.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "run/properties/low_frequency_spectrum.hpp"
#include "run/properties/property.hpp"
#include "run/properties/replica.hpp"

using namespace polhode;

namespace {

// SI, by CODATA 2018, independent of the units of the program.
constexpr double k_B = 1.380649e-23, N_A = 6.02214076e23, e = 1.602176634e-19,
                 eps0 = 8.8541878128e-12, u = 1e-3 / N_A, nm = 1e-9, ps = 1e-12, kJ_mol = 1e3 / N_A;
constexpr double pi = 3.14159265358979323846;
constexpr double bar = 1e5 * nm * nm * nm / kJ_mol;  // [kJ/mol/nm³]

constexpr double T = 300, p_bar = 200;
constexpr StatePoint at{T, p_bar* bar};
constexpr std::size_t waters = 100;

const Topology& water() {
  static const Topology topology{{{read_molecule("spce"), waters}}};
  return topology;
}

/// Potential energy [kJ/mol], volume [nm³] and square of the dipole [e² nm²] of one sample.
struct Sample {
  double U, V, M2;
};
/// Two values of U and of V with a covariance.
constexpr std::array samples = {Sample{-4200, 3.01, 4}, Sample{-4100, 3.05, 1},
                                Sample{-4150, 3.05, 3}, Sample{-4110, 3.01, 2}};
constexpr std::size_t segments_of_averages = 24;

/// What is added to the potential energies of a segment: noise between segments.
double offset(std::size_t segment) { return 5 * Random(3, segment).normal(); }

/// A mean over the samples of all segments.
double mean(const std::function<double(const Sample&)>& f) {
  double sum = 0;
  for (std::size_t k = 0; k < segments_of_averages; ++k)
    for (Sample s : samples) {
      s.U += offset(k);
      sum += f(s);
    }
  return sum / static_cast<double>(segments_of_averages * samples.size());
}

/// The error of the step of each of the samples [kJ/mol].
using StepErrors = std::array<double, 4>;

/// The constant volume [nm³], and the pressures of the samples at this volume [kJ/mol/nm³].
constexpr double fixed_volume = 3.03;
constexpr std::array pressures = {10.0, 14.0, 13.0, 16.0};

AveragesSegment segment_with(double offset, const StepErrors& errors, bool constant_volume) {
  const std::size_t count = constant_volume ? averages_count_at_constant_volume : averages_count;
  AveragesSegment segment{.sums = {0, std::vector<double>(count)}, .response = {}};
  for (const double sign : {1.0, -1.0})  // the kinetic energy is uncorrelated with all others
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const double U = samples[k].U + offset, V = constant_volume ? fixed_volume : samples[k].V;
      std::vector<double> x = {
          U, V, U * U, V * V, U * V, samples[k].M2, pressures[k] * (1 + offset / 100)};
      x.resize(count);
      segment.sums.weight += 1;
      for (std::size_t i = 0; i < x.size(); ++i) segment.sums.sum[i] += x[i];
      const double kinetic = 3 * waters * units::boltzmann * T + sign * 10;
      segment.response.add({errors[k], U + kinetic, kinetic, at.pressure, V}, x);
    }
  segment.response.blocks = {{segment.response.blocks.means().sum()}, 1};
  for (const double fluctuation : {1, -1, 2, -2, 0}) {  // in equilibrium from the beginning
    segment.potentials.push_back(-4140 + fluctuation);
    segment.volumes.push_back(constant_volume ? fixed_volume : 3 + fluctuation / 64);
  }
  return segment;
}

Replica steady(std::uint64_t index, const StepErrors& errors = {}, bool constant_volume = false) {
  Replica replica{.index = index, .step = 0.004, .state = State{1, Box{Vec3<double>{2, 2, 2}}}};
  for (std::size_t k = 0; k < segments_of_averages; ++k) {
    replica.averages.push_back(segment_with(offset(k), errors, constant_volume));
    if (k == 0) continue;
    StepResponse& response = replica.averages.back().response;
    response = response.relative_to(replica.averages.front().response.first);
  }
  return replica;
}

std::vector<Replica> four(const std::function<Replica(std::uint64_t)>& make) {
  return {make(0), make(1), make(2), make(3)};
}

MeasuredProperty measured(const char* name, const std::vector<Replica>& replicas,
                          const Topology& topology = water(), const StatePoint& point = at) {
  const Mixing mixing;
  return estimate({&property(name)}, {topology, mixing, point, replicas});
}

}  // namespace

TEST_CASE("properties of averages are those computed by hand in SI units") {
  const std::vector<Replica> replicas =
      four([](std::uint64_t k) { return steady(k, StepErrors{}); });
  const double mass = waters * (15.9994 + 2 * 1.008) * u;            // [kg]
  const double U = mean([](auto s) { return s.U; }) * kJ_mol;        // [J]
  const double V = mean([](auto s) { return s.V; }) * nm * nm * nm;  // [m³]
  const double p = p_bar * 1e5, n = waters / N_A, kT = k_B * T, K = 6.0 * waters / 2 * kT;
  const auto H = [&](const Sample& s) { return s.U * kJ_mol + p * s.V * nm * nm * nm; };
  const auto deviation = [&](const Sample& s) { return s.V * nm * nm * nm - V; };
  const double H_mean = mean(H), VV = mean([&](auto s) { return std::pow(deviation(s), 2); }),
               HV = mean([&](auto s) { return deviation(s) * (H(s) - H_mean); }),
               HH = mean([&](auto s) { return std::pow(H(s) - H_mean, 2); });
  const double M2 = mean([](auto s) { return s.M2; }) * std::pow(e * nm, 2);  // [C² m²]
  struct Case {
    const char* name;
    double value;
  };
  for (const auto& [name, value] :
       {Case{"density", mass / V}, Case{"molar-volume", V / n * 1e6},
        Case{"potential-energy", U / n / 1e3}, Case{"enthalpy", (H_mean + K) / n / 1e3},
        // The ideal gas has the same kinetic energy, and pV = kT for each molecule.
        Case{"enthalpy-of-vaporization", (kT * waters - H_mean) / n / 1e3},
        // The kinetic energy of a canonical ensemble adds k/2 for each degree of freedom.
        Case{"heat-capacity", (HH / (kT * T) + K / T) / n},
        Case{"expansivity", HV / (kT * T * V) * 1e6},
        Case{"compressibility", VV / (kT * V) * 1e5 * 1e6},
        Case{"dielectric-constant", 1 + M2 / (3 * eps0 * V * kT)}}) {
    CAPTURE(name);
    const MeasuredProperty m = measured(name, replicas);
    REQUIRE(m.value.known == Known::yes);
    // Squares of U lose log10(U²/var U) = 4 of 16 digits; masses and constants have 10.
    CHECK(m.value.value == doctest::Approx(value).epsilon(1e-9));
    CHECK(m.value.error < 0.1 * std::abs(value));
    CHECK(m.obstacle.empty());
    REQUIRE(m.bias);
    CHECK(m.bias->value == 0);
  }
}

TEST_CASE("properties at constant volume are those computed by hand in SI units") {
  const StatePoint point{T, std::nan(""), water().mass() / fixed_volume};
  const StepErrors errors = {-1, 1, -1, 1};
  const std::vector<Replica> replicas =
      four([&](std::uint64_t k) { return steady(k, errors, true); });
  const double U = mean([](auto s) { return s.U; }), n = waters / N_A;
  const double UU = mean([&](auto s) { return std::pow((s.U - U) * kJ_mol, 2); });
  double noise = 0;  // of the factor of all pressures
  for (std::size_t k = 0; k < segments_of_averages; ++k)
    noise += offset(k) / 100 / segments_of_averages;
  const double kT = k_B * T;
  // The pressure of a run, whose kinetic part lacks one of N molecules, and that of this molecule.
  const double p = (10.0 + 14 + 13 + 16) / 4 * (1 + noise) * kJ_mol / (nm * nm * nm) +
                   kT / (fixed_volume * nm * nm * nm);  // [Pa]
  const double K = 6.0 * waters / 2 * kT;
  struct Case {
    const char* name;
    double value;
  };
  for (const auto& [name, value] :
       {Case{"pressure", p / 1e5}, Case{"isochoric-heat-capacity", (UU / (kT * T) + K / T) / n},
        Case{"enthalpy", (U * kJ_mol + K + p * fixed_volume * nm * nm * nm) / n / 1e3}}) {
    CAPTURE(std::string(name));
    const MeasuredProperty m = measured(name, replicas, water(), point);
    REQUIRE(m.value.known == Known::yes);
    const double bias = m.bias ? m.bias->value : 0;
    CHECK(m.value.value + bias == doctest::Approx(value).epsilon(1e-9));
    CHECK(m.obstacle.empty());
  }
  // The bias of the pressure is its covariance with the error of the step over −kT. The kinetic
  // energy gives kT to 0.5 %.
  const double covariance = (-10.0 + 14 - 13 + 16) / 4 * (1 + noise) * kJ_mol / (nm * nm * nm);
  CHECK(measured("pressure", replicas, water(), point).bias->value ==
        doctest::Approx(-covariance * kJ_mol / kT / 1e5).epsilon(0.006));
}

TEST_CASE("the time-step bias is subtracted") {
  // States with a higher shadow energy are less probable: an error of the step that is larger where
  // U is larger lowers ⟨U⟩ by its covariance with U over kT.
  const StepErrors errors = {-1, 1, -1, 1};
  const std::vector<Replica> replicas = four([&](std::uint64_t k) { return steady(k, errors); });
  const double kT = units::boltzmann * T, U = mean([](auto s) { return s.U; });
  double covariance = 0, with_volume = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    covariance += errors[k] * (samples[k].U - U) / 4;
    with_volume += errors[k] * (samples[k].V - 3.03) / 4;
  }
  REQUIRE(covariance > 10);
  REQUIRE(std::abs(with_volume) < 1e-12);
  const MeasuredProperty m = measured("potential-energy", replicas);
  REQUIRE(m.bias);
  // kT follows from the kinetic energy of 6 N − 3 degrees of freedom: 0.5 % of it.
  const double bias = -covariance / kT / waters;
  CHECK(m.bias->value == doctest::Approx(bias).epsilon(0.006));
  CHECK(m.value.value == doctest::Approx(U / waters - m.bias->value).epsilon(1e-12));
}

namespace {

/// A replica whose potential energies, except in its last third, are higher by 1 %: in equilibrium
/// too late.
Replica late(std::uint64_t index) {
  Replica replica = steady(index);
  for (std::size_t k = 0; k < 2 * segments_of_averages / 3; ++k)
    for (double& U : replica.averages[k].potentials) U += 41;
  return replica;
}

}  // namespace

TEST_CASE("replicas that are too short or not in equilibrium do not withhold the values") {
  const std::vector<Replica> all = four([](std::uint64_t k) { return steady(k); });
  const auto value_of = [](const std::vector<Replica>& replicas) {
    return measured("potential-energy", replicas);
  };
  CHECK(value_of(all).contributions.empty());
  for (std::size_t contributing = 3; contributing > 0; --contributing) {
    CAPTURE(contributing);
    std::vector<Replica> first = all;
    first.resize(contributing);
    const MeasuredProperty alone = value_of(first);
    REQUIRE(alone.value.known == Known::yes);
    std::vector<Replica> with_short = all, with_late = all;
    for (std::size_t k = contributing; k < all.size(); ++k) {
      with_short[k].averages.resize(11);  // an error needs 12
      with_late[k] = late(k);
    }
    if (contributing == 2) with_short[3] = Replica{.index = 3};  // not prepared yet
    const MeasuredProperty some = value_of(with_short), others = value_of(with_late);
    CHECK(some.value.value == alone.value.value);
    CHECK(some.value.error == alone.value.error);
    CHECK(some.value.modes == alone.value.modes);
    CHECK(some.obstacle.empty());
    CHECK(some.contributions == fmt::format("from {} of 4 replicas, {} too short so far",
                                            contributing, 4 - contributing));
    // Without equilibrium, longer runs may move the value.
    CHECK(others.value.value == alone.value.value);
    CHECK(others.value.error == alone.value.error);
    CHECK(others.obstacle.find("a replica has not reached equilibrium") == 0);
    CHECK(others.contributions == fmt::format("from {} of 4 replicas, {} not in equilibrium",
                                              contributing, 4 - contributing));
  }
}

TEST_CASE("a property of averages is not known while all replicas are short or late") {
  std::vector<Replica> replicas = four([](std::uint64_t k) { return steady(k); });
  for (Replica& replica : replicas) replica.averages.resize(11);
  const MeasuredProperty m = measured("density", replicas);
  CHECK(m.value.known != Known::yes);
  CHECK(m.obstacle == "the runs are too short");
  CHECK(measured("density", four(late)).value.known != Known::yes);
  CHECK(measured("density", four(late)).obstacle.find("equilibrium") != std::string::npos);
}

namespace {

constexpr double viscosity = 400;    // [u/(nm ps)]
constexpr double D = 2e-3;           // [nm²/ps], in the periodic box
constexpr double relaxation = 0.5;   // of the pressure and of orientations [ps]
constexpr double edge = 2;           // [nm]
constexpr double volume_of_box = 8;  // [nm³]
constexpr double time_step = 0.004;  // [ps]
constexpr double interval = time_step * steps_of_lags / lags;
constexpr double length_of_segment = time_step * steps_of_lags * windows_in_segment;  // [ps]

/// The variance of a component of the pressure whose autocorrelation is an exponential:
/// η = V/kT ∫ ⟨P(0) P(t)⟩ dt.
double pressure_variance() {
  return viscosity * units::boltzmann * T / (volume_of_box * relaxation);
}

/// The spectrum of such a component at a frequency [1/ps]: the integral of its autocorrelation
/// times the cosine over all times.
double spectrum(double frequency) {
  return 2 * pressure_variance() * relaxation / (1 + std::pow(2 * pi * frequency * relaxation, 2));
}

/// Correlation functions of one kind of molecule, for each segment of dynamics: at all lags a
/// mean-square displacement, and orientations that relax; then the spectrum of the pressure.
BlockMeans::Block correlations(const Topology& topology,
                               const std::function<double(double)>& spectrum_at) {
  const CorrelationsOfDynamics which(topology);
  BlockMeans::Block block{1000, std::vector<double>(which.count * lags)};
  for (std::size_t k = 0; k < lags; ++k) {
    const double t = static_cast<double>(k) * interval;
    const auto set = [&](std::size_t correlation, double value) {
      block.sum[correlation * lags + k] = block.weight * value;
    };
    set(which.displacement.front(), 6 * D * t + 0.01);  // with the offset of a cage
    for (std::size_t axis = 0; axis < which.rotation.front().size(); ++axis)
      set(which.rotation.front()[axis], std::exp(-t / (1 + static_cast<double>(axis))));
  }
  for (std::size_t b = 0; b < pressure_bins().size(); ++b)
    block.sum.push_back(block.weight * spectrum_at(pressure_bins().middle(b) / length_of_segment));
  return block;
}

Replica moving(std::uint64_t index, const std::vector<BlockMeans::Block>& segments,
               const Box& box = {Vec3<double>{edge, edge, edge}}) {
  return {.index = index,
          .step = time_step,
          .state = State{1, Box{Vec3<double>{3, 3, 3}}},
          .dynamics = {.state = State{1, box}, .segments = segments, .paired = {}}};
}

/// Replicas with the exact correlation functions.
std::vector<Replica> exact(const Box& box = {Vec3<double>{edge, edge, edge}}) {
  const std::vector<BlockMeans::Block> segments(12, correlations(water(), spectrum));
  return four([&](std::uint64_t k) { return moving(k, segments, box); });
}

}  // namespace

TEST_CASE("the finite-size correction of diffusion is the mean of the axes of a long box") {
  const Box box{Vec3<double>{edge / 2, edge / 2, 4 * edge}};
  const std::vector<Replica> replicas = exact(box);
  const MeasuredProperty eta = measured("viscosity", replicas),
                         diffusion = measured("diffusion", replicas),
                         cubic = measured("diffusion", exact());
  REQUIRE(diffusion.finite_size);
  // The volume, and so the viscosity, is equal to the one of the cube.
  const Vec3<double> of_axes =
      finite_size_correction(T, eta.value.value * unit("mPa s", Dimension::viscosity), box.edge);
  const double expected =
      (of_axes.x + of_axes.y + of_axes.z) / 3 * 1e3;  // nm²/ps = 1e-6 m²/s, [1e-9 m²/s]
  CHECK(*diffusion.finite_size == doctest::Approx(expected).epsilon(1e-9));
  CHECK(*diffusion.finite_size < 0.5 * *cubic.finite_size);
  CHECK(diffusion.value.value - cubic.value.value ==
        doctest::Approx(*diffusion.finite_size - *cubic.finite_size).epsilon(1e-9));
}

TEST_CASE("dynamics have the viscosity, diffusion and relaxation of their correlation functions") {
  const std::vector<Replica> replicas = exact();
  const MeasuredProperty eta = measured("viscosity", replicas);
  REQUIRE(eta.value.known == Known::yes);
  // The extrapolation is wrong by less than a tenth of the statistical error of 48 segments, 2 %.
  constexpr double extrapolation = 2e-3;
  CHECK(eta.value.value / (viscosity * u / (nm * ps) * 1e3) ==  // [mPa s]
        doctest::Approx(1).epsilon(extrapolation / 2));         // relative to 1 + 1
  const MeasuredProperty diffusion = measured("diffusion", replicas);
  REQUIRE(diffusion.value.known == Known::yes);
  REQUIRE(diffusion.finite_size);
  // Periodic images slow molecules down: the value is larger than D by ξ kT/(6π η L).
  const double correction =
      2.837297 * k_B * T / (6 * pi * viscosity * u / (nm * ps) * edge * nm) * 1e9;  // [1e-9 m²/s]
  CHECK(correction > 0.4);
  CHECK(*diffusion.finite_size / correction == doctest::Approx(1).epsilon(extrapolation / 2));
  CHECK(diffusion.value.value == doctest::Approx(D * 1e-6 * 1e9 + *diffusion.finite_size)
                                     .epsilon(1e-4));  // nm²/ps = 1e-6 m²/s
  // The time of the slowest axis. The trapezoidal rule at 0.04 ps adds (0.04/τ)²/12.
  const CorrelationsOfDynamics which(water());
  const auto slowest = static_cast<double>(which.rotation.front().size());
  const MeasuredProperty tau = measured("rotational-relaxation", replicas);
  CHECK(tau.value.value == doctest::Approx(slowest).epsilon(1e-3));
}

TEST_CASE("the viscosity of sampled pressures agrees within its error, which has 35 or 19 modes") {
  // Five independent components with the same exponential autocorrelation, between samples of
  // 0.008 ps as dynamics have them.
  constexpr double sample = 2 * time_step;
  constexpr std::size_t every = 5, segments = 12;
  const double decay = std::exp(-sample / relaxation), sigma = std::sqrt(pressure_variance());
  const std::vector<Replica> replicas = four([&](std::uint64_t replica) {
    Random random(7, replica);
    std::array<double, 5> c{};
    for (double& x : c) x = sigma * random.normal();
    std::vector<BlockMeans::Block> blocks;
    for (std::size_t segment = 0; segment < segments; ++segment) {
      LowFrequencySpectrum<pressure_components> pressures(every * lags * windows_in_segment,
                                                          sample);
      for (std::size_t k = 0; k < every * lags * windows_in_segment; ++k) {
        for (double& x : c) x = decay * x + sigma * std::sqrt(1 - decay * decay) * random.normal();
        // Of independent_components(), the inverse, with a mean pressure that must not matter.
        const double a = c[0] * 2 / std::sqrt(3.0), mean = 5;
        pressures.add(independent_components({{mean + a, c[4], c[3]},
                                              {c[4], mean - a / 2 + c[1], c[2]},
                                              {c[3], c[2], mean - a / 2 - c[1]}}));
      }
      BlockMeans::Block block = correlations(water(), [](double) { return 0; });
      const std::vector<double> found = pressures.means(pressure_bins());
      for (std::size_t b = 0; b < found.size(); ++b)
        block.sum[block.sum.size() - found.size() + b] = block.weight * found[b];
      blocks.push_back(block);
    }
    return moving(replica, blocks);
  });
  const MeasuredProperty eta = measured("viscosity", replicas);
  REQUIRE(eta.value.known == Known::yes);
  const double expected = viscosity * u / (nm * ps) * 1e3;
  // Four replicas: 3 deviations of means and 4 slowest modes of each, twice as many if the noise is
  // white.
  CHECK((eta.value.modes == 35 || eta.value.modes == 19));
  CHECK(std::abs(eta.value.value - expected) < three_sigma(eta.value));
  // 480 values in each mode have relative variances of 2/480. Modes beyond the half width of the
  // spectrum, mode 20 of a segment, cannot reduce the error below √(2/9600) = 1.4 %. The shortest
  // fit, through three modes, has the variance (1.5² + 0.6² + 0.1²) 2/480: 10 %.
  CHECK(eta.value.error > 0.014 * expected);
  CHECK(eta.value.error < 0.10 * expected);
}

TEST_CASE("dynamics with too few segments, or with slopes that change, are not converged") {
  std::vector<Replica> short_ones = exact();
  for (Replica& replica : short_ones) replica.dynamics.segments.resize(2);
  CHECK(measured("viscosity", short_ones).value.known != Known::yes);
  // A spectrum that falls by half within the first two modes.
  const std::vector<BlockMeans::Block> bent(
      12, correlations(water(), [](double frequency) {
        return 1 / (1 + std::pow(frequency * length_of_segment / 2, 2));
      }));
  const std::vector<Replica> slow = four([&](std::uint64_t k) { return moving(k, bent); });
  const MeasuredProperty eta = measured("viscosity", slow), D0 = measured("diffusion", slow);
  CHECK(eta.obstacle.find("relaxes too slowly for segments of 64 ps") != std::string::npos);
  CHECK(D0.obstacle == eta.obstacle);  // of its correction
  CHECK_FALSE(eta.longer_helps);       // more segments of the same length do not resolve it
}

TEST_CASE("paired segments at half of the step bound the time-step bias of dynamics") {
  // The differences of the viscosity are 1, 3, 2 and 6 % in the four replicas: 3 ± 1.08 %, and the
  // 95 % quantile of Student's t with three degrees of freedom is 3.182.
  const std::array differences = {0.01, 0.03, 0.02, 0.06};
  const auto scaled_by = [](double factor) {
    return correlations(water(), [=](double frequency) { return factor * spectrum(frequency); });
  };
  const double eta = viscosity * u / (nm * ps) * 1e3;  // [mPa s]
  std::vector<Replica> replicas = four([&](std::uint64_t k) {
    std::vector<BlockMeans::Block> segments(12, scaled_by(1));
    segments[8] = scaled_by(1 + differences[k]);
    Replica replica = moving(k, segments);
    replica.dynamics.paired = {{8, scaled_by(1)}};
    return replica;
  });
  const MeasuredProperty m = measured("viscosity", replicas);
  REQUIRE(m.step_bound);
  CHECK(m.step_bound->pairs == 4);
  CHECK(m.step_bound->difference.value == doctest::Approx(0.03 * eta).epsilon(1e-3));
  const double error = std::sqrt((4 + 0 + 1 + 9) * 1e-4 / (3 * 4)) * eta;
  CHECK(m.step_bound->difference.error == doctest::Approx(error).epsilon(1e-3));
  // The bias at h is 4/3 of the difference between h and h/2.
  CHECK(m.step_bound->bound ==
        doctest::Approx(4.0 / 3 * (0.03 * eta + 3.1824 * error)).epsilon(1e-3));
  CHECK(measured("diffusion", replicas).step_bound);
  CHECK(measured("rotational-relaxation", replicas).step_bound->difference.value == 0);
  // Segments that the data do not have yet, and fewer than three pairs, do not count.
  replicas[0].dynamics.segments.resize(8);
  CHECK(measured("viscosity", replicas).step_bound->pairs == 3);
  replicas[1].dynamics.segments.resize(8);
  CHECK(!measured("viscosity", replicas).step_bound);
}

TEST_CASE("a replica without dynamics does not withhold the values of dynamics") {
  std::vector<Replica> replicas = exact();
  const SeriesEstimate all = measured("viscosity", replicas).value;
  replicas[0] = Replica{.index = 0};  // the first, from which the interval of lags was taken
  replicas[1].averages = late(1).averages;
  const MeasuredProperty m = measured("viscosity", replicas);
  // Half as many segments weight the fits of the spectrum differently, whose errors are below 3e-4.
  CHECK(m.value.value == doctest::Approx(all.value).epsilon(3e-4));
  CHECK(m.contributions == "from 2 of 4 replicas, 1 too short so far, 1 not in equilibrium");
  CHECK(m.obstacle.find("a replica has not reached equilibrium") == 0);
}

TEST_CASE("five components of an isotropic tensor have equal variance and no covariance") {
  // An isotropic symmetric random tensor has diagonal elements of twice the variance of the others.
  // The components are linear: their covariances are sums over the basis of tensors.
  std::array<std::array<double, 5>, 5> covariance{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Mat3<double> P{};
      P[i][j] = P[j][i] = 1;
      const auto c = independent_components(P);
      for (std::size_t a = 0; a < 5; ++a)
        for (std::size_t b = 0; b < 5; ++b) covariance[a][b] += (i == j ? 2 : 1) * c[a] * c[b];
    }
  for (std::size_t a = 0; a < 5; ++a)
    for (std::size_t b = 0; b < 5; ++b)
      CHECK(covariance[a][b] == doctest::Approx(a == b ? 1 : 0).epsilon(1e-14));
  // The hydrostatic and the antisymmetric part do not count.
  for (const double x : independent_components({{3, 1, -2}, {-1, 3, 4}, {2, -4, 3}}))
    CHECK(std::abs(x) < 1e-15);
}
