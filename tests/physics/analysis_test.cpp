// SPDX-License-Identifier: MIT
// Observables from frames of atoms, as in trajectory files.
#include "run/analysis/analysis_summary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "../analysis_curves.hpp"
#include "io/settings/quantity.hpp"
#include "measure/displacement.hpp"
#include "model/initial_state.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/measure/energy.hpp"

using namespace polhode;

namespace {

// Frames in memory.
class Frames : public FrameReader {
 public:
  explicit Frames(std::vector<Frame> frames) : frames_(std::move(frames)) {}
  bool next(Frame& frame) override {
    if (at_ == frames_.size()) return false;
    frame = frames_[at_++];
    return true;
  }

 private:
  std::vector<Frame> frames_;
  std::size_t at_ = 0;
};

const Topology waters() { return {{{read_molecule("tip4p"), 27}}}; }

// Free molecules: uniform motion and free rotation, without forces.
std::vector<Frame> free_flight(const Topology& topology, int count, MasslessSites massless) {
  State state = lattice(topology, Box{{2, 2, 2}}, 3);
  draw_momenta(state, topology, 300, 4);
  const Bodies bodies(topology);
  std::vector<Frame> frames;
  for (int k = 0; k < count; ++k) {
    frames.push_back(frame_of(state, topology, massless));
    frames.back().time = 5 + 0.01 * k;
    drift(state, bodies, 0.01);
  }
  return frames;
}

// Frames as in a format without names and velocities, with positions rounded to 0.001 nm.
void make_poor(std::vector<Frame>& frames) {
  for (Frame& frame : frames) {
    frame.kinds = {AtomKind{}};
    frame.has_velocities = false;
    for (Atom& atom : frame.atoms) {
      atom.kind = 0;
      atom.v = {};
      for (std::size_t k = 0; k < 3; ++k) atom.r[k] = std::round(atom.r[k] * 1000) / 1000;
    }
  }
}

}  // namespace

// Without forces MSD = ⟨v²⟩ t² and velocities are constant, up to rounding in the fit. All
// observables are present, with the same bits for three threads.
TEST_CASE("analysis of free molecules in memory") {
  const Topology topology = waters();
  AnalysisSettings settings;
  settings.window = 0.1;
  Frames file(free_flight(topology, 40, MasslessSites::keep));
  Analysis a = analyze(file, {{{topology.parts[0].molecule, 0}}}, settings);
  CHECK(a.frames == 40);
  CHECK(a.topology.size() == 27);
  CHECK(a.interval == doctest::Approx(0.01).epsilon(1e-9));
  CHECK(a.deviation < 1e-9);
  const SummarySettings numbers{.fit = FitWindow{0.02, 0.1}, .surroundings_permittivity = tin_foil};
  const AnalysisSummary one = summary(a, numbers);
  const std::vector<double> msd = column(one, "msd", "msd"),
                            v = column(one, "velocity", "v product");
  const double v2 = 3 * v[0];
  for (std::size_t lag = 0; lag <= 10; ++lag) {
    const double t = 0.01 * static_cast<double>(lag);
    CHECK(msd[lag] == doctest::Approx(v2 * t * t).epsilon(1e-7));
    CHECK(v[lag] == doctest::Approx(v2 / 3).epsilon(1e-9));
  }
  CHECK(a.conditions->temperature().value == doctest::Approx(300).epsilon(1e-6));
  CHECK(a.conditions->density().value == doctest::Approx(topology.mass() / 8).epsilon(1e-12));

  Workers workers(3);
  Frames again(free_flight(topology, 40, MasslessSites::keep));
  Analysis b = analyze(again, topology, settings, {}, workers);
  const AnalysisSummary three = summary(b, numbers, workers);
  REQUIRE(one.files.size() == three.files.size());
  CHECK(one.files.size() == 7);
  for (const AnalysisFile& curve : one.files)
    for (const std::string& name : columns(one, curve.name))
      if (name.find("error") == name.npos)
        CHECK(column(one, curve.name, name) == column(three, curve.name, name));
  CHECK(json_text(one.quantities) == json_text(three.quantities));
  const std::string source = numbers_of(one)["diffusion"]["viscosity_source"];
  CHECK(source.find("gonzalez2010") != std::string::npos);
  // Images slow diffusion: the correction by the published viscosity is added, whether or not D has
  // converged.
  const auto part = numbers_of(one)["parts"][0];
  const auto value = [&](const char* key) {
    const auto number = part[key];
    return number.value("converged", true) ? number["value"] : number["unconverged_estimate"];
  };
  const double added = value("D_without_images_1e-9_m2_per_s").get<double>() -
                       value("D_1e-9_m2_per_s").get<double>();
  const double kT = units::boltzmann * a.conditions->temperature().value,
               viscosity = quantity("0.494 mPa s", Dimension::viscosity, "viscosity");
  const double expected = 1000 * 2.837297 * kT / (6 * units::pi * viscosity * 2);  // [yeh2004]
  CHECK(added == doctest::Approx(expected).epsilon(1e-6));
}

// Rounding to 0.001 nm displaces atoms by up to √3/2 of that, and the fit may add as much; centres
// are means of three atoms, so their displacements have the same error.
TEST_CASE("files without names, velocities or massless sites, and with few digits") {
  const Topology topology = waters();
  AnalysisSettings settings;
  settings.window = 0.1;
  Frames exact(free_flight(topology, 40, MasslessSites::keep));
  std::vector<Frame> poor = free_flight(topology, 40, MasslessSites::omit);
  make_poor(poor);
  Frames file(poor);
  Analysis a = analyze(exact, topology, settings), b = analyze(file, topology, settings);
  CHECK(b.deviation > 1e-4);
  CHECK(b.deviation < 0.0018);
  CHECK(b.notes.size() == 1);
  const AnalysisSummary s = summary(b, {.surroundings_permittivity = tin_foil});
  CHECK(columns(s, "velocity").empty());
  const AnalysisSummary good = summary(a, {});
  for (std::size_t lag = 1; lag <= 10; ++lag) {
    const double far = std::sqrt(column(good, "msd", "msd")[lag]);
    CHECK(std::abs(std::sqrt(column(s, "msd", "msd")[lag]) - far) < 0.001);
    CHECK(column(s, "rotation", "P1 axis 1")[lag] ==
          doctest::Approx(column(good, "rotation", "P1 axis 1")[lag]).epsilon(1e-3));
  }
  CHECK(!numbers_of(s).contains("dielectric"));
  const std::string source = numbers_of(s)["diffusion"]["viscosity_source"];
  CHECK(source.find("give a temperature") != std::string::npos);

  settings.what = {"velocity"};
  Frames refused(poor);
  CHECK_THROWS_WITH_AS(analyze(refused, topology, settings), doctest::Contains("no velocities"),
                       Error);
  Frames other(poor);
  CHECK_THROWS_WITH_AS(analyze(other, {{{topology.parts[0].molecule, 26}}}, {}),
                       doctest::Contains("81 atoms without names"), Error);
}

TEST_CASE("unevenly spaced frames are refused if correlations are requested") {
  std::vector<Frame> frames = free_flight(waters(), 6, MasslessSites::keep);
  frames[4].time += 0.005;
  AnalysisSettings settings;
  Frames uneven(frames), structure(frames), told(frames);
  CHECK_THROWS_WITH_AS(analyze(uneven, waters(), settings),
                       doctest::Contains("frame 5 is at 5.045 ps instead of 5.04 ps"), Error);
  settings.what = {"rdf", "density"};
  CHECK(analyze(structure, waters(), settings).frames == 6);
  settings.what.clear();
  settings.interval = 0.02;
  CHECK(analyze(told, waters(), settings).interval == 0.02);
  settings.from = 7;
  Frames late(frames);
  CHECK_THROWS_WITH_AS(analyze(late, waters(), settings), doctest::Contains("no frame at 7 ps"),
                       Error);
}

TEST_CASE(
    "ions have no dielectric constant, and an interrupted analysis has the frames read so far") {
  const Topology brine{{{read_molecule("tip4p"), 20}, {read_molecule("na-tip4p-ew"), 2}}};
  Frames file(free_flight(brine, 20, MasslessSites::keep));
  std::size_t batches = 0;
  Analysis a = analyze(
      file, brine, {},
      {.progress = [&](const Progress&) { ++batches; }, .stop = [&] { return batches == 3; }});
  CHECK(a.stopped);
  CHECK(a.frames == 6);
  CHECK(a.notes.front().find("has a charge of 1 e") != std::string::npos);
  const AnalysisSummary s = summary(a, {.surroundings_permittivity = tin_foil});
  CHECK(!numbers_of(s).contains("dielectric"));
  for (const std::string& name : columns(s, "rotation")) CHECK(name.find("na-") == name.npos);
  CHECK(column(s, "msd", "na-tip4p-ew msd").size() == 4);
}

// A gas of two sites that never approach each other.
TEST_CASE("g(r) = 0 has no peak, and few frames have no errors") {
  const Topology pair{{{read_molecule("argon"), 2}}};
  State state(2, Box{{4, 4, 4}});
  state.q.set(1, {2, 2, 2});
  std::vector<Frame> frames;
  for (int k = 0; k < 11; ++k) {
    frames.push_back(frame_of(state, pair, MasslessSites::keep));
    frames.back().time = k;
  }
  Frames file(frames);
  Analysis a = analyze(file, pair, {});
  const AnalysisSummary s = summary(a, {});
  REQUIRE(numbers_of(s)["rdf"].size() == 1);
  CHECK(numbers_of(s)["rdf"][0]["peak_nm"].is_null());
  CHECK(a.conditions->density().known == Known::too_few_samples);
  frames.push_back(frames.back());
  frames.back().time = 11;
  Frames longer(frames);
  Analysis b = analyze(longer, pair, {});
  CHECK(b.conditions->density().known == Known::yes);
  CHECK(b.conditions->density().error == 0);  // the box is constant
}

TEST_CASE("a single molecule has no displacements") {
  const Topology one{{{read_molecule("tip4p"), 1}}};
  Frames file(free_flight(one, 30, MasslessSites::keep));
  Analysis a = analyze(file, one, {});
  CHECK(std::any_of(a.notes.begin(), a.notes.end(), [](const std::string& note) {
    return note.find("there is only one") != std::string::npos;
  }));
  const AnalysisSummary s = summary(a, {.surroundings_permittivity = tin_foil});
  CHECK(columns(s, "msd").empty());
  CHECK(numbers_of(s)["parts"][0].size() == 3);  // molecule, count, relaxation
  CHECK(column(s, "velocity", "v product").front() == 0);
  AnalysisSettings settings;
  settings.what = {"msd"};
  Frames refused(free_flight(one, 30, MasslessSites::keep));
  CHECK_THROWS_WITH_AS(analyze(refused, one, settings), doctest::Contains("there is only one"),
                       Error);
}
