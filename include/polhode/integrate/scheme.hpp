// SPDX-License-Identifier: MIT
// A splitting scheme as data: a palindrome of drifts e^{aAh} and kicks e^{bB̂(ξ)h} (vanzon2008, Eq.
// 1).
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>

namespace polhode {

enum class Flow { drift, kick };

/// How a gradient kick obtains ∇W.
enum class Gradient {
  exact,              ///< from the derivative of the forces: the scheme is symplectic
  finite_difference,  ///< from forces at displaced positions (vanzon2008, Eqs. 6 and 7)
};

/// One factor of the propagator.
struct Stage {
  Flow flow = Flow::drift;
  double fraction = 0;  ///< of the step h
  double xi = 0;        ///< ξ of a gradient kick (vanzon2008, Eqs. 4 to 7); 0 for a plain one
  Gradient gradient = Gradient::exact;
  constexpr bool has(Gradient which) const { return xi != 0 && gradient == which; }
  friend constexpr bool operator==(const Stage&, const Stage&) = default;
};

constexpr Stage A(double a) { return {Flow::drift, a, 0}; }
constexpr Stage B(double b, double xi = 0, Gradient gradient = Gradient::exact) {
  return {Flow::kick, b, xi, gradient};
}

/// Cost of the derivative of the forces, in force evaluations, as measured for 512 four-site waters
/// with bench/micro/forces.cpp (docs/gradient.md).
inline constexpr double derivative_cost = 2.0;

/// Placeholder for a fraction: whatever is needed for the flow to advance by one step in total.
inline constexpr double rest = std::numeric_limits<double>::quiet_NaN();

/// A scheme. User-defined lines of the table are checked at compile time: the constructor is
/// consteval and rejects schemes whose drifts or kicks do not sum to one step.
class Scheme {
 public:
  static constexpr std::size_t max_stages = 64;

  /// @param half    the stages up to and including the middle one; the rest is their mirror image.
  ///                One stage of each flow may have `rest` as its fraction
  /// @param source  key in docs/references.bib
  consteval Scheme(std::string_view name, int order, std::initializer_list<Stage> half,
                   std::string_view source)
      : name_(name), source_(source), order_(order) {
    for (const Stage& stage : half) stages_[count_++] = stage;
    complete(Flow::drift), complete(Flow::kick);
    for (std::size_t i = count_ - 1; i-- > 0;) stages_[count_++] = stages_[i];
    if (!consistent()) throw "the drifts or the kicks of a scheme do not sum to one";
  }

  /// A scheme of stages known at run time: see parsed_scheme().
  constexpr Scheme(std::span<const Stage> stages, int order)
      : name_("custom"), source_(""), order_(order) {
    for (const Stage& stage : stages) stages_[count_++] = stage;
  }

  constexpr std::string_view name() const { return name_; }
  constexpr std::string_view source() const { return source_; }
  constexpr int order() const { return order_; }  ///< declared order; 0 if unknown
  constexpr std::span<const Stage> stages() const { return {stages_.data(), count_}; }

  /// Force evaluations per step in a sequence of steps: a kick at the positions of the previous
  /// kick costs nothing; a gradient kick by finite difference costs one more.
  constexpr int force_evaluations() const { return evaluations().forces; }
  /// Evaluations of the derivative of the forces per step: one per exact gradient kick.
  constexpr int derivatives() const { return evaluations().derivatives; }
  /// Total cost of both, in force evaluations.
  constexpr double cost() const { return force_evaluations() + derivative_cost * derivatives(); }

  /// Whether the last stage of a step and the first of the next are the same flow.
  constexpr bool mergeable() const { return count_ > 1 && palindromic(); }

  constexpr bool has(Gradient gradient) const {
    for (const Stage& stage : stages())
      if (stage.has(gradient)) return true;
    return false;
  }
  /// Gradient kicks per step.
  constexpr int gradient_kicks() const {
    int n = 0;
    for (const Stage& stage : stages())
      if (stage.xi != 0) ++n;
    if (mergeable() && stages_[0].xi != 0)
      --n;  // the last one is merged with the first one of the
            // next step
    return n;
  }

  constexpr bool palindromic() const {
    for (std::size_t i = 0; i < count_; ++i)
      if (stages_[i] != stages_[count_ - 1 - i]) return false;
    return true;
  }

  /// The sum of all fractions of one flow: 1 for a consistent scheme.
  constexpr double total(Flow flow) const {
    double sum = 0;
    for (const Stage& stage : stages())
      if (stage.flow == flow) sum += stage.fraction;
    return sum;
  }

  /// Whether both flows advance by one step, to the rounding of a sum of decimal coefficients.
  constexpr bool consistent() const {
    const auto one = [](double x) { return x - 1 < 1e-14 && 1 - x < 1e-14; };
    return one(total(Flow::drift)) && one(total(Flow::kick));
  }

 private:
  struct Evaluations {
    int forces = 0, derivatives = 0;
  };
  constexpr Evaluations evaluations() const {
    Evaluations n;
    bool known = stages_[count_ - 1].flow == Flow::kick;  // from the end of the previous step
    for (std::size_t i = 0; i < count_; ++i) {
      if (stages_[i].flow == Flow::drift) {
        known = false;
        continue;
      }
      const bool merged = i + 1 == count_ && mergeable();  // with the first kick of the next step
      n.forces += known ? 0 : 1;
      n.forces += stages_[i].has(Gradient::finite_difference) && !merged ? 1 : 0;
      n.derivatives += stages_[i].has(Gradient::exact) && !merged ? 1 : 0;
      known = true;
    }
    return n;
  }

  /// Replaces the `rest` of a flow by its value; stages_ holds the stages up to the middle one.
  constexpr void complete(Flow flow) {
    double left = 1, share = 0;
    std::size_t open = count_;
    for (std::size_t i = 0; i < count_; ++i) {
      if (stages_[i].flow != flow) continue;
      const double copies = i + 1 == count_ ? 1 : 2;
      if (stages_[i].fraction != stages_[i].fraction)
        open = i, share = copies;
      else
        left -= copies * stages_[i].fraction;
    }
    if (open < count_) stages_[open].fraction = left / share;
  }

  std::string_view name_, source_;
  int order_;
  std::array<Stage, max_stages> stages_{};
  std::size_t count_ = 0;
};

}  // namespace polhode
