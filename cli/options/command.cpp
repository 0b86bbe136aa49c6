// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

#include "run/job_settings.hpp"

namespace polhode::cli {

void Command::add_flag(const std::string& name, bool& value, const std::string& meaning) {
  app_->add_flag(name, value, meaning);
}

template <class Value>
void Command::add_option(const std::string& name, Value& value, const std::string& meaning,
                         bool must_be_given) {
  app_->add_option(name, value, meaning)->required(must_be_given);
}
template void Command::add_option(const std::string&, std::string&, const std::string&, bool);
template void Command::add_option(const std::string&, std::vector<std::string>&, const std::string&,
                                  bool);

namespace {

std::string option_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

/// The name of an option, followed by its older name if there is one, such as "--start,--from".
std::string names_of(const std::string& option, const char* old_name) {
  return old_name == nullptr ? option : option + "," + option_of(old_name);
}

}  // namespace

std::string Command::verb() const { return app_->get_name(); }

void Command::add_settings() {
  for (const JobSetting& row : settings_of_job(verb())) {
    const std::string option = option_of(row.name);
    const auto set = [overlay = overlay_, row, option](const std::vector<std::string>& values) {
      overlay->settings.push_back({row.key, values, option});
    };
    app_->add_option_function<std::vector<std::string>>(names_of(option, row.old_name), set,
                                                        row.meaning())
        ->expected(1, row.is_list() ? CLI::detail::expected_max_vector_size : 1);
  }
}

void Command::add_given(const char* name, const char* old_name, Given& value,
                        const std::string& doc) {
  value.name = option_of(name);
  app_->add_option(names_of(value.name, old_name), value.text, doc);
}

std::string typed_command(const std::vector<std::string>& words) {
  std::string typed = "polhode";
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word == "--json" || *word == "--verbose" || *word == "--force" || *word == "--resume" ||
        *word == "--continue" || word->starts_with("--threads=") ||
        (*word == "--threads" && ++word != words.end()))
      continue;
    if (word == words.end()) break;
    typed += ' ';
    const bool plain =
        !word->empty() && word->find_first_of(" ()'\"\\$`*?[]{}|&;<>#!~") == word->npos;
    if (plain) {
      typed += *word;
      continue;
    }
    const bool single = word->find_first_of("\"\\$`!") != word->npos;
    const std::string quote = single ? "'" : "\"";
    typed += quote;
    for (const char c : *word) typed += single && c == '\'' ? "'\\''" : std::string(1, c);
    typed += quote;
  }
  return typed;
}

}  // namespace polhode::cli
