// SPDX-License-Identifier: MIT
// Steps played on flows that are written by hand.
#include "polhode/integrate/step.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "polhode/integrate/body_flows.hpp"
#include "polhode/integrate/joined_flows.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"

using namespace polhode;

namespace {

struct Call {
  Flow flow;
  double t, xi_h2 = 0;
  StageNumber at{};
  friend bool operator==(const Call&, const Call&) = default;
};

// Drifts and kicks that only write down what they are asked for.
struct PlainRecord {
  std::vector<Call> calls;
  void drift(double t) { calls.push_back({Flow::drift, t}); }
  void kick(double t) { calls.push_back({Flow::kick, t}); }
};

// The same with all that a scheme may have.
struct Record {
  std::vector<Call> calls;
  void drift(double t) { calls.push_back({Flow::drift, t}); }
  void kick(double t, double xi_h2 = 0, Gradient = Gradient::exact) {
    calls.push_back({Flow::kick, t, xi_h2});
  }
  void bath(double t, StageNumber at) { calls.push_back({Flow::bath, t, 0, at}); }
};

}  // namespace

// h = 2 and fractions that are sums of powers of two: all numbers are exact.
TEST_CASE("a step plays the stages of its scheme in order, each for its part of h") {
  const Scheme scheme = scheme_of("B(1/4) A(1/2) O(1) B(1/2, 1/8) A(1/2) B(1/4)");
  Record record;
  step(scheme, record, 2.0, 7);
  const std::vector<Call> expected{
      {Flow::kick, 0.5},      {Flow::drift, 1.0}, {Flow::bath, 2.0, 0, {7, 2}},
      {Flow::kick, 1.0, 0.5}, {Flow::drift, 1.0}, {Flow::kick, 0.5}};
  CHECK((record.calls == expected));
}

TEST_CASE("flows that lack a stage of the scheme are refused before they move") {
  PlainRecord record;
  check_error([&] { step(scheme_of("gier4"), record, 1.0); },
              {"has gradient kicks", "a scheme without gradient kicks"});
  check_error([&] { step(scheme_of("B(1/2) A(1/2) O(1) A(1/2) B(1/2)"), record, 1.0); },
              {"has a bath", "leave the stages O out"});
  CHECK(record.calls.empty());
  step(scheme_of("velocity-verlet"), record, 1.0);
  CHECK(record.calls.size() == 3);
}

TEST_CASE("adjacent drifts and kicks are applied as one, baths one by one") {
  const auto joined_calls = [](const char* text, bool join_drifts = true) {
    Record record;
    JoinedFlows joined(record, join_drifts);
    for (const std::uint64_t number : {0u, 1u}) step(scheme_of(text), joined, 1.0, number);
    joined.flush();
    joined.flush();  // nothing is left
    return record.calls;
  };
  const Call half_kick{Flow::kick, 0.5}, kick{Flow::kick, 1}, half{Flow::drift, 0.5},
      whole{Flow::drift, 1};
  CHECK((joined_calls("B(1/2) A(1) B(1/2)") ==
         std::vector{half_kick, whole, kick, whole, half_kick}));
  CHECK((joined_calls("A(1/4) A(1/4) B(1) A(1/2)") == std::vector{half, kick, whole, kick, half}));
  CHECK((joined_calls("A(1/2) B(1) A(1/2)", false) ==
         std::vector{half, kick, half, half, kick, half}));
  // Kicks join where their gradients are alike.
  const Call gradient{Flow::kick, 1, 0.25};
  CHECK((joined_calls("B(1/2, 1/4) A(1) B(1/2, 1/4)")[2] == gradient));
  CHECK(joined_calls("B(1/2, 1/4) A(1) B(1/2)").size() == 6);
  const auto bath = [](double t, std::uint64_t number, std::size_t stage) {
    return Call{Flow::bath, t, 0, {number, stage}};
  };
  CHECK((joined_calls("O(1/2) B(1) A(1) O(1/2)") == std::vector{bath(0.5, 0, 0), kick, whole,
                                                                bath(0.5, 0, 3), bath(0.5, 1, 0),
                                                                kick, whole, bath(0.5, 1, 3)}));
}

namespace {

struct Pull {
  void operator()(std::span<const RigidBody> bodies, std::span<BodyLoad> loads) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) loads[i] = {-100 * bodies[i].q, {}};
  }
};

struct IdleBodies : BodyFlows<Pull> {
  using BodyFlows::BodyFlows;
  int baths = 0;
  void bath(double, StageNumber) { ++baths; }
};

}  // namespace

// Bodies by themselves take every gradient by finite difference: one evaluation more.
TEST_CASE("bodies by themselves evaluate forces as often as the scheme says, baths or not") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    for (const bool with_baths : {false, true}) {
      std::vector<Stage> stages;
      for (const Stage& stage : scheme.stages()) {
        stages.push_back(stage);
        if (with_baths) stages.push_back(O(1.0 / double(scheme.stages().size())));
      }
      const Scheme played(stages, scheme.order());
      REQUIRE(played.consistent());
      std::array bodies{RigidBody{.q = {0.1, 0.2, 0.3}}, RigidBody{.q = {0.3, 0, 0}}};
      IdleBodies flows(bodies, Pull{});
      step(played, flows, 0.001);
      const int first = flows.evaluations();
      for (int n = 0; n < 10; ++n) step(played, flows, 0.001);
      CHECK(flows.evaluations() - first ==
            10 * (scheme.force_evaluations() + scheme.derivatives()));
      CHECK(flows.baths == (with_baths ? 11 * int(scheme.stages().size()) : 0));
    }
  }
}
