// SPDX-License-Identifier: MIT
#include "run/properties/estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/settings/quantity.hpp"
#include "measure/displacement.hpp"
#include "measure/finite_size.hpp"
#include "measure/reorientation.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/properties/distances.hpp"
#include "run/properties/dynamics.hpp"
#include "run/properties/low_frequency_spectrum.hpp"
#include "run/properties/property.hpp"
#include "run/properties/second_virial.hpp"
#include "run/properties/target.hpp"

namespace polhode {
namespace {

constexpr const char* too_short = "the runs are too short";

constexpr const char* no_equilibrium =
    "a replica has not reached equilibrium; if longer runs do not help, the system is a crystal, a "
    "glass or a coexistence of two phases";

std::span<const AveragesSegment> averages_in_equilibrium(const Contribution& c) {
  return std::span(c.replica->averages).subspan(c.from);
}

void estimate_average(MeasuredProperty& m, const Contributions& contributions,
                      const PointData& data) {
  const PropertyConditions conditions{
      .at = data.at,
      .molecules = data.topology.size(),
      .mass = data.topology.mass(),
      .degrees_of_freedom = degrees_of_freedom(data.topology, TotalMomentum::free).all()};
  const Property& property = *m.request.property;
  const auto statistic = [&](Means means) { return property.value(means, conditions); };
  m.value = pooled_estimate(runs_of(contributions, averages_in_equilibrium, &AveragesSegment::sums),
                            statistic);
  if (m.value.known != Known::yes) return;
  subtract_bias(
      m, step_bias(responses_of(contributions, averages_in_equilibrium, &AveragesSegment::response),
                   degrees_of_freedom(data.topology).all(), data.fixed_means(), statistic));
}

/// The correlation functions of the dynamics of all replicas.
class Dynamics {
 public:
  Dynamics(const PointData& data, const Contributions& contributions)
      : data_(data),
        contributions_(contributions),
        which_(data.topology),
        runs_(dynamics_of(contributions_, which_.functions())) {
    if (empty()) return;
    interval_ = lag_interval(*contributions_.all.front().replica);
    const Box box = box_of(contributions_);
    const Vec3<double> mobility = image_mobility(box.edge);
    volume_ = box.volume();
    mobility_ = (mobility.x + mobility.y + mobility.z) / 3;
    double segments = 0;
    for (const BlockMeans& run : runs_) segments += static_cast<double>(run.blocks().size());
    spectrum_.emplace(which_.spectrum_in(overall(runs_)), pressure_components * segments,
                      pressure_bins());
  }
  bool empty() const { return runs_.front().empty(); }

  void viscosity(MeasuredProperty& m) const {
    const double mPa_s = unit("mPa s", Dimension::viscosity);
    const auto value = [&](Means all) { return eta(all) / mPa_s; };
    m.value = pooled_estimate(runs_, value);
    note_unresolved(m);
    m.step_bound = bound(value);
  }

  /// Computes the diffusion coefficient with the finite-size correction. The error of the
  /// correction is correlated with the error of the slope.
  void diffusion(MeasuredProperty& m) const {
    const FitWindow window = fit_window(interval_);
    estimate_slope(m, runs_, interval_,
                   [this](Means all, const FitWindow& fit) { return D(all, fit); });
    const auto D0 = [&](Means all) { return D(all, window) + correction(all); };
    m.value = pooled_estimate(runs_, D0);
    m.finite_size = correction(overall(runs_)) / nm2_per_ns;
    m.value = scaled(m.value, 1 / nm2_per_ns);
    if (m.obstacle.empty()) note_unresolved(m);
    m.step_bound = bound([&](Means all) { return D0(all) / nm2_per_ns; });
  }

  /// Computes the relaxation time of the slowest axis.
  void relaxation(MeasuredProperty& m) const {
    for (const auto& axes : which_.rotation)
      for (const std::size_t axis : axes) {
        const auto times = relaxation_times(function(axis), interval_);
        if (!times) {
          m.obstacle = "the orientation does not relax within the window of lags";
          m.value = {std::nan("")};
          return;
        }
        if (!(times->integral.value <= m.value.value)) m.value = times->integral;
      }
    m.step_bound = bound([this](Means all) { return slowest_relaxation(all); });
  }

 private:
  Means part(Means all, std::size_t k) const { return all.subspan(k * lags, lags); }
  double segment_length() const {
    return interval_ * static_cast<double>(lags * windows_in_segment);
  }
  /// The viscosity. The spectrum at zero frequency is the integral of the autocorrelation function
  /// over all times, twice the integral of Green and Kubo.
  double eta(Means all) const {
    return spectrum_->value(which_.spectrum_in(all)) * volume_ /
           (2 * units::boltzmann * data_.at.temperature);
  }
  /// Notes that the viscosity is not known if its spectrum changes within the lowest modes. More
  /// segments of the same length do not resolve it.
  void note_unresolved(MeasuredProperty& m) const {
    if (m.value.known != Known::yes || spectrum_->is_resolved()) return;
    m.longer_helps = false;
    m.obstacle = fmt::format(
        "the pressure tensor relaxes too slowly for segments of {:.3g} ps, so its spectrum at zero "
        "frequency, which gives the viscosity, is not resolved: the liquid is too viscous",
        segment_length());
  }
  double D(Means all, const FitWindow& fit) const {
    return slope_between(part(all, which_.displacement.front()), interval_, fit) / 6;
  }
  /// The finite-size correction of D, the mean over the three axes of the box.
  double correction(Means all) const {
    return units::boltzmann * data_.at.temperature / eta(all) * mobility_;
  }
  double slowest_relaxation(Means all) const {
    double slowest = 0;
    for (const auto& axes : which_.rotation)
      for (const std::size_t axis : axes) {
        const Means C = part(all, axis);
        const auto times = relaxation_times(BlockMeans({{1, {C.begin(), C.end()}}}), interval_);
        slowest = times ? std::max(slowest, times->integral.value) : std::nan("");
      }
    return slowest;
  }
  /// A bound of the time-step bias of a statistic, from the paired segments.
  std::optional<StepBound> bound(const Statistic& statistic) const {
    return step_bound(step_difference(contributions_, which_.functions(), statistic));
  }
  BlockMeans function(std::size_t which) const {
    std::vector<BlockMeans::Block> blocks;
    for (const BlockMeans& run : runs_)
      for (const BlockMeans::Block& block : run.blocks()) {
        const Means C = part(block.sum, which);
        blocks.push_back({block.weight, {C.begin(), C.end()}});
      }
    return BlockMeans(std::move(blocks));
  }
  const PointData& data_;
  const Contributions& contributions_;
  CorrelationsOfDynamics which_;
  std::vector<BlockMeans> runs_;
  std::optional<ZeroFrequency> spectrum_;
  double interval_ = 0, volume_ = 0;
  double mobility_ = 0;  // image_mobility() of the box, mean over the axes
};

/// The number of neighbours within the first minimum of g(r) of the centres.
void coordination(MeasuredProperty& m, const Contributions& contributions, const PointData& data) {
  const PartOfSums part = CorrelationsOfDynamics(data.topology).distances();
  const std::vector<BlockMeans> runs = dynamics_of(contributions, part);
  if (runs.front().empty()) return;
  const std::vector<double> means = overall(runs);
  const Distances distances = Distances::of_sums(data.topology, means.size());
  const auto peak =
      distances.first_peak(0, means, [&](const Statistic& f) { return pooled_estimate(runs, f); });
  if (!peak || !peak->shell) {
    m.obstacle = fmt::format(
        "g(r) of the centres has no first minimum within {:.2f} nm; more molecules "
        "increase this range up to 1.2 nm",
        distances.middle(distances.bins() - 1));
    return;
  }
  m.value = peak->shell->coordination;
  m.remark = fmt::format("first minimum of g(r) at {}", text_of(peak->shell->end, "nm"));
  const auto difference = distances.first_peak(0, means, [&](const Statistic& f) {
    return step_difference(contributions, part, f, means.size());
  });
  m.step_bound = step_bound(difference->shell->coordination);
}

void estimate_dynamics(MeasuredProperty& m, const Contributions& contributions,
                       const PointData& data) {
  const std::string_view name = m.request.property->name;
  if (name == "coordination-number") return coordination(m, contributions, data);
  const Dynamics dynamics(data, contributions);
  if (dynamics.empty())
    m.obstacle = too_short;
  else if (name == "viscosity")
    dynamics.viscosity(m);
  else if (name == "diffusion")
    dynamics.diffusion(m);
  else
    dynamics.relaxation(m);
}

void estimate_pair(MeasuredProperty& m, const PointData& data) {
  for (std::size_t points = 1024; points <= 65536 && !m.reached(); points *= 4) {
    const Estimate B = second_virial(data.topology.parts.front().molecule, data.mixing,
                                     data.at.temperature, points, Workers::serial(), data.stop);
    if (!std::isfinite(B.value)) break;
    m.value = {B.value / cm3_per_mol, B.error / cm3_per_mol, Known::yes, 15};
  }
  if (m.value.known != Known::yes) m.obstacle = "the integral was not completed";
}

/// Whether all replicas have the same time step, without which their dynamics cannot be joined.
bool have_one_step(std::span<const Replica> replicas) {
  double step = 0;
  return std::ranges::all_of(replicas, [&](const Replica& replica) {
    if (replica.prepared() && step == 0) step = replica.step;
    return !replica.prepared() || replica.step == step;
  });
}

}  // namespace

double MeasuredProperty::requested_error() const {
  return request.relative ? request.error * std::abs(value.value) : request.error;
}

bool MeasuredProperty::reached() const {
  return value.known == Known::yes && obstacle.empty() && value.error <= requested_error();
}

std::optional<std::array<double, 2>> MeasuredProperty::interval(double probability) const {
  if (value.known != Known::yes) return std::nullopt;
  const double half = interval_factor(value, probability) * value.error;
  if (!request.property->logarithmic || value.value <= 0)
    return std::array{value.value - half, value.value + half};
  const double factor = std::exp(half / value.value);
  return std::array{value.value / factor, value.value * factor};
}

MeasuredProperty estimate(const RequestedProperty& request, const PointData& data) {
  MeasuredProperty m{.request = request, .value = {std::nan("")}};
  const MeasuredIn kind = request.property->measured_in;
  if (is_dynamics(kind) && !have_one_step(data.replicas)) {
    m.obstacle =
        "replicas have different time steps, because their shards had separate pilots; give all "
        "shards the record of one pilot before they start";
    m.longer_helps = false;
    return m;
  }
  if (kind == MeasuredIn::pair) {
    estimate_pair(m, data);
    return m;
  }
  using Estimator = void (*)(MeasuredProperty&, const Contributions&, const PointData&);
  constexpr PerKind<Estimator> estimate_of{{estimate_average, estimate_dynamics, estimate_orthoboxy,
                                            estimate_coupling, estimate_slab, estimate_conduction}};
  const Contributions contributions(data, kind);
  estimate_of[kind](m, contributions, data);
  m.contributions = contributions.text();
  if (m.obstacle.empty() && contributions.not_in_equilibrium > 0) m.obstacle = no_equilibrium;
  if (m.obstacle.empty() && m.value.known != Known::yes) m.obstacle = too_short;
  return m;
}

std::vector<SeriesEstimate> stages_of(const RequestedProperty& request, const PointData& data) {
  if (request.property->measured_in == MeasuredIn::pair) return {};
  constexpr std::size_t stages = 10;
  std::vector<SeriesEstimate> list;
  for (std::size_t k = 1; k <= stages; ++k) {
    std::vector<Replica> first(data.replicas.begin(), data.replicas.end());
    for (Replica& replica : first)
      for (const MeasuredIn kind : kinds_of_run)
        shorten(replica, kind, length_of(replica, kind) * k / stages);
    PointData part = data;
    part.replicas = first;
    list.push_back(estimate(request, part).value);
  }
  return list;
}

}  // namespace polhode
