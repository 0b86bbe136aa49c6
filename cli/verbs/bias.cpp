// SPDX-License-Identifier: MIT
// polhode bias FILE: the time-step bias of averages from the energies that any program printed.
#include <memory>
#include <string>

#include "../reports/reports.hpp"
#include "../verbs.hpp"
#include "run/bias/log_bias.hpp"

namespace polhode::cli {
Action bias_verb(Command& command) {
  struct BiasOptions : ResultForm {
    std::string file;
    BiasRequest request;
  };
  auto o = std::make_shared<BiasOptions>();
  command.add_option("FILE", o->file,
                     "log of LAMMPS, .xvg file of 'gmx energy', or CSV file of OpenMM or polhode",
                     required);
  command.add_request(o->request);
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    print_results(quantities(log_bias(read_engine_log(o->file), o->request)), *o);
    return 0;
  };
}

}  // namespace polhode::cli
