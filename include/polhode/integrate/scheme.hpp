// SPDX-License-Identifier: MIT
// A splitting scheme as data: a palindrome of drifts e^{aAh} and kicks e^{bB̂(ξ)h} (vanzon2008, Eq.
// 1).
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>

namespace polhode {

enum class Flow { drift, kick };

/// One factor of the propagator.
struct Stage {
  Flow flow = Flow::drift;
  double fraction = 0;  ///< of the step h
  double xi = 0;        ///< ξ of a gradient kick (vanzon2008, Eqs. 4 to 7); 0 for a plain one
  friend constexpr bool operator==(const Stage&, const Stage&) = default;
};

constexpr Stage A(double a) { return {Flow::drift, a, 0}; }
constexpr Stage B(double b, double xi = 0) { return {Flow::kick, b, xi}; }

/// A scheme. Anyone's line in a table is checked when it is compiled: the constructor runs at
/// compile time and refuses one whose drifts or kicks do not sum to one step.
class Scheme {
 public:
  static constexpr std::size_t most_stages = 64;

  /// @param half    the stages up to and including the middle one; the rest is their mirror image
  /// @param source  key in docs/references.bib
  consteval Scheme(std::string_view name, int order, std::initializer_list<Stage> half,
                   std::string_view source)
      : name_(name), source_(source), order_(order) {
    for (const Stage& stage : half) stages_[count_++] = stage;
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
  constexpr int order() const { return order_; }  ///< declared; 0 if unknown
  constexpr std::span<const Stage> stages() const { return {stages_.data(), count_}; }

  /// Force evaluations per step when steps follow each other: a kick whose positions are still
  /// those of the kick before costs nothing, a gradient kick by finite difference costs one more.
  constexpr int force_evaluations() const {
    int n = 0;
    bool known = stages_[count_ - 1].flow == Flow::kick;  // by the end of the step before
    for (std::size_t i = 0; i < count_; ++i) {
      if (stages_[i].flow == Flow::drift) {
        known = false;
        continue;
      }
      const bool merged = i + 1 == count_ && mergeable();  // with the next step's first kick
      n += (known ? 0 : 1) + (stages_[i].xi != 0 && !merged ? 1 : 0);
      known = true;
    }
    return n;
  }

  /// The last stage of one step and the first of the next are one flow.
  constexpr bool mergeable() const { return count_ > 1 && palindromic(); }

  /// Gradient kicks per step.
  constexpr int gradient_kicks() const {
    int n = 0;
    for (const Stage& stage : stages())
      if (stage.xi != 0) ++n;
    if (mergeable() && stages_[0].xi != 0) --n;  // the last one is the next step's first
    return n;
  }
  constexpr bool has_gradient() const { return gradient_kicks() > 0; }

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

  /// Both flows advance by one step, to the rounding of as many sums of decimal coefficients.
  constexpr bool consistent() const {
    const auto one = [](double x) { return x - 1 < 1e-14 && 1 - x < 1e-14; };
    return one(total(Flow::drift)) && one(total(Flow::kick));
  }

 private:
  std::string_view name_, source_;
  int order_;
  std::array<Stage, most_stages> stages_{};
  std::size_t count_ = 0;
};

}  // namespace polhode
