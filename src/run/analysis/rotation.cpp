// SPDX-License-Identifier: MIT
// Reorientation of the axes of molecules, with relaxation times.
#include <fmt/core.h>

#include <array>

#include "convergence_results.hpp"
#include "curves.hpp"
#include "measure/reorientation.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

constexpr const char* not_decayed =
    "not converged: the correlation is still above 1/e³ at the maximum lag; use a longer window, "
    "and a run of at least eight windows";

Quantities quantities_of(const std::optional<RelaxationTimes>& t) {
  if (!t) return {{"converged", "", false}, {"reason", "", not_decayed}};
  return {{"integral", "ps", converging(t->integral, t->convergence, decay_time)},
          {"exponential", "ps", converging(t->exponential, t->convergence, decay_time)},
          {"fit", "ps", std::vector{t->from, t->to}}};
}

std::string text_of(const std::optional<RelaxationTimes>& t) {
  if (!t) return not_decayed;
  if (!t->convergence.converged()) return not_converged(t->convergence, decay_time);
  return fmt::format("{} ps by integral, {} ps by exponential ({:g} to {:g} ps)",
                     short_text(t->integral), short_text(t->exponential), t->from, t->to);
}

/// Adds the correlation functions P₁ and P₂ of one kind of molecule, side by side.
Quantities add_reorientations(AnalysisFile& file, Reorientation& reorientation, std::size_t part,
                              const AllFrames& all) {
  const Analysis& a = all.analysis;
  const auto& [molecule, count] = a.topology.parts[part];
  std::array<CurvesFigure::Panel, 2> panels{
      {{of_part(a, part, "P₁"), {}}, {of_part(a, part, "P₂"), {}}}};
  Quantities axes, rows;
  for (std::size_t axis = 0; axis < reorientation.axes(part).size(); ++axis) {
    const std::string& name = reorientation.axes(part)[axis].name;
    Quantities ranks;
    for (const int rank : {1, 2}) {
      const BlockMeans C = reorientation.legendre(part, axis, rank, all.workers);
      const std::vector<SeriesEstimate> P = series_estimates(C);
      if (file.name.empty())
        file = file_of_lags("rotation", P.size(), a.interval,
                            {{}, "reorientation of body axes", "lag  (ps)", "P₁, P₂"});
      const std::string label = fmt::format("P{}", rank);
      draw(panels[static_cast<std::size_t>(rank - 1)], name,
           add(file.table, of_part(a, part, label + " " + name), "1", P), P);
      if (count == 0) continue;
      const std::optional<RelaxationTimes> times = relaxation_times(C, a.interval);
      ranks.push_back({label, "", quantities_of(times)});
      rows.push_back(row(label + " " + molecule.name + " " + name, text_of(times)));
    }
    if (count > 0) axes.push_back({name, "", std::move(ranks)});
  }
  file.figure.panels.insert(file.figure.panels.end(), panels.begin(), panels.end());
  if (!axes.empty()) rows.push_back({"relaxation", "", std::move(axes)});
  return rows;
}

ObservableResults rotation_results(Reorientation& reorientation, const AllFrames& all) {
  ObservableResults results;
  AnalysisFile file;
  for (std::size_t part = 0; part < all.analysis.topology.parts.size(); ++part)
    results.parts.push_back(add_reorientations(file, reorientation, part, all));
  file.figure.across = 2;
  finish(file.figure, false);
  results.files.push_back(std::move(file));
  return results;
}

}  // namespace

ObservableKind rotation() {
  return correlated<Reorientation>(
      "rotation", {"rotation"}, [](const FirstFrames&) { return std::string(); }, rotation_results);
}

}  // namespace polhode
