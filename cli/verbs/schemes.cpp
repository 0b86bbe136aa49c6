// SPDX-License-Identifier: MIT
// polhode schemes [NAME]: the table of splitting schemes.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../reports/schemes_report.hpp"
#include "../verbs.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "run/listing/schemes.hpp"

namespace polhode::cli {

Action schemes_verb(Command& command) {
  struct Options {
    std::string name;
    bool json = false;
  };
  auto o = std::make_shared<Options>();
  command.add_option("NAME", o->name, "name of a scheme, or its stages as text; default: all");
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    if (!o->name.empty() && o->json)
      fmt::print("{}\n", scheme_json(scheme_of(o->name)));
    else if (!o->name.empty())
      print_scheme(scheme_of(o->name));
    else if (o->json)
      fmt::print("{}\n", schemes_json());
    else
      print_schemes();
    return 0;
  };
}

}  // namespace polhode::cli
