// SPDX-License-Identifier: MIT
#include "io/figures/plot.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/figures/figure_script.hpp"

using namespace polhode;
namespace fs = std::filesystem;

namespace {

// A separate folder that is removed afterwards, and the search path is restored.
struct Place {
  fs::path folder = fs::temp_directory_path() /
                    ("polhode-plot-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  std::string search_path = std::getenv("PATH");
  Place() { fs::create_directories(folder); }
  ~Place() {
    setenv("PATH", search_path.c_str(), 1);
    fs::remove_all(folder);
  }
};

std::string script_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

constexpr const char* shell =
    "/"
    "bin/sh";

/// The table of a study with two schemes, of which the first has a step that is too long.
EfficiencyFigure study_in(const fs::path& folder, const std::string& name) {
  const std::string csv = (folder / (name + ".csv")).string();
  std::ofstream(csv) << "scheme,step [fs],cost [1/ps],usable [1],R [1],R_error [1],rounded [1]\n"
                        "# polhode\n"
                        "hoa2,2,1000,1,0.001,1e-4,0\nhoa2,8,250,1,0.012,1e-3,0\n"
                        "hoa2,10,200,0,,,0\n"
                        "gier4,1,3000,1,1e-6,1e-7,1\ngier4,10,300,1,0.02,,0\n";
  return {csv, {{"hoa2", 0, 2}, {"gier4", 3, 4}}, "four runs"};
}

AdviceFigure advice_in(const fs::path& folder) {
  const std::string csv = (folder / "advice.csv").string();
  std::ofstream(csv) << "scheme,step [fs],usable [1],R [1],R_error [1]\n# polhode\n"
                        "hoa2,4,1,0.008,0.001\nhoa2,5,1,0.013,0.001\nhoa2,9,0,,\n"
                        "gier4,5,1,0.002,0.0001\nhoa2,4.4,1,0.0097,0.001\n";
  return {
      csv, {{{"hoa2", 0, 2}, 4.5, 1.2, 0.01, 2.5, 2}, {{"gier4", 3, 3}, 6, 1.4}}, 0.01, {{0, 4}}};
}

}  // namespace

TEST_CASE("whole numbers of a top are written with a decimal point, as gnuplot's 1/2 is 0") {
  const Place place;
  setenv("PATH", place.folder.c_str(), 1);
  std::ostringstream warnings;
  const std::string prefix = (place.folder / "top").string();
  polhode_plot({prefix + ".dat", {1, 2, 3}, {0.5, 1, 0.25}}, warnings);
  const std::string script = script_of(prefix + ".gp");
  for (const char* line : {"\nJ2 = 2.0", "\nL2 = 1.0", "\nL3 = 0.25", "\nwidth = 1000\n"})
    CHECK(script.find(line) != std::string::npos);
}

TEST_CASE("without gnuplot there is a warning, and the script is kept") {
  const Place place;
  setenv("PATH", place.folder.c_str(), 1);
  std::ostringstream warnings;
  const std::string prefix = (place.folder / "efficiency").string();
  CHECK(!draw_figure(study_in(place.folder, "efficiency"), "svg", warnings));
  CHECK(warnings.str().find("gnuplot is not installed") != std::string::npos);
  CHECK(warnings.str().find("gnuplot efficiency.gp") != std::string::npos);
  const std::string script = script_of(prefix + ".gp");
  CHECK(script.find("image = './efficiency.svg'\n") != std::string::npos);
  CHECK(script.find("caption = 'four runs'\n") != std::string::npos);
  CHECK(script.find("set output image\n") != std::string::npos);
  CHECK(script.find("data = './efficiency.csv'\n") != std::string::npos);
  CHECK(script.find("first[2] = 3\n") != std::string::npos);
  CHECK(script.find("last[1] = 2\n") != std::string::npos);
}

TEST_CASE("a figure has a curve for each scheme, in the scheme's style") {
  const Place place;
  setenv("PATH", place.folder.c_str(), 1);
  std::ostringstream warnings;
  const EfficiencyFigure study = study_in(place.folder, "figure");
  const auto has_curves = [&](const fs::path& path) {
    const std::string script = script_of(path);
    CHECK(script.find("curves = 2\n") != std::string::npos);
    std::vector<std::string> names;
    for (const SchemeRows& rows : study.schemes) names.push_back(rows.scheme);
    const std::vector<SchemeStyle> styles = scheme_styles(names);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string at = "[" + std::to_string(k + 1) + "] = ";
      CHECK(script.find("name" + at + "'" + names[k] + "'\n") != std::string::npos);
      CHECK(script.find("colour" + at + "'" + styles[k].colour + "'\n") != std::string::npos);
      CHECK(script.find("filled" + at + std::to_string(styles[k].filled)) != std::string::npos);
    }
  };
  draw_figure(study, "svg", warnings);
  has_curves(place.folder / "figure.gp");
  draw_figure(advice_in(place.folder), "svg", warnings);
  has_curves(place.folder / "advice.gp");
}

TEST_CASE("curves of panels are numbered through, and those with errors have bands") {
  const Place place;
  setenv("PATH", place.folder.c_str(), 1);
  std::ostringstream warnings;
  CurvesFigure figure{(place.folder / "g.csv").string(), "g", "r", "g"};
  figure.panels = {{"O-`H`", {{"a", 2, 3}, {"b", 4}}, {{"fit", {0, 1}, {0, 2}}}, 0, 2.5},
                   {"", {{"", 5, 6}}, {}, -1, 1}};
  draw_figure(figure, "svg", warnings);
  const std::string script = script_of(place.folder / "g.gp");
  for (const char* line :
       {"title_of[1] = 'O-`H`'\n", "panels = 2\n", "across = 2\n", "first_curve[2] = 3\n",
        "last_curve[2] = 3\n", "column_of[3] = 5\n", "first_band[2] = 2\n", "last_band[2] = 2\n",
        "banded[1] = 1\n", "banded[2] = 3\n", "high_of[1] = 2.5", "low_of[2] = -1.0",
        "line_name[1] = 'fit'\n", "last_line[1] = 1\n", "first_line[2] = 2\n", "last_line[2] = 1\n",
        "legend_rows = 1\n"})
    CHECK_MESSAGE(script.find(line) != std::string::npos, line);
}

TEST_CASE("figures are drawn if gnuplot is installed") {
  const Place place;
  std::ostringstream warnings;
  {
    std::ofstream csv(place.folder / "run.csv");
    csv << "# polhode\ntime [ps],potential [kJ/mol],conserved [kJ/mol]\n";
    for (int k = 0; k < 20; ++k) csv << k << ',' << -100 + k % 3 << ',' << -50 + k % 2 << '\n';
  }
  const bool drawn = draw_figure(
      EnergyFigure{(place.folder / "run.csv").string(), "a \"run\"", "conserved", "0.3 ± 0.1 %"},
      "svg", warnings);
  if (!drawn && warnings.str().find("not installed") != std::string::npos) return;
  CHECK(drawn);
  CHECK(draw_figure(study_in(place.folder, "eff"), "svg", warnings));
  EfficiencyFigure none = study_in(place.folder, "none");
  none.schemes.clear();
  CHECK(draw_figure(none, "svg", warnings));
  AdviceFigure advice = advice_in(place.folder);
  CHECK(draw_figure(advice, "svg", warnings));
  advice = {advice.csv, {}};
  CHECK(draw_figure(advice, "svg", warnings));
  for (const std::size_t panels : {1u, 2u, 5u}) {
    CurvesFigure figure{(place.folder / "many.csv").string(), "many", "r", "g", 1, 8};
    std::ofstream(figure.csv) << "r,a,a error,b\n1,1,0.1,2\n2,3,,2\n8,5,0.2,2\n";
    for (std::size_t p = 0; p < panels; ++p)
      figure.panels.push_back({"g", {{"a", 2, 3}, {"b", 4}}, {{"fit", {1, 8}, {1, 5}}}, 0, 6});
    CHECK(draw_figure(figure, "svg", warnings));
  }
  {
    std::ofstream data(place.folder / "top.dat");
    data << "1 0 0\n0 1 0\n\n-1 0 0\n0 -1 0\n\n\nnan 0 0\n\n\n1 0 0\n\n\n1 0 0\n";
  }
  CHECK(polhode_plot({(place.folder / "top.dat").string(), {1, 2, 3}, {0.1, 0.2, 1}}, warnings));
  CHECK(script_of(place.folder / "top.gp").find("J3 = 3.0") != std::string::npos);
  CHECK(script_of(place.folder / "top.svg").find("polhode") != std::string::npos);
  CHECK(warnings.str() == "");
  CHECK(script_of(place.folder / "run.svg").find("</svg>") != std::string::npos);
  CHECK(script_of(place.folder / "eff.svg").find("hoa2") != std::string::npos);

  std::ofstream(place.folder / "wrong.gp") << "no such command\n";
  CHECK(!run_gnuplot((place.folder / "wrong.gp").string(), warnings));
  CHECK(warnings.str().find("gnuplot exited with code") != std::string::npos);
}

TEST_CASE("gnuplot evaluates nothing in a quoted text") {
  CHECK(gnuplot_text("a `b` \\ \"c\"") == "'a `b` \\ \"c\"'");
  CHECK(gnuplot_text("a'`b`'") == "'a''`b`'''");
  CHECK(gnuplot_text("a\nsystem('b')") == "'a\\x0asystem(''b'')'");
  CHECK(gnuplot_file("folder/<a;") == "'./<a;'");
  CHECK(gnuplot_file("|a") == "'./|a'");
  CHECK(gnuplot_comment("a\nb\\\\") == "a\\x0ab");
}

TEST_CASE("gnuplot is stopped if it does not end") {
  const Place place;
  const fs::path program = place.folder / "gnuplot";
  std::ofstream(program) << "#!" << shell << "\nwhile :; do :; done\n";
  fs::permissions(program, fs::perms::owner_all);
  setenv("PATH", place.folder.c_str(), 1);
  std::ostringstream warnings;
  CHECK(!run_gnuplot((place.folder / "any.gp").string(), warnings, std::chrono::seconds(1)));
  CHECK(warnings.str().find("did not end within 1 s") != std::string::npos);
}

TEST_CASE("gnuplot is not run from a relative search path") {
  const Place place;
  const fs::path before = fs::current_path();
  fs::current_path(place.folder);
  std::ofstream("gnuplot") << "#!" << shell << "\n: > evaluated\n";
  fs::permissions("gnuplot", fs::perms::owner_all);
  setenv("PATH", ":.:", 1);
  std::ostringstream warnings;
  CHECK(!run_gnuplot("any.gp", warnings));
  CHECK(!fs::exists("evaluated"));
  fs::current_path(before);
}
