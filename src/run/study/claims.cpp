// SPDX-License-Identifier: MIT
#include "run/study/claims.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/prediction.hpp"

namespace polhode {
namespace {

const Curve* find(const std::vector<Curve>& curves, const std::string& scheme) {
  const auto it = std::find_if(curves.begin(), curves.end(),
                               [&](const Curve& c) { return c.scheme == scheme; });
  return it == curves.end() ? nullptr : &*it;
}

Verdict worst(Verdict a, Verdict b) {
  if (a == Verdict::not_reproduced || b == Verdict::not_reproduced) return Verdict::not_reproduced;
  return a == Verdict::undecided || b == Verdict::undecided ? Verdict::undecided
                                                            : Verdict::reproduced;
}

/// The verdict on whether R of a point is above a limit: reproduced if R is significantly above the
/// limit, not reproduced if R is significantly below.
Verdict above(const EfficiencyPoint& point, double limit) {
  const double R = point.ratio.value,
               off = confidence_half_width({point.ratio.error, point.runs - 1.0});
  if (R - off > limit) return Verdict::reproduced;
  return R + off < limit ? Verdict::not_reproduced : Verdict::undecided;
}

Verdict opposite(Verdict v) {
  if (v == Verdict::undecided) return v;
  return v == Verdict::reproduced ? Verdict::not_reproduced : Verdict::reproduced;
}

/// The point with the longest step at which the energy drift is certainly negligible; null if there
/// is no such step.
const EfficiencyPoint* last_conserving(const Curve& c) {
  for (std::size_t i = c.usable; i > 0; --i)
    if (c.points[i - 1].conserves()) return &c.points[i - 1];
  return nullptr;
}

/// The range of R in which a relevant energy drift is excluded, as text: "up to R = 0.54 %", or "at
/// no step".
std::string excluded(const Curve& c) {
  const EfficiencyPoint* const last = last_conserving(c);
  return last ? fmt::format("up to R = {:.2g} %", 100 * last->ratio.value) : "at no step";
}

/// The ratio R of the last step of a curve [%].
std::string reached(const Curve& c) {
  return c.usable == 0 ? "0" : fmt::format("{:.2g}", 100 * c.points[c.usable - 1].ratio.value);
}

/// The verdict on whether a curve has steps above R = `limit` at which the energy drift is
/// certainly negligible. A curve that ends below the limit has no such steps. Between the last step
/// with a negligible drift and the end of the curve, the drift may or may not be negligible.
Verdict runs_above(const Curve& c, double limit) {
  const EfficiencyPoint* const last = last_conserving(c);
  if (last && above(*last, limit) == Verdict::reproduced) return Verdict::reproduced;
  if (c.usable == c.points.size() || !c.points[c.usable].stable) return Verdict::undecided;
  return above(c.points[c.usable], limit) == Verdict::not_reproduced ? Verdict::not_reproduced
                                                                     : Verdict::undecided;
}

/// Whether the points around the ends of curves have the same number of runs. Curves are compared
/// only if their numbers of runs are equal, because more runs detect a smaller energy drift.
bool equal_runs(const std::vector<const Curve*>& curves) {
  std::set<int> runs;
  for (const Curve* c : curves)
    for (const std::size_t i : {c->usable - 1, c->usable})
      if (i < c->points.size()) runs.insert(c->points[i].runs);
  return runs.size() <= 1;
}

}  // namespace

Verdict rounds_to(const Estimate& x, double degrees_of_freedom, double number, double half_digit) {
  const double off = std::abs(x.value - number),
               half = confidence_half_width({x.error, degrees_of_freedom});
  if (off + half <= half_digit) return Verdict::reproduced;
  return off - half > half_digit ? Verdict::not_reproduced : Verdict::undecided;
}

const char* in_words(Verdict verdict) {
  constexpr const char* words[] = {"reproduced", "not reproduced", "not decided by these data"};
  return words[static_cast<std::size_t>(verdict)];
}

std::vector<Claim> paper_claims(const std::vector<Curve>& curves) {
  const Curve* const verlet = find(curves, "velocity-verlet");
  const Curve* const hoa2 = find(curves, "hoa2");
  const Curve* const gier4 = find(curves, "gier4-fd");
  if (!verlet || !hoa2 || !gier4) return {};
  std::vector<Claim> claims;

  for (const double R : {0.01, 0.007, 0.004}) {
    const auto v = cost_at(*verlet, R), h = cost_at(*hoa2, R);
    Claim claim{
        fmt::format("HOA2 is roughly 1.5 times cheaper than Verlet (here at R = {:g} %)", 100 * R),
        std::nullopt, Verdict::undecided};
    if (v && h && !v->at_max_step && !h->at_max_step) {
      const double ratio = v->cost / h->cost;
      const ErrorPart error = summed({{v->error / v->cost, v->degrees_of_freedom},
                                      {h->error / h->cost, h->degrees_of_freedom}});
      claim.value = {ratio, ratio * error.error};
      claim.verdict = rounds_to(*claim.value, error.degrees_of_freedom, 1.5, 0.05);
    }
    claims.push_back(claim);
  }

  Claim crossing{
      "GIER4 is the cheapest below R = 0.4 % (here: the R, in %, at which GIER4 and HOA2 have the "
      "same cost)",
      std::nullopt, Verdict::undecided};
  if (const auto found = crossover(*gier4, *hoa2)) {
    crossing.value = {100 * found->ratio.value, 100 * found->ratio.error};
    crossing.verdict = rounds_to(*crossing.value, found->degrees_of_freedom, 0.4, 0.05);
  }
  claims.push_back(crossing);

  constexpr double limit = 0.015;
  Claim end{fmt::format("above R = 1.5 % only Verlet has no relevant energy drift (the runs "
                        "exclude a relevant drift {} for Verlet, {} for HOA2 and {} for GIER4; "
                        "their curves end at R = {} %, {} % and {} %)",
                        excluded(*verlet), excluded(*hoa2), excluded(*gier4), reached(*verlet),
                        reached(*hoa2), reached(*gier4)),
            std::nullopt, Verdict::undecided};
  if (equal_runs({verlet, hoa2, gier4}))
    end.verdict = worst(runs_above(*verlet, limit), worst(opposite(runs_above(*hoa2, limit)),
                                                          opposite(runs_above(*gier4, limit))));
  claims.push_back(end);
  return claims;
}

}  // namespace polhode
