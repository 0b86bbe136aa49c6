// SPDX-License-Identifier: MIT
// polhode settings [NAME] [FILE]: describes the settings of run files.
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>

#include "../verbs.hpp"
#include "run/listing/lists.hpp"

namespace polhode::cli {

Action settings_verb(Command& command) {
  struct SettingsOptions {
    std::string name, file;
    bool json = false;
  };
  auto o = std::make_shared<SettingsOptions>();
  command.add_option("NAME", o->name,
                     "name of a setting, such as \"run.length\", or of a table; default: all");
  command.add_option("--file", o->file, "run file (TOML), whose values are shown");
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    const auto config = o->file.empty() ? std::nullopt : std::optional(read_config(o->file));
    const Config* const values = config ? &*config : nullptr;
    fmt::print("{}",
               o->json ? settings_json(o->name, values) + "\n" : settings_text(o->name, values));
    return 0;
  };
}

}  // namespace polhode::cli
