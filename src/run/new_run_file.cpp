// SPDX-License-Identifier: MIT
#include "run/new_run_file.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <ostream>

#include "base/printable.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/run_file_template.hpp"
#include "io/topology/gromacs_mdp.hpp"
#include "polhode/run/outputs.hpp"
#include "run/output_files.hpp"

namespace polhode {
namespace {

/// A run file whose comments, such as "polhode run nvt.toml", have another name of the file.
std::string with_name(std::string text, const std::string& name, const std::string& file) {
  const std::string before = " " + name, after = " " + file;
  for (auto at = text.find(before); at != text.npos; at = text.find(before, at + after.size()))
    text.replace(at, before.size(), after);
  return text;
}

std::string text_of(const std::string& kind, const std::string& file,
                    const NewRunFileRequest& request, const Callbacks& callbacks) {
  const Given& mdp = request.mdp;
  if (!mdp) return with_name(run_file_template(kind, request.ensemble.text), kind + ".toml", file);
  if (kind != "gromacs")
    throw Error(
        fmt::format("{0} is a file of GROMACS parameters, but the kind is '{1}'; give the kind "
                    "gromacs, or leave out {0}",
                    mdp.name, kind));
  if (request.ensemble)
    throw Error(fmt::format("tcoupl and pcoupl in {} already define the ensemble; leave out {}",
                            mdp.name, request.ensemble.name));
  MdpImport read = read_mdp(mdp.text, {.prefix = std::filesystem::path(file).stem().string()});
  for (const auto& [parameter, reason] : read.differences)
    callbacks.note(fmt::format("note: {}: {}", printable(parameter), reason));
  return std::move(read.run_file);
}

}  // namespace

std::vector<RequestOption<NewRunFileRequest>> NewRunFileRequest::options() {
  using R = NewRunFileRequest;
  return {{"ensemble", &R::ensemble,
           "ensemble, for the kinds gromacs, lammps, water and mixture: nvt adds a thermostat, npt "
           "a thermostat and a barostat"},
          {"mdp", &R::mdp,
           "file of GROMACS run parameters (.mdp) to translate; parameters without a counterpart "
           "are listed"}};
}

std::string new_run_file(const std::string& kind, const std::string& file,
                         const NewRunFileRequest& request, const Callbacks& callbacks) {
  std::string name = file.empty() ? kind + ".toml" : file;
  const std::string text = text_of(kind, name, request, callbacks);
  if (std::filesystem::exists(name))
    throw Error(fmt::format(
        "'{}' exists and is never overwritten; give another name, for example my-{}.toml", name,
        kind));
  check_outputs({name}, ExistingFiles::refuse);
  write_file(name, [&](std::ostream& out) { out << text; });
  return name;
}

}  // namespace polhode
