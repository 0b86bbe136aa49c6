// SPDX-License-Identifier: MIT
#include "polhode/io/plot.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>

#include "plot_script.hpp"
#include "polhode/io/table_file.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const auto end = rest.find(':');
    const fs::path file = fs::path(rest.substr(0, end)) / program;
    if (::access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file)) return true;
    rest = end == rest.npos ? std::string_view{} : rest.substr(end + 1);
  }
  return false;
}

// Runs gnuplot silently in the script's folder and waits for it; returns its exit code, or −1.
int gnuplot(const fs::path& script) {
  const std::string folder = script.has_parent_path() ? script.parent_path().string() : ".";
  const std::string file = script.filename().string();
  const pid_t child = ::fork();
  if (child == 0) {  // only async-signal-safe calls between fork and exec
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
    }
    if (::chdir(folder.c_str()) == 0)
      ::execlp("gnuplot", "gnuplot", file.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

bool draw(const std::string& file, const std::string& script, std::ostream& warnings) {
  write_file(file, [&](std::ostream& out) { out << script; });
  return run_gnuplot(file, warnings);
}

}  // namespace

bool run_gnuplot(const std::string& script, std::ostream& warnings) {
  if (!on_path("gnuplot")) {
    warnings << fmt::format(
        "warning: gnuplot is not installed, so there is no figure; install it and run 'gnuplot {}' "
        "where that file is\n",
        fs::path(script).filename().string());
    return false;
  }
  const int code = gnuplot(script);
  if (code == 0) return true;
  warnings << fmt::format(
      "warning: gnuplot ended with code {}, so there is no figure; run 'gnuplot {}' where that "
      "file "
      "is to see why\n",
      code, fs::path(script).filename().string());
  return false;
}

bool energy_plot(const std::string& csv, const std::string& title, const std::string& format,
                 std::ostream& warnings) {
  const fs::path data(csv);
  const std::string script =
      energy_script(data.filename().string(),
                    fs::path(data.filename()).replace_extension(format).string(), title, format);
  return draw(fs::path(data).replace_extension("gp").string(), script, warnings);
}

bool curves_plot(const CurvesFigure& figure, const std::string& format, std::ostream& warnings) {
  const fs::path data(figure.csv);
  const std::string image = fs::path(data.filename()).replace_extension(format).string();
  return draw(fs::path(data).replace_extension("gp").string(),
              curves_script(figure, data.filename().string(), image, format), warnings);
}

bool efficiency_plot(const std::string& prefix, const std::vector<EfficiencyCurve>& curves,
                     const std::string& format, std::ostream& warnings, double highest) {
  const std::string image = fs::path(prefix + "." + format).filename().string();
  return draw(prefix + ".gp", efficiency_script(curves, image, format, highest), warnings);
}

bool advice_plot(const std::string& prefix, const AdviceFigure& figure, const std::string& format,
                 std::ostream& warnings) {
  const std::string image = fs::path(prefix + "." + format).filename().string();
  return draw(prefix + ".gp", advice_script(figure, image, format), warnings);
}

}  // namespace polhode
