// SPDX-License-Identifier: MIT
#include "run/job_settings.hpp"

#include <array>

#include "io/settings/settings.hpp"

namespace polhode {
namespace {

namespace shared {  // by several jobs
constexpr JobSetting output{"output", "output.prefix"}, precision{"precision", "forces.precision"},
    scheme{"scheme", "integrator.scheme"}, step{"step", "integrator.step"},
    length{"length", "run.length"}, temperature{"temperature", "system.temperature"},
    seed{"seed", "system.seed"};
}  // namespace shared

constexpr std::array of_run{
    shared::scheme,
    shared::step,
    shared::length,
    JobSetting{"equilibrate", "run.equilibrate"},
    shared::temperature,
    shared::seed,
    shared::precision,
    JobSetting{"thermostat", "thermostat.type", ", none"},
    JobSetting{"friction", "thermostat.friction"},
    JobSetting{"thermostat_time_constant", "thermostat.time_constant", "", "time_constant"},
    JobSetting{"barostat", "barostat.type", ", none"},
    JobSetting{"pressure", "barostat.pressure",
               "; adds cell-rescaling to a run without a barostat, and langevin to a run without a "
               "thermostat"},
    JobSetting{"hybrid_steps", "hybrid_monte_carlo.steps", "; 0 switches hybrid Monte Carlo off"},
    shared::output};
constexpr std::array of_prepare{
    shared::precision,
    shared::temperature,
    shared::seed,
    JobSetting{"pressure", "barostat.pressure", "; without a pressure, the volume is constant"},
    JobSetting{"nvt", "prepare.nvt"},
    JobSetting{"npt", "prepare.npt"},
    shared::output};
constexpr std::array of_minimise{shared::output};
constexpr std::array of_export{shared::output, shared::scheme, shared::step};
constexpr std::array of_advise{
    JobSetting{"schemes", "integrator.candidates"},
    JobSetting{"length", "run.length", "; the advice is for a run of this length"},
    shared::precision};
constexpr std::array of_study{JobSetting{"ensemble", "study.ensemble"},
                              JobSetting{"schemes", "study.schemes"},
                              JobSetting{"steps", "study.steps"},
                              JobSetting{"runs", "study.runs"},
                              JobSetting{"length", "study.length"},
                              JobSetting{"decorrelate", "study.decorrelate"},
                              JobSetting{"configurational_sample", "study.configurational_sample"},
                              shared::precision,
                              shared::temperature,
                              shared::seed};

}  // namespace

std::string JobSetting::meaning() const { return brief_meaning(setting(key)) + note; }

bool JobSetting::is_list() const { return setting(key).kinds.front() == SettingKind::texts; }

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
