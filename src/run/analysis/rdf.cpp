// SPDX-License-Identifier: MIT
// Radial distribution functions of pairs of sites, with their first peaks.
#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "base/suggest.hpp"
#include "curves.hpp"
#include "polhode/base/error.hpp"
#include "polhode/measure/radial_distribution.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

using Peak = RadialDistribution::Peak;

// Maximum number of bins. A curve needs fewer bins, and even this number of bins can be stored for
// every pair of sites.
constexpr double max_bins = 1e5;

std::vector<SitePair> pairs_of(const FirstFrames& f) {
  return f.settings.pairs.empty() ? site_pairs(f.analysis.topology) : f.settings.pairs;
}

std::string why_no_pairs(const FirstFrames& f) {
  return pairs_of(f).empty() ? "no two molecules have sites with mass" : "";
}

/// Checks a pair of sites.
/// @throws Error  if only one molecule has the sites of the pair; RadialDistribution detects names
///   that do not exist
void check_pair(const SitePair& pair, const Topology& topology) {
  for (const std::string& word : pair)
    if (molecules_with(topology, word).empty()) return;
  if (count_pairs(topology, pair) > 0) return;
  throw Error(
      fmt::format("there is no g(r) of '{}-{}': g(r) needs sites of two molecules, but only one "
                  "molecule has these sites; leave this pair out",
                  pair[0], pair[1]));
}

RadialSettings settings_of(const FirstFrames& f) {
  const double bin = f.settings.bin, half = f.analysis.box.shortest_edge() / 2;
  const double cutoff = f.settings.cutoff.value_or(std::min(default_rdf_cutoff, half));
  RadialSettings settings{pairs_of(f), cutoff, bin};
  for (const SitePair& pair : settings.pairs) check_pair(pair, f.analysis.topology);
  if (bin > cutoff)
    throw Error(fmt::format(
        "bins of {:g} nm are wider than the maximum distance of g(r), {:.4g} nm{}; give narrower "
        "bins, or a longer cutoff of at most half of the shortest box edge ({:.4g} nm)",
        bin, cutoff, f.settings.cutoff ? "" : " by default", half));
  if (!(cutoff / bin <= max_bins))
    throw Error(
        fmt::format("with a width of {:g} nm there are {:g} bins up to {:g} nm; the maximum is "
                    "{:g} bins, so give a larger width",
                    bin, cutoff / bin, cutoff, max_bins));
  return settings;
}

std::string text_of(const SitePair& sites, const std::optional<Peak>& peak) {
  const auto& [a, b] = sites;
  if (!peak) return "no peak within its range";
  std::string text =
      fmt::format("first peak {} at {} nm; ", short_text(peak->height), short_text(peak->position));
  if (!peak->shell) return text + "no minimum within its range";
  const auto& [end, around_first, around_second] = *peak->shell;
  text += fmt::format("within {:.3f} nm {} {} around each {}", end.value, short_text(around_first),
                      b, a);
  if (a != b) text += fmt::format(", {} {} around each {}", short_text(around_second), a, b);
  return text;
}

/// Position, height, minimum and coordination numbers of a peak; null if there is no peak.
Quantities quantities_of(const SitePair& sites, const std::optional<Peak>& peak) {
  const bool shell = peak && peak->shell;
  return {{"pair", "", std::vector<std::string>{sites[0], sites[1]}},
          {"peak", "nm", peak ? Value(peak->position) : Value()},
          {"peak_height", "", peak ? Value(peak->height) : Value()},
          {"minimum", "nm", shell ? Value(peak->shell->end.value) : Value()},
          {"coordination", "", shell ? Value(peak->shell->coordination) : Value()},
          {"coordination_of_second", "", shell ? Value(peak->shell->of_second) : Value()},
          row(fmt::format("g {}-{}", sites[0], sites[1]), text_of(sites, peak))};
}

/// The time-step biases of the position, height and coordination number of a peak.
Quantities bias_of(const Peak& bias, const Peak& peak) {
  return {
      {"step_bias", "",
       Quantities{{"peak", "nm", bias.position},
                  {"peak_height", "", bias.height},
                  {"coordination", "", bias.shell ? Value(bias.shell->coordination) : Value()}}},
      row("  time-step bias",
          fmt::format("height {}; position {} nm", bias_text(bias.height, peak.height.value),
                      bias_text(bias.position, peak.position.value)))};
}

class Rdf : public Observable {
 public:
  explicit Rdf(const FirstFrames& f)
      : pairs_(pairs_of(f)), radial_(f.analysis.topology, settings_of(f)) {}
  void add(const State& state, const std::optional<StepError>& error, Workers& workers) override {
    radial_.add(state, workers, error);
  }
  ObservableResults results(const AllFrames& frames) override;

 private:
  AnalysisFile file() const;

  std::vector<SitePair> pairs_;
  RadialDistribution radial_;
};

/// Adds a note if a selection has sites of several kinds of molecules.
void note_pooled(const std::vector<SitePair>& pairs, const AllFrames& all) {
  std::set<std::string> noted;
  for (const SitePair& pair : pairs)
    for (const std::string& word : pair) {
      const std::vector<std::string> kinds = molecules_with(all.analysis.topology, word);
      if (kinds.size() < 2 || !noted.insert(word).second) continue;
      all.notes.push_back(
          fmt::format("g(r) of '{0}' includes the sites of {1}; '{2}:{0}' selects one molecule",
                      word, join_names(kinds), kinds.front()));
    }
}

AnalysisFile Rdf::file() const {
  AnalysisFile file =
      file_over("rdf", "r", "nm", radial_.bins(), [&](std::size_t k) { return radial_.middle(k); },
                {{}, "radial distribution of sites", "r  (nm)", "g"});
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const std::string name = pairs_[p][0] + "-" + pairs_[p][1];
    const std::vector<SeriesEstimate> g = radial_.g(p);
    CurvesFigure::Panel panel{name, {}};
    draw(panel, "", polhode::add(file.table, "g " + name, "1", g), g);
    file.figure.panels.push_back(std::move(panel));
    file.table.columns.push_back({"coordination " + name, "1"});
    const std::vector<double> n = radial_.coordination(p);
    for (std::size_t k = 0; k < n.size(); ++k) file.table.rows[k].emplace_back(n[k]);
  }
  finish(file.figure, true);
  return file;
}

ObservableResults Rdf::results(const AllFrames& all) {
  const Analysis& a = all.analysis;
  note_pooled(pairs_, all);
  std::vector<Quantities> list;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const std::optional<Peak> peak = radial_.first_peak(p);
    list.push_back(quantities_of(pairs_[p], peak));
    if (a.frames_with_step_error == 0) continue;
    const double n = degrees_of_freedom(a.topology).all();
    if (const auto bias = radial_.first_peak_bias(p, n, *a.fixed))
      append(list.back(), bias_of(*bias, *peak));
  }
  return {.quantities = {{"rdf", "", std::move(list)}}, .files = {file()}};
}

}  // namespace

ObservableKind rdf() {
  return {"rdf", {"rdf"}, false, why_no_pairs, [](const FirstFrames& f) {
            return std::make_unique<Rdf>(f);
          }};
}

}  // namespace polhode
