// SPDX-License-Identifier: MIT
#include "polhode/integrate/force_program.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/integrate/step.hpp"

using namespace polhode;

namespace {

bool fits(const Scheme& scheme) {
  return scheme.starts_with_kick() && !scheme.has(Gradient::exact);
}

/// One anharmonic degree of freedom, whose forces are evaluated only where a program says.
struct Oscillator {
  double q = 1, p = 0.25, force = 0, displaced = 0;
  static constexpr double lambda = 0.01;
  static double force_at(double q) { return -q - q * q * q; }
  void drift(double t) { q += t * p; }
  void kick(double t) { p += t * force; }
  void kick(double t, double, Gradient) {
    p += t * force;
    p += t / lambda * (displaced - force);
  }
};

/// The same for step(), which asks for forces itself.
struct Asking : Oscillator {
  void kick(double t) {
    force = force_at(q);
    Oscillator::kick(t);
  }
  void kick(double t, double xi_h2, Gradient gradient) {
    force = force_at(q);
    displaced = force_at(q + 2 * xi_h2 * lambda * force);
    Oscillator::kick(t, xi_h2, gradient);
  }
};

void play_program(const Scheme& scheme, Oscillator& o, double h) {
  for (const ForceEvaluation& e : force_program(scheme)) {
    play(scheme.stages().subspan(e.first, e.use - e.first), o, h, {0, e.first});
    if (e.xi != 0)
      o.displaced = Oscillator::force_at(o.q + 2 * e.xi * h * h * Oscillator::lambda * o.force);
    else
      o.force = Oscillator::force_at(o.q);
    play(scheme.stages().subspan(e.use, e.end - e.use), o, h, {0, e.use});
  }
}

}  // namespace

TEST_CASE("a program has as many evaluations as the scheme counts, and every stage once") {
  for (const Scheme& scheme : schemes) {
    if (!fits(scheme)) continue;
    CAPTURE(scheme.name());
    const auto program = force_program(scheme);
    CHECK(static_cast<int>(program.size()) == scheme.force_evaluations());
    std::size_t next = 0;
    for (const ForceEvaluation& e : program) {
      CHECK(e.first == next);
      CHECK(e.use >= e.first);
      CHECK(e.end >= e.use);
      next = e.end;
    }
    CHECK(next == scheme.stages().size());
  }
}

TEST_CASE("a program makes the same trajectory as step(), bit for bit") {
  std::vector<Scheme> all(schemes.begin(), schemes.end());
  all.push_back(scheme_of("B(1/4, 0.01, fd) A(1/2) B(1/2) A(1/2) B(1/4, 0.01, fd)"));
  all.push_back(scheme_of("B(1) A(1)"));
  for (const Scheme& scheme : all) {
    if (!fits(scheme)) continue;
    CAPTURE(scheme.name());
    Asking asking;
    Oscillator played;
    played.force = Oscillator::force_at(played.q);
    for (int n = 0; n < 10; ++n) {
      step(scheme, asking, 0.1);
      play_program(scheme, played, 0.1);
    }
    CHECK(played.q == asking.q);
    CHECK(played.p == asking.p);
  }
}

TEST_CASE("a scheme that begins with a drift has one evaluation more") {
  const Scheme verlet = scheme_of("position-verlet");
  CHECK(force_program(verlet).size() == 2);
  CHECK_THROWS_AS(force_program(scheme_of("gier4")), Error);
}
