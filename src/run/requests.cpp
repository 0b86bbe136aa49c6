// SPDX-License-Identifier: MIT
#include "run/requests.hpp"

#include <fmt/ranges.h>

#include <limits>

#include "io/settings/config_parts.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/required_bias.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/top/top.hpp"
#include "run/listing/verification.hpp"

namespace polhode {
namespace {

constexpr std::uint64_t max_count = 100'000'000;

/// A time as text for help, such as "2 ps" or "20 fs".
std::string time_text(double time) {
  return time < 1 ? fmt::format("{:g} fs", time * units::fs_per_ps) : fmt::format("{:g} ps", time);
}

Vec3<double> three_numbers(const Given& given) {
  const std::vector<double> x = given_numbers(given, 3, "\"1, 2, 3\"");
  return {x[0], x[1], x[2]};
}

}  // namespace

std::vector<RequestOption<MinimisationRequest>> MinimisationRequest::options() {
  using R = MinimisationRequest;
  const MinimisationSettings defaults;
  return {{"max_force", &R::max_force,
           fmt::format("bound on the largest force on a molecule; default: \"{:g} kJ/mol/nm\"",
                       defaults.force)},
          {"max_torque", &R::max_torque,
           fmt::format("bound on the largest torque; default: \"{:g} kJ/mol\"", defaults.torque)},
          {"max_steps", &R::max_steps,
           fmt::format("maximum number of steps; default: {}", defaults.max_steps)}};
}

MinimisationSettings MinimisationRequest::settings() const {
  MinimisationSettings s;
  take_positive(s.force, max_force, Dimension::force, "10 kJ/mol/nm");
  take_positive(s.torque, max_torque, Dimension::energy, "1 kJ/mol");
  if (max_steps) s.max_steps = given_whole_number(max_steps, 1, max_count);
  return s;
}

std::vector<RequestOption<ConversionRequest>> ConversionRequest::options() {
  using R = ConversionRequest;
  return {
      {"particles", &R::particles,
       "run file whose molecules are the particles of a LAMMPS dump file"},
      {"names", &R::names, "file with the atom names, for formats without names: XTC, TRR, DCD"},
      {"every", &R::every, "write every Nth frame; default: 1"},
      {"start", &R::start, "leave out frames before this time: \"10 ps\"", "from"},
      {"stop", &R::stop, "leave out frames after this time", "to"}};
}

Conversion ConversionRequest::conversion(const std::string& from, const std::string& to,
                                         const Config* run) const {
  Conversion c{.from = from, .to = to, .names = names.text};
  if (every) c.every = given_whole_number(every, 1, std::numeric_limits<std::uint64_t>::max());
  if (start) c.first = given_quantity(start, Dimension::time);
  if (stop) c.last = given_quantity(stop, Dimension::time);
  if (particles) c.particles = build_system(read_config(particles.text)).topology;
  if (run != nullptr) c.particles = build_system(*run).topology;
  return c;
}

std::vector<RequestOption<AdviceRequest>> AdviceRequest::options() {
  using R = AdviceRequest;
  return {{"accuracy", &R::accuracy, "upper bound on R of a run: \"0.5 %\""},
          {"drift", &R::drift, "upper bound on the energy drift per molecule: \"0.1 kJ/mol/ns\""},
          {"temperature_bias", &R::temperature_bias,
           "upper bound on the difference between the temperatures of translation and rotation: "
           "\"0.5 %\""},
          {"bias", &R::bias,
           "upper bound on the time-step bias of an average: \"0.1 K\" (of T_rot - T_trans), "
           "\"energy 0.01 "
           "kJ/mol\", \"pressure 4 bar\", \"density 0.02 %\""},
          {"ensemble", &R::ensemble,
           "ensemble: nve, or nvt to choose step and trajectory length of hybrid Monte Carlo; "
           "default: nve"},
          {"evaluations", &R::evaluations,
           fmt::format("force evaluations of each pilot run in the ensemble nvt; default: {}",
                       HybridAdviserSettings{}.evaluations)},
          {"time", &R::time,
           fmt::format("approximate computing time, in seconds; default: {:g}",
                       AdviserSettings{}.seconds)},
          {"output", &R::output, "prefix of the output files; default: " + R{}.prefix()}};
}

bool AdviceRequest::is_canonical() const {
  return ensemble && given_name<StudyEnsemble>(ensemble) == StudyEnsemble::nvt;
}

AdviserSettings AdviceRequest::settings(const Config& config) const {
  if (evaluations)
    refuse(evaluations, fmt::format("applies only to hybrid Monte Carlo; leave it out, or give {} "
                                    "\"nvt\"",
                                    ensemble.name));
  const Given* requirement = nullptr;
  for (const Given* one : {&accuracy, &drift, &temperature_bias, &bias}) {
    if (!*one) continue;
    if (requirement != nullptr)
      throw Error(fmt::format(
          "{} excludes {}, since the step is chosen for a single bound; give only one of the two",
          requirement->name, one->name));
    requirement = one;
  }
  AdviserSettings s{.criterion = {}, .schemes = config.integrator.candidates};
  if (time) s.seconds = given_number(time, 0.1, 1e6);
  const auto bounded = [&](const Requirement& required) {
    s.criterion = criterion_of(required, config.ensemble);
  };
  if (accuracy) s.criterion = {Quality::ratio, given_fraction(accuracy)};
  if (drift) s.criterion = {Quality::drift, given_positive(drift, Dimension::power)};
  if (temperature_bias) s.criterion = {Quality::temperature_bias, given_fraction(temperature_bias)};
  if (bias) bounded(required_bias(bias.text, bias.name));
  if (requirement == nullptr && config.integrator.accuracy) bounded(*config.integrator.accuracy);
  if (requirement == nullptr && !config.integrator.accuracy)
    throw Error(
        fmt::format("no accuracy is requested; give {} \"0.5 %\", {} \"0.1 kJ/mol/ns\", "
                    "{} \"0.5 %\" or {} \"0.1 K\"",
                    accuracy.name, drift.name, temperature_bias.name, bias.name));
  return s;
}

HybridAdviserSettings AdviceRequest::hybrid_settings(const Config& config, bool schemes_given,
                                                     const Given& length) const {
  const auto exclude = [&](const Given& given, const char* reason) {
    if (given)
      refuse(given, fmt::format("has no meaning with {} \"nvt\", because {}; leave it out",
                                ensemble.name, reason));
  };
  for (const Given& bound : {accuracy, drift, temperature_bias, bias})
    exclude(bound, "hybrid Monte Carlo is exact at any step");
  for (const Given& effort : {time, length})
    exclude(effort, "the number of force evaluations determines the length of all runs");
  exclude(output, "no file is written");
  HybridAdviserSettings s;
  if (evaluations) s.evaluations = given_whole_number(evaluations, 100, max_count);
  if (!schemes_given) return s;
  if (config.integrator.candidates.size() > 1)
    throw Error(
        "several schemes are given, but advice on hybrid Monte Carlo is for one scheme; give a "
        "single scheme");
  s.scheme = config.integrator.candidates.front();
  return s;
}

std::vector<RequestOption<StudyRequest>> StudyRequest::options() {
  using R = StudyRequest;
  return {{"from_record", &R::from_record,
           "record of an earlier study by any version of polhode; makes tables and figure from "
           "this record without new runs"},
          {"output", &R::output, "prefix of the output files; default: " + R{}.prefix()}};
}

std::vector<RequestOption<TuneRequest>> TuneRequest::options() {
  using R = TuneRequest;
  const TuneSettings d;
  const auto with_default = [](const char* text, double time) {
    return fmt::format("{}; default: \"{}\"", text, time_text(time));
  };
  return {
      {"scheme", &R::scheme,
       "stages with free parameters: \"free b = 0.2; B(b) A(1/2) ...\"; default: the scheme of the "
       "run file, or the families of hoa2 and gier4"},
      {"step", &R::step, "time step to tune for: \"5 fs\""},
      {"runs", &R::runs,
       fmt::format("number of runs for tuning, and the same number for confirmation; default: {}",
                   d.runs)},
      {"length", &R::length, with_default("length of each run", d.length)},
      {"decorrelate", &R::decorrelate,
       with_default("equilibration of each initial configuration", d.decorrelate)},
      {"sample", &R::sample, with_default("time between samples of the error brackets", d.sample)}};
}

TuneSettings TuneRequest::settings(const Config& config) const {
  TuneSettings s;
  if (scheme) {
    s.scheme = with_own_schemes(scheme.text, config.schemes);
    at_place(scheme.name, [&] { nested_scheme_of(s.scheme); });
  }
  take_positive(s.step, step, Dimension::time);
  if (runs) s.runs = static_cast<int>(given_whole_number(runs, 2, 1000));
  take_positive(s.length, length, Dimension::time);
  take_positive(s.decorrelate, decorrelate, Dimension::time);
  take_positive(s.sample, sample, Dimension::time);
  return s;
}

std::vector<RequestOption<BenchmarkRequest>> BenchmarkRequest::options() {
  using R = BenchmarkRequest;
  return {
      {"sizes", &R::sizes,
       fmt::format("numbers of waters; default: {}", fmt::join(BenchmarkSettings{}.sizes, ","))},
      {"precision", &R::precision,
       "precision of pair interactions, double or mixed; default: both"}};
}

BenchmarkSettings BenchmarkRequest::settings(bool is_quick, int threads) const {
  BenchmarkSettings s;
  s.quick = is_quick;
  if (is_quick) s.sizes = {512};
  if (sizes) s.sizes.clear();
  for (const std::string& size : given_words(sizes))
    s.sizes.push_back(given_whole_number({size, sizes.name}, 1, max_count));
  if (s.sizes.empty()) refuse(sizes, "has no number of waters; write for example \"512,4096\"");
  if (precision) s.precisions = {given_name<Precision>(precision)};
  if (threads > 1) s.threads.push_back(threads);
  return s;
}

std::vector<RequestOption<VerificationRequest>> VerificationRequest::options() {
  using R = VerificationRequest;
  return {{"order", &R::order,
           "expected order, from 1 to 12; default: the order in the table of schemes"},
          {"lambda", &R::lambda, "scale of the displacement of a finite-difference gradient"}};
}

int VerificationRequest::expected_order() const {
  return order ? static_cast<int>(given_whole_number(order, 1, 12)) : 0;
}

double VerificationRequest::gradient_lambda(const NestedScheme& scheme) const {
  if (!lambda) return 1e-4;
  at_place(lambda.name, [&] { check_lambda(scheme); });
  return given_number(lambda, 1e-8, 1);
}

std::vector<RequestOption<TopRequest>> TopRequest::options() {
  using R = TopRequest;
  return {
      {"J", &R::J, "principal moments of inertia in any consistent units: \"1, 2, 3\""},
      {"L", &R::L, "body-frame angular momentum: \"0.1, 0.2, 1\""},
      {"step", &R::step, "time step; default: a rotation by 0.2 rad per step"},
      {"length", &R::length, "length of the trajectory; default: 200 steps"},
      {"output", &R::output,
       "prefix of a figure of the polhode on the inertia ellipsoid: PREFIX.svg, .png, .dat, .gp"},
      {"table", &R::table,
       "CSV file with the columns I1,I2,I3,L1,L2,L3,t and one top per row; prints the rotation of "
       "each top"},
      {"method", &R::method,
       fmt::format("method for the table: {}; default: {}",
                   fmt::join(enum_names<RotorMethod>, ", "), enum_names<RotorMethod>[0])}};
}

FreeTop TopRequest::top() const {
  if (method) refuse(method, fmt::format("has no meaning without {}; leave it out", table.name));
  FreeTop top;
  if (J) top.J = three_numbers(J);
  if (L) top.L = three_numbers(L);
  if (!J || !L)
    throw Error(fmt::format("a top needs three principal moments and three components of angular "
                            "momentum: write for example {} 1,2,3 {} 0.1,0.2,1, or give a {}",
                            J.name, L.name, table.name),
                J.name + ", " + L.name);
  if (step) top.step = given_numbers(step, 1, "0.1").front();
  if (length) top.length = given_numbers(length, 1, "20").front();
  return top;
}

std::string TopRequest::rotated_table() const {
  for (const Given* one : {&J, &L, &step, &length, &output})
    if (*one)
      refuse(*one, fmt::format("has no meaning with {}, whose rows are the tops; leave it out",
                               table.name));
  return rotate_table(table.text, method ? given_name<RotorMethod>(method) : RotorMethod::series);
}

}  // namespace polhode
