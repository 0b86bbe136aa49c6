// SPDX-License-Identifier: MIT
#include "run/properties/phases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

/// Largest density that cannot be a liquid, relative to the estimated density of the liquid.
constexpr double evaporated = 0.3;
/// Largest density that can be a liquid, relative to the same density.
constexpr double compressed = 2;

/// The rms speed of molecules at a temperature [nm/ps].
double rms_speed(const Bodies& bodies, double temperature) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) sum += bodies.inverse_m[i];
  return std::sqrt(3 * units::boltzmann * temperature * sum / static_cast<double>(bodies.size()));
}

}  // namespace

void LongestWaves::add(const State& state) {
  const auto n = static_cast<double>(state.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::complex<double> wave{};
    for (std::size_t i = 0; i < state.size(); ++i)
      wave += std::polar(1.0, 2 * units::pi * state.q[i][axis] / state.box.edge[axis]);
    sum_ += std::norm(wave) / (3 * n);
  }
  ++samples_;
}

void check_density(double liquid, const StatePoint& at) {
  if (at.constant_volume() && at.density < evaporated * liquid)
    throw Error(fmt::format(
        "the density in '{}' is too low for a liquid; it must be at least {:.0f} kg/m3, {:.0f} % "
        "of the estimated density of the liquid",
        at.text(), in_kg_m3(evaporated * liquid), 100 * evaporated));
  if (at.density > compressed * liquid)
    throw Error(fmt::format(
        "the density in '{}' is too high for a liquid; it must be at most {:.0f} kg/m3, {:g} times "
        "the estimated density of the liquid",
        at.text(), in_kg_m3(compressed * liquid), compressed));
}

void check_liquid(const State& state, double mass, const ReplicaSettings& settings) {
  const double density = mass / state.box.volume();
  if (settings.at.constant_volume() || density >= evaporated * settings.liquid_density) return;
  throw RunError(fmt::format(
      "at {} the molecules evaporate: the density has fallen to {:.0f} kg/m3; give a lower "
      "temperature or a higher pressure, at which the system is a liquid",
      settings.at.text(), in_kg_m3(density)));
}

void check_one_phase(const LongestWaves& waves, std::size_t molecules, const StatePoint& at) {
  // A density wave with an amplitude of a fraction a of the mean density has N a²/4 along its axis.
  // A liquid next to a vapour has a = 0.5 or more, and the mean over three axes is then N/48. The
  // structure factor of a homogeneous fluid is below 4 except close to its critical point.
  const double homogeneous = 4 + static_cast<double>(molecules) / 48;
  if (waves.mean() <= homogeneous) return;
  throw RunError(fmt::format(
      "at {} the molecules separate into two phases: the structure factor at the longest "
      "wavelengths is {:.0f}, and a homogeneous liquid of {} molecules has less than {:.0f}; give "
      "{}",
      at.text(), waves.mean(), molecules, homogeneous,
      at.constant_volume() ? "the density of the liquid, which is higher, or a higher temperature"
                           : "a higher pressure, at which the system is a liquid"));
}

Vec3Column in_fractions(const State& state) {
  Vec3Column fractions(state.size());
  const Vec3<double> edge = state.box.edge;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> q = state.q[i];
    fractions.set(i, {q.x / edge.x, q.y / edge.y, q.z / edge.z});
  }
  return fractions;
}

void check_motion(const State& state, const Bodies& bodies, const Vec3Column& start, double time,
                  const StatePoint& at) {
  // In a crystal at its melting point, displacements between two times are 0.2 spacings; in a
  // colder crystal or a glass they are smaller. A liquid that moves by less has a relaxation time
  // of many times the length of the runs.
  constexpr double min_displacement = 0.25;
  // Without collisions, molecules would move by this many spacings in a run that is long enough. In
  // ordinary liquids they leave their places after about one spacing.
  constexpr double min_path = 10;
  if (start.size() != state.size()) return;
  double squares = 0;
  const Vec3Column now = in_fractions(state);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> d = now[i] - start[i];
    squares += norm2(state.box.minimum_image(scaled(d, state.box.edge)));
  }
  const auto n = static_cast<double>(state.size());
  const double moved = std::sqrt(squares / n), spacing = std::cbrt(state.box.volume() / n);
  if (moved >= min_displacement * spacing) return;
  const double path = time * rms_speed(bodies, at.temperature);
  if (path < min_path * spacing)
    throw RunError(fmt::format(
        "at {} the molecules have moved by only {:.2g} nm (rms) in {:.2g} ps, which is too short "
        "to distinguish a liquid from a solid: without collisions they would move by {:.2g} nm, "
        "and {:.2g} nm are needed; give a longer time step",
        at.text(), moved, time, path, min_path * spacing));
  throw RunError(fmt::format(
      "at {} the molecules have moved by only {:.2g} nm (rms) in {:.0f} ps, less than a quarter of "
      "their spacing of {:.2g} nm: the system is a solid, a crystal or a glass; give a higher "
      "temperature, at which it is a liquid",
      at.text(), moved, time, spacing));
}

}  // namespace polhode
