// SPDX-License-Identifier: MIT
// The curves of observables as tables with their figures.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "polhode/run/analysis/analysis.hpp"
#include "polhode/run/analysis/observable.hpp"

namespace polhode {

/// The standard error of an estimate; NaN (an empty field in files) if the error is not known.
double known_error(const SeriesEstimate& estimate);

/// An estimate as text, such as "2.300 ± 0.031". If the error is not known, the text is the value
/// and "± ?".
std::string short_text(const SeriesEstimate& estimate);

/// A bias, and the value corrected for it, as text such as "-0.0123 ± 0.0004, without it 2.912".
std::string bias_text(const SeriesEstimate& bias, double value);

/// Adds a column of values and a column of their errors to a table. Returns the corresponding
/// curve, without a name.
CurvesFigure::Curve add(Table& table, const std::string& name, const std::string& unit,
                        const std::vector<SeriesEstimate>& values);

/// Draws a curve with errors in a panel, and extends the axes of the panel accordingly. Nothing is
/// drawn if the curve has no value.
/// @param name  name in the legend; if empty, the curve is not in the legend
void draw(CurvesFigure::Panel& panel, const std::string& name, CurvesFigure::Curve curve,
          const std::vector<SeriesEstimate>& values);

/// Removes panels without curves, and adds space above and below the curves of the other panels.
/// @param from_zero  true if quantities are not negative, so that axes begin at 0
void finish(CurvesFigure& figure, bool from_zero);

/// A table file with the values `at(k)` in the first column.
AnalysisFile file_over(const std::string& name, const std::string& column, const std::string& unit,
                       std::size_t rows, const std::function<double(std::size_t)>& at,
                       CurvesFigure figure);

/// A table file with the lags in the first column.
AnalysisFile file_of_lags(const std::string& name, std::size_t lags, double interval,
                          CurvesFigure figure);

/// A table file over the time analyzed so far, or over the frames if they have no times.
/// @param frames  number of frames so far, for each row
AnalysisFile file_over_time(const Analysis& analysis, const std::string& name,
                            const std::vector<double>& frames, CurvesFigure figure);

/// The name of the molecules of a part; empty if there is only one part.
std::string title_of_part(const Analysis& analysis, std::size_t part);

/// The name of a quantity of one part. If there is only one kind of molecule, its name is omitted.
std::string of_part(const Analysis& analysis, std::size_t part, const std::string& what);

/// An observable that follows from correlations in time.
/// @tparam Correlations  collects the frames, such as Displacement
template <class Correlations>
class Correlated : public Observable {
 public:
  using Results = ObservableResults (*)(Correlations& correlations, const AllFrames& all);
  Correlated(const FirstFrames& first, Results results)
      : correlations_(first.analysis.topology, first.lags), results_(results) {}
  void add(const State& state, const std::optional<StepError>&, Workers& workers) override {
    correlations_.add(state, workers);
  }
  ObservableResults results(const AllFrames& all) override { return results_(correlations_, all); }

 private:
  Correlations correlations_;
  Results results_;
};

/// The entry of such an observable in the list of observables.
template <class Correlations>
ObservableKind correlated(const std::string& name, const std::vector<std::string>& files,
                          std::string (*why_not)(const FirstFrames&),
                          typename Correlated<Correlations>::Results results) {
  return {name, files, true, why_not, [results](const FirstFrames& first) {
            return std::make_unique<Correlated<Correlations>>(first, results);
          }};
}

}  // namespace polhode
