// SPDX-License-Identifier: MIT
// The polhode program: runs the verb given as the first word, and turns errors into messages and
// exit codes.
#include <fmt/core.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/memory.hpp"
#include "base/output_error.hpp"
#include "base/printable.hpp"
#include "base/suggest.hpp"
#include "base/version.hpp"
#include "polhode/base/error.hpp"
#include "terminal/streams.hpp"
#include "terminal/terminal.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

void check_verb(const std::string& word) {
  const std::vector<std::string> names = verb_names();
  if (word == "-V" || word == "--version") return;
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  if (word.starts_with('-'))
    throw Error(
        fmt::format("the option '{}' is in front of the verb; write the verb first, as in polhode "
                    "run --length \"1 ps\" ('polhode help' lists the verbs)",
                    word));
  throw Error(fmt::format("there is no verb '{}'{} (the verbs are: {})", word,
                          did_you_mean(word, names), join_names(names)));
}

/// Suggests a replacement for an option that the verb does not have.
std::string instead_of(const std::string& option, const CLI::App& verb) {
  if (verb.get_name() == "run" && option == "--steps")
    return "; the length of a run is given as a time: write --length \"8 fs\" for 4 steps of 2 fs";
  std::vector<std::string> names;
  for (const CLI::Option* known : verb.get_options()) names.push_back(known->get_name());
  return did_you_mean(option, names);
}

/// A description of the invalid value of an option, if the parser reports one.
std::string wrong_value(const CLI::ParseError& e) {
  const std::string what = e.what();
  if (dynamic_cast<const CLI::ConversionError*>(&e) != nullptr)
    return what.substr(what.find(": ") + 2) + " cannot be read as a number";
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&e) != nullptr)
    return what.substr(0, what.find(':')) + " needs a value";
  return uncapitalized(what);
}

/// Rejects empty arguments. If a variable of a script is not set, its option gets an empty text.
/// Silently using the default would be surprising.
void refuse_empty(const CLI::App& verb) {
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& text : option->results())
      if (text.empty())
        throw Error(
            fmt::format("the value of {} is empty; give a value, or leave out the option if it has "
                        "a default ('polhode help {}' lists the options)",
                        option->get_name(), verb.get_name()));
}

/// Converts an error of the parser to the wording of this program.
Error parse_error(const CLI::ParseError& e, const CLI::App& app) {
  const auto verbs = app.get_subcommands();
  const std::string help = verbs.empty() ? "" : " " + verbs[0]->get_name();
  std::string what = wrong_value(e);
  const std::vector<std::string> left = app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr && !verbs.empty() && !left.empty()) {
    const bool option = left[0].starts_with('-');
    what = option ? fmt::format("polhode{} has no option '{}'{}", help, left[0],
                                instead_of(left[0], *verbs[0]))
                  : fmt::format("unexpected argument '{}' for polhode{}", left[0], help);
  }
  return Error(fmt::format("{} ('polhode help{}' lists the options)", what, help));
}

/// The arguments of the program, where `help VERB` is converted to `VERB --help`.
std::vector<std::string> arguments(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    words.emplace_back("--help");
  }
  return words;
}

int run(std::vector<std::string> words) {
  if (words.empty()) {  // a script whose verb is missing must not succeed
    log("{}", fit_to_terminal(overview(), STDERR_FILENO));
    return 2;
  }
  if (words[0] == "-h" || words[0] == "--help") {
    print_fitted(overview());
    return 0;
  }
  CLI::App app{"polhode", "polhode"};
  app.set_version_flag("-V,--version", fmt::format("polhode {}", version()));
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const VerbGroup& group : verb_groups())
    for (const Verb& verb : group.verbs) {
      CLI::App* const parser = app.add_subcommand(verb.name, verb.description);
      Command command(*parser, typed_command(words));
      actions.emplace_back(parser, verb.declare(command));
    }
  check_verb(words[0]);
  try {
    std::reverse(words.begin(), words.end());  // the parser takes the words from the back
    app.parse(std::move(words));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) {  // help or version was requested
      std::ostringstream text;
      const int code = app.exit(e, text, text);
      print_fitted(text.str());
      return code;
    }
    throw parse_error(e, app);
  }
  for (const auto& [command, action] : actions)
    if (command->parsed()) {
      refuse_empty(*command);
      return action();
    }
  return 2;
}

void print_error(const Error& e) {
  log("error: {}\n", printable(e.what()));
  if (!e.where().empty()) log("  in   {}\n", printable(e.where()));
}

/// The message when memory runs out unexpectedly.
std::string no_memory() {
  return fmt::format(
      "memory is exhausted: this process may use {:.3g} GB; use fewer molecules, frames, lag times "
      "or bins",
      memory_limit() / 1e9);
}

}  // namespace
}  // namespace polhode::cli

int main(int argc, char** argv) {
  using namespace polhode;
  cli::prepare_streams();
  try {
    return cli::exit_code(cli::run(cli::arguments(argc, argv)));
  } catch (const OutputError& e) {
    cli::print_error(e);
    cli::log("  try  {}--force, which starts over and overwrites the earlier output\n",
             e.resumable() ? "--resume, which continues, or " : "");
    return cli::exit_code(2);
  } catch (const Error& e) {
    cli::print_error(e);
    return cli::exit_code(2);
  } catch (const std::bad_alloc&) {
    cli::log("error: {}\n", cli::no_memory());
    return cli::exit_code(1);
  } catch (const std::length_error&) {  // more memory than can be addressed
    cli::log("error: {}\n", cli::no_memory());
    return cli::exit_code(1);
  } catch (const std::exception& e) {
    if (std::ferror(stdout)) return cli::exit_code(1);  // no further output is possible
    cli::log("error: {}\n", printable(e.what()));
    return cli::exit_code(1);
  }
}
