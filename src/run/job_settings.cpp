// SPDX-License-Identifier: MIT
#include "run/job_settings.hpp"

#include <array>

namespace polhode {
namespace {

// Of several jobs.
constexpr JobSetting output{"output", "output.prefix", "prefix of the output files"};
constexpr JobSetting precision{"precision", "forces.precision",
                               "precision of pair interactions: double or mixed"};
constexpr JobSetting scheme{"scheme", "integrator.scheme",
                            "splitting scheme: a name, or stages as text"};
constexpr JobSetting step{"step", "integrator.step", "time step: \"2 fs\""};
constexpr JobSetting temperature{
    "temperature", "system.temperature",
    "temperature of thermostats, of new velocities and of the equilibration: \"298 K\""};
constexpr JobSetting seed{"seed", "system.seed", "seed of lattice and velocities, a whole number"};

constexpr std::array of_run{
    scheme,
    step,
    JobSetting{"length", "run.length", "length of the run: \"15 ps\""},
    JobSetting{"equilibrate", "run.equilibrate",
               "time of velocity rescaling before the run: \"5 ps\""},
    temperature,
    seed,
    precision,
    JobSetting{"thermostat", "thermostat.type", "langevin, rescaling, separate-rescaling or none"},
    JobSetting{"friction", "thermostat.friction",
               "friction of the Langevin thermostat: \"1 1/ps\""},
    JobSetting{"thermostat_time_constant", "thermostat.time_constant",
               "time constant of rescaling thermostats: \"0.5 ps\"", false, "time_constant"},
    JobSetting{"barostat", "barostat.type", "cell-rescaling, monte-carlo or none"},
    JobSetting{"pressure", "barostat.pressure",
               "pressure of the barostat: \"1 bar\"; without a barostat it selects cell-rescaling, "
               "and without a thermostat langevin"},
    JobSetting{"hybrid_steps", "hybrid_monte_carlo.steps",
               "steps of each trajectory of hybrid Monte Carlo, 0: none"},
    output};
constexpr std::array of_prepare{
    precision,
    temperature,
    seed,
    JobSetting{"pressure", "barostat.pressure",
               "pressure of the barostat: \"1 bar\"; without any, the volume is constant"},
    JobSetting{"nvt", "prepare.nvt", "length of NVT: \"20 ps\""},
    JobSetting{"npt", "prepare.npt", "length of NPT: \"100 ps\""},
    output};
constexpr std::array of_minimise{output};
constexpr std::array of_export{output, scheme, step};
constexpr std::array of_advise{
    JobSetting{"schemes", "integrator.candidates", "candidates: names, or stages as text", true},
    JobSetting{"length", "run.length", "length of the runs to be planned: \"15 ps\""}, precision};
constexpr std::array of_study{
    JobSetting{"ensemble", "study.ensemble",
               "nve: R and energy drift; nvt: bias of canonical averages"},
    JobSetting{"schemes", "study.schemes", "names, or stages as text", true},
    JobSetting{"steps", "study.steps", "steps for every scheme: \"2 fs\" \"4 fs\"", true},
    JobSetting{"runs", "study.runs", "number of independent runs at each point"},
    JobSetting{"length", "study.length", "length of each run: \"15 ps\""},
    JobSetting{"decorrelate", "study.decorrelate",
               "equilibration of each initial configuration: \"10 ps\""},
    JobSetting{"configurational_sample", "study.configurational_sample",
               "time between samples of the configurational temperature: \"20 fs\""},
    precision,
    temperature,
    seed};

}  // namespace

std::span<const JobSetting> settings_of_job(std::string_view job) {
  if (job == "run") return of_run;
  if (job == "prepare") return of_prepare;
  if (job == "minimise") return of_minimise;
  if (job == "export") return of_export;
  if (job == "advise") return of_advise;
  if (job == "study") return of_study;
  return {};
}

Overlay overlay_of_job(std::string_view job, bool quick) {
  Overlay overlay{.pressure_selects_thermostat = job != "prepare"};
  if (job == "study" && quick)
    overlay.settings = {{"study.runs", {"4"}, "quick"},
                        {"study.length", {"8 ps"}, "quick"},
                        {"study.decorrelate", {"2 ps"}, "quick"}};
  return overlay;
}

}  // namespace polhode
