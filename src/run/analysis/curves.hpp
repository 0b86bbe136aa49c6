// SPDX-License-Identifier: MIT
// The curves of observables as tables with their figures.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "polhode/run/analysis/analysis.hpp"
#include "polhode/run/analysis/observable.hpp"

namespace polhode {

/// The standard error; an empty field if it is not known.
double known_error(const SeriesEstimate& estimate);

/// "2.300 ± 0.031", or the value and "± ?".
std::string short_text(const SeriesEstimate& estimate);

/// "-0.0123 ± 0.0004, without it 2.912": a bias, and the value without it.
std::string bias_text(const SeriesEstimate& bias, double value);

/// Adds a column of values, and a column of their errors; returns the curve that they are, without
/// a name.
CurvesFigure::Curve add(Table& table, const std::string& name, const std::string& unit,
                        const std::vector<SeriesEstimate>& values);

/// Draws a curve in a panel, which grows to hold it with its errors; nothing without a value.
/// @param name  in the legend; empty: not there
void draw(CurvesFigure::Panel& panel, const std::string& name, CurvesFigure::Curve curve,
          const std::vector<SeriesEstimate>& values);

/// Leaves out panels without curves, and leaves room above and below the others.
/// @param from_zero  quantities are not negative, and axes begin at 0
void finish(CurvesFigure& figure, bool from_zero);

/// A file whose first column has the values `at(k)`.
AnalysisFile file_over(const std::string& name, const std::string& column, const std::string& unit,
                       std::size_t rows, const std::function<double(std::size_t)>& at,
                       CurvesFigure figure);

/// A file whose first column is the lag.
AnalysisFile file_of_lags(const std::string& name, std::size_t lags, double interval,
                          CurvesFigure figure);

/// A file over the time analyzed so far, or over its frames if they have no times.
/// @param frames  number of frames so far, for each row
AnalysisFile file_over_time(const Analysis& analysis, const std::string& name,
                            const std::vector<double>& frames, CurvesFigure figure);

/// The name of the molecules of a part; empty if there is only one part.
std::string title_of_part(const Analysis& analysis, std::size_t part);

/// The name of a quantity of one part; if there is only one molecule, its name is omitted.
std::string of_part(const Analysis& analysis, std::size_t part, const std::string& what);

}  // namespace polhode
