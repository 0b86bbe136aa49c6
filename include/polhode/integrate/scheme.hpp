// SPDX-License-Identifier: MIT
// A splitting scheme as data: a palindrome of drifts e^{aAh} and kicks e^{bB̂(ξ)h} [vanzon2008, Eq.
// 1], and of baths if the temperature is controlled.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>

namespace polhode {

/// The flow that a stage applies. Code that depends on the flow uses a `switch` without `default`.
/// The compiler then reports every switch in which a new flow is missing.
enum class Flow {
  drift,  ///< free flight and free rotation: changes positions and orientations
  kick,   ///< forces and torques act: changes momenta
  bath,   ///< a heat bath acts: changes momenta, without any forces
};

inline constexpr std::array all_flows{Flow::drift, Flow::kick, Flow::bath};

/// The letter of a flow in scheme texts.
constexpr char letter_of(Flow flow) {
  switch (flow) {
    case Flow::drift:
      return 'A';
    case Flow::kick:
      return 'B';
    case Flow::bath:
      return 'O';
  }
  return '?';
}

constexpr std::string_view name_of(Flow flow) {
  switch (flow) {
    case Flow::drift:
      return "drift";
    case Flow::kick:
      return "kick";
    case Flow::bath:
      return "bath";
  }
  return "";
}

/// How a gradient kick obtains ∇W.
enum class Gradient {
  exact,              ///< uses the derivative of the forces; the scheme is symplectic
  finite_difference,  ///< uses forces at displaced positions [vanzon2008, Eqs. 6 and 7]
};

/// One stage of a scheme: a factor of its propagator.
struct Stage {
  Flow flow = Flow::drift;
  double fraction = 0;  ///< fraction of the step h
  double xi = 0;        ///< ξ of a gradient kick [vanzon2008, Eqs. 4 to 7]; 0 for a plain kick
  Gradient gradient = Gradient::exact;
  constexpr bool has(Gradient which) const { return xi != 0 && gradient == which; }
  /// Whether this stage and the following stage `next` can be joined. Baths cannot be joined,
  /// because each has separate random numbers.
  constexpr bool joins(const Stage& next) const {
    switch (flow) {
      case Flow::drift:
        return next.flow == Flow::drift;
      case Flow::kick:
        return next.flow == Flow::kick && next.xi == xi && (xi == 0 || next.gradient == gradient);
      case Flow::bath:
        return false;
    }
    return false;
  }
  friend constexpr bool operator==(const Stage&, const Stage&) = default;
};

constexpr Stage A(double a) { return {Flow::drift, a, 0}; }
constexpr Stage B(double b, double xi = 0, Gradient gradient = Gradient::exact) {
  return {Flow::kick, b, xi, gradient};
}
constexpr Stage O(double c) { return {Flow::bath, c, 0}; }

/// Cost of the derivative of the forces, in units of one force evaluation, as measured for 512
/// four-site waters with bench/micro/forces.cpp (docs/gradient.md).
inline constexpr double derivative_cost = 2.0;

/// Placeholder for the remaining fraction of a flow, so that its fractions sum to one step.
inline constexpr double rest = std::numeric_limits<double>::quiet_NaN();

/// A scheme. A line that a user adds to the table of schemes is checked at compile time. The
/// consteval constructor rejects a scheme if the fractions of its drifts, kicks or baths do not sum
/// to one step.
class Scheme {
 public:
  static constexpr std::size_t max_stages = 64, max_name = 32;

  /// @param half    stages up to and including the middle stage; the other stages are their mirror
  ///   image. In each flow, one stage may have the fraction `rest`
  /// @param source  key in docs/references.bib
  consteval Scheme(std::string_view name, int order, std::initializer_list<Stage> half,
                   std::string_view source)
      : name_(name), source_(source), order_(order) {
    for (const Stage& stage : half) stages_[count_++] = stage;
    for (const Flow flow : all_flows) complete(flow);
    for (std::size_t i = count_ - 1; i-- > 0;) stages_[count_++] = stages_[i];
    if (!consistent()) throw "the coefficients of drifts, of kicks or of baths do not sum to 1";
  }

  /// A scheme whose stages are known only at run time: see scheme_of().
  /// @param name  name with at most max_name characters; may be empty
  constexpr Scheme(std::span<const Stage> stages, int order, std::string_view name = "")
      : name_("custom"), source_(""), order_(order) {
    for (const Stage& stage : stages) stages_[count_++] = stage;
    for (const char c : name) own_name_[own_name_size_++] = c;
  }

  /// The name of the scheme in the table, or the user-given name, which this object stores;
  /// "custom" if it has no name.
  constexpr std::string_view name() const {
    return has_own_name() ? std::string_view(own_name_.data(), own_name_size_) : name_;
  }
  constexpr bool has_own_name() const { return own_name_size_ > 0; }
  constexpr bool in_table() const { return !source_.empty(); }
  constexpr std::string_view source() const { return source_; }
  constexpr int order() const { return order_; }  ///< order of the scheme as declared; 0 if unknown
  constexpr std::span<const Stage> stages() const { return {stages_.data(), count_}; }

  /// Number of force evaluations per step in a sequence of steps. Baths, and kicks at the positions
  /// of the previous kick, need no evaluation. A gradient kick by finite difference costs one
  /// additional evaluation.
  constexpr int force_evaluations() const { return evaluations().forces; }
  /// Number of derivative evaluations per step: one for each exact gradient kick.
  constexpr int derivatives() const { return evaluations().derivatives; }
  /// Total cost of force evaluations and derivatives per step, in units of one force evaluation.
  constexpr double cost() const { return force_evaluations() + derivative_cost * derivatives(); }

  constexpr bool has(Flow flow) const {
    for (const Stage& stage : stages())
      if (stage.flow == flow) return true;
    return false;
  }
  constexpr bool has(Gradient gradient) const {
    for (const Stage& stage : stages())
      if (stage.has(gradient)) return true;
    return false;
  }
  /// Number of gradient kicks per step. The last kick of a step may be joined with the first kick
  /// of the next step.
  constexpr int gradient_kicks() const {
    int n = 0;
    for (std::size_t i = 0; i < count_; ++i) n += stages_[i].xi != 0 && !joins_next(i) ? 1 : 0;
    return n;
  }

  /// Whether a step begins with a kick, not counting baths.
  constexpr bool starts_with_kick() const {
    for (std::size_t i = 0; i < count_; ++i)
      if (stages_[i].flow != Flow::bath) return stages_[i].flow == Flow::kick;
    return false;
  }
  /// Whether a step ends with a kick, not counting baths.
  constexpr bool ends_with_kick() const {
    for (std::size_t i = count_; i-- > 0;)
      if (stages_[i].flow != Flow::bath) return stages_[i].flow == Flow::kick;
    return false;
  }

  /// Whether a bath acts between drifts and kicks.
  constexpr bool bath_within() const {
    for (std::size_t i = 1; i + 1 < count_; ++i)
      if (stages_[i].flow == Flow::bath) return true;
    return false;
  }
  /// Fraction of the plain kick that ends a step, if only drifts separate the kick from a bath;
  /// otherwise 0. Subtracting this kick recovers the momenta right after the bath.
  constexpr double kick_after_bath() const {
    if (count_ == 0 || stages_[count_ - 1].flow != Flow::kick || stages_[count_ - 1].xi != 0)
      return 0;
    for (std::size_t i = count_ - 1; i-- > 0;) {
      if (stages_[i].flow == Flow::bath) return stages_[count_ - 1].fraction;
      if (stages_[i].flow == Flow::kick) return 0;
    }
    return 0;
  }

  constexpr bool palindromic() const {
    for (std::size_t i = 0; i < count_; ++i)
      if (stages_[i] != stages_[count_ - 1 - i]) return false;
    return true;
  }

  /// The sum of all fractions of one flow. The sum is 1 for a consistent scheme, and 0 for baths in
  /// a scheme without baths.
  constexpr double total(Flow flow) const {
    double sum = 0;
    for (const Stage& stage : stages())
      if (stage.flow == flow) sum += stage.fraction;
    return sum;
  }

  /// Whether the fractions of each flow in the scheme sum to one step, within the round-off of
  /// decimal coefficients.
  constexpr bool consistent() const {
    const auto one = [](double x) { return x - 1 < 1e-14 && 1 - x < 1e-14; };
    return one(total(Flow::drift)) && one(total(Flow::kick)) &&
           (!has(Flow::bath) || one(total(Flow::bath)));
  }

 private:
  struct Evaluations {
    int forces = 0, derivatives = 0;
  };
  constexpr Evaluations evaluations() const {
    Evaluations n;
    bool known = ends_with_kick();  // known from the end of the previous step
    for (std::size_t i = 0; i < count_; ++i) switch (stages_[i].flow) {
        case Flow::drift:
          known = false;
          break;
        case Flow::kick:
          n.forces += known ? 0 : 1;
          n.forces += stages_[i].has(Gradient::finite_difference) && !joins_next(i) ? 1 : 0;
          n.derivatives += stages_[i].has(Gradient::exact) && !joins_next(i) ? 1 : 0;
          known = true;
          break;
        case Flow::bath:  // positions and forces stay the same
          break;
      }
    return n;
  }

  /// Whether a stage is joined with the following stage, which may belong to the next step.
  constexpr bool joins_next(std::size_t i) const {
    return count_ > 1 && stages_[i].joins(stages_[(i + 1) % count_]);
  }

  /// Replaces the `rest` of a flow by its value; at this point, stages_ holds only the stages up to
  /// the middle stage.
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
  std::array<char, max_name> own_name_{};
  std::size_t own_name_size_ = 0;
  std::array<Stage, max_stages> stages_{};
  std::size_t count_ = 0;
};

}  // namespace polhode
