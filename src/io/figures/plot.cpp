// SPDX-License-Identifier: MIT
#include "io/figures/plot.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <ostream>

#include "figure_script.hpp"
#include "io/files/disk.hpp"
#include "io/files/write_file.hpp"
#include "polhode/io/files/table_file.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// The path of a program that is found on the search path; empty if the program is not found.
// Relative folders of the search path are skipped, so that no program in the folder of the data is
// run.
std::string found_program(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const auto end = rest.find(':');
    const fs::path file = fs::path(rest.substr(0, end)) / program;
    std::error_code unknown;
    if (file.is_absolute() && ::access(file.c_str(), X_OK) == 0 &&
        fs::is_regular_file(file, unknown))
      return file.string();
    rest = end == rest.npos ? std::string_view{} : rest.substr(end + 1);
  }
  return {};
}

// Runs in the child process that becomes gnuplot, and makes only calls that are safe between fork
// and exec. The alarm remains active after exec and ends gnuplot at its time limit.
[[noreturn]] void become(const char* program, const char* folder, const char* script,
                         unsigned seconds) {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::dup2(::open("/dev/null", O_RDWR), stream);
  sigset_t alarm;
  ::sigemptyset(&alarm);
  ::sigaddset(&alarm, SIGALRM);
  ::sigprocmask(SIG_UNBLOCK, &alarm, nullptr);
  for (const int signal_number : {SIGALRM, SIGPIPE, SIGXFSZ}) ::signal(signal_number, SIG_DFL);
  ::alarm(seconds);
  // The option -d makes gnuplot ignore the user's settings, which may contain commands.
  if (::chdir(folder) == 0) ::execl(program, program, "-d", script, static_cast<char*>(nullptr));
  ::_exit(127);
}

// Runs gnuplot silently in the script's folder. Returns an error message if gnuplot fails.
std::string gnuplot_trouble(const std::string& program, const fs::path& script,
                            std::chrono::seconds limit) {
  const std::string folder = script.has_parent_path() ? script.parent_path().string() : ".";
  const std::string file = "./" + script.filename().string();
  const pid_t child = ::fork();
  if (child == 0)
    become(program.c_str(), folder.c_str(), file.c_str(), static_cast<unsigned>(limit.count()));
  int status = 0;
  if (child < 0 || TEMP_FAILURE_RETRY(::waitpid(child, &status, 0)) != child)
    return fmt::format("gnuplot could not be started ({})", std::strerror(errno));
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return fmt::format("gnuplot did not end within {} s and was stopped", limit.count());
  if (WIFSIGNALED(status))
    return fmt::format("gnuplot was terminated by signal {}", WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) return {};
  return fmt::format("gnuplot exited with code {}", WEXITSTATUS(status));
}

/// Writes the script of a figure next to its data, under the same name, and draws its image.
bool draw(const auto& figure, const std::string& data, const std::string& format,
          std::ostream& warnings) {
  const fs::path script = fs::path(data).replace_extension("gp");
  const fs::path image = fs::path(data).replace_extension(format);
  write_file(script.string(), [&](std::ostream& out) {
    out << script_of(figure, {image.filename().string(), format});
  });
  remove_output(image.string());  // gnuplot would write through a symbolic link
  return run_gnuplot(script.string(), warnings);
}

}  // namespace

bool run_gnuplot(const std::string& script, std::ostream& warnings, std::chrono::seconds limit) {
  const std::string program = found_program("gnuplot");
  if (program.empty()) {
    warnings << fmt::format(
        "warning: gnuplot is not installed, so no figure was drawn; install it and run 'gnuplot "
        "{}' in the folder of that file\n",
        fs::path(script).filename().string());
    return false;
  }
  const std::string trouble = gnuplot_trouble(program, script, limit);
  if (trouble.empty()) return true;
  warnings << fmt::format(
      "warning: {}, so no figure was drawn; run 'gnuplot {}' in the folder of that file to see "
      "why\n",
      trouble, fs::path(script).filename().string());
  return false;
}

bool draw_figure(const Figure& figure, const std::string& format, std::ostream& warnings) {
  return std::visit([&](const auto& one) { return draw(one, one.csv, format, warnings); }, figure);
}

bool polhode_plot(const PolhodeFigure& figure, std::ostream& warnings) {
  return draw(figure, figure.data, "svg", warnings) && draw(figure, figure.data, "png", warnings);
}

}  // namespace polhode
