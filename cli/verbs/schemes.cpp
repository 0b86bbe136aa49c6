// SPDX-License-Identifier: MIT
// polhode schemes [NAME]: prints the table of splitting schemes.
#include <memory>
#include <string>

#include "../reports/reports.hpp"
#include "../verbs.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "run/listing/lists.hpp"

namespace polhode::cli {

Action schemes_verb(Command& command) {
  struct SchemesOptions : ResultForm {
    std::string name;
  };
  auto o = std::make_shared<SchemesOptions>();
  command.add_option("NAME", o->name, "name of a scheme, or its stages as text; default: all");
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    if (o->name.empty())
      print_results("schemes", all_schemes(), o->json);
    else
      print_results(quantities(scheme_of(o->name)), *o);
    return 0;
  };
}

}  // namespace polhode::cli
