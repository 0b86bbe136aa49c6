// SPDX-License-Identifier: MIT
#include "mdp_parameters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "base/suggest.hpp"
#include "io/files/field_line.hpp"
#include "io/files/split_words.hpp"
#include "io/files/text_file.hpp"
#include "polhode/base/error.hpp"

namespace polhode::gromacs {
namespace {

/// Parameters that run files do not support: the beginning of each name, and the reason. The first
/// entry that matches a name applies.
struct Reason {
  std::string_view beginning, text;
};

constexpr std::string_view lists =
    "not needed: the neighbour list always contains all pairs and is rebuilt when necessary";
constexpr std::string_view mesh =
    "not needed: the mesh is chosen for pme_accuracy in [forces], see the manual";
constexpr std::string_view rigid =
    "not needed: molecules are rigid by construction, and their free rotation is exact";
constexpr std::string_view outputs = "polhode has no such output";
constexpr std::string_view groups =
    "groups of atoms are not available: settings apply to all molecules";
constexpr std::string_view not_offered = "not available";

constexpr auto reasons = std::to_array<Reason>({
    {"title", "a comment"},
    {"cpp", "a setting of the preprocessor"},
    {"nstlist", lists},
    {"nstype", lists},
    {"cutoffscheme", lists},
    {"rlist", lists},
    {"verletbuffer", lists},
    {"tableextension", lists},
    {"fourier", mesh},
    {"pmeorder", mesh},
    {"ewaldrtol", mesh},
    {"optimizefft", mesh},
    {"ljpme", not_offered},
    {"constraintalgorithm", rigid},
    {"lincs", rigid},
    {"shake", rigid},
    {"continuation", rigid},
    {"unconstrainedstart", rigid},
    {"morse", rigid},
    {"nstlog", outputs},
    {"nstcalcenergy", outputs},
    {"nstfout", outputs},
    {"compressedx", outputs},
    {"xtcprecision", outputs},
    {"xtcgrps", outputs},
    {"energygrp", groups},
    {"nstcomm", "not needed: the centre of mass is at rest in every step"},
    {"commgrps", groups},
    {"nsttcouple", "not needed: the thermostat acts in every step"},
    {"nhchainlength", "Nosé-Hoover chains are not available"},
    {"ldseed", "the seed in [system] determines all random numbers"},
    {"refcoord", "there are no position restraints"},
    {"emtol", "use the option --max-force of polhode minimise"},
    {"emstep", "not needed: the minimiser (FIRE) chooses its steps"},
    {"nstcgsteep", "not needed: the minimiser is FIRE"},
    {"nbfgscorr", "not needed: the minimiser is FIRE"},
    {"niter", rigid},
    {"fcstep", rigid},
    {"tinit", "runs begin at 0 ps"},
    {"initstep", "runs begin at 0 ps"},
    {"simulationpart", "runs begin at 0 ps"},
    {"rcoulombswitch", "charges use the switching distance of the short-range potentials"},
});

/// Whether a value is a word that switches a parameter off.
bool is_off(std::string_view value) {
  static constexpr std::array<std::string_view, 4> off = {"", "no", "none", "0"};
  return std::any_of(off.begin(), off.end(),
                     [&](std::string_view word) { return letters_and_digits(value) == word; });
}

}  // namespace

MdpParameters::MdpParameters(std::string_view text, const std::string& file) {
  if (const auto what = odd_byte(text, file)) throw Error(*what, file);
  const auto name_of_file = std::make_shared<const std::string>(file);
  text = without_mark(text);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), whole.size() + 1));
    const std::string_view line = trimmed(whole.substr(0, whole.find(';')));
    if (line.empty()) continue;
    const TextPlace place{name_of_file, number};
    const auto equals = line.find('=');
    const std::string name(trimmed(line.substr(0, equals)));
    if (equals == line.npos || letters_and_digits(name).empty() || name.size() > max_name_length)
      throw Error(fmt::format("found '{}' instead of a parameter; write \"name = value\", and "
                              "begin comments with a semicolon",
                              line.substr(0, max_name_length)),
                  text_of(place));
    if (!index_.emplace(letters_and_digits(name), parameters_.size()).second)
      throw Error(fmt::format("the parameter {} is given twice; delete one line", name),
                  text_of(place));
    parameters_.push_back({name, std::string(trimmed(line.substr(equals + 1))), place});
  }
}

MdpParameters::Parameter* MdpParameters::find(std::string_view name) {
  const auto found = index_.find(letters_and_digits(name));
  return found == index_.end() ? nullptr : &parameters_[found->second];
}

std::string MdpParameters::text(std::string_view name) {
  Parameter* const found = find(name);
  if (found == nullptr) return {};
  found->asked = true;
  return found->value;
}

bool MdpParameters::is(std::string_view name, std::string_view word, std::string_view fallback) {
  const std::string value = text(name);
  return same_letters(value.empty() ? fallback : std::string_view(value), word);
}

bool MdpParameters::is(std::string_view name, std::initializer_list<std::string_view> words,
                       std::string_view fallback) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return is(name, word, fallback); });
}

std::vector<double> MdpParameters::numbers(std::string_view name) {
  const std::string value = text(name);
  std::vector<double> numbers;
  if (value.empty()) return numbers;
  const FieldLine fields(value, find(name)->place);
  for (std::size_t k = 0; k < fields.size(); ++k) numbers.push_back(fields.number(k, name));
  return numbers;
}

double MdpParameters::number(std::string_view name, double fallback) {
  const std::vector<double> all = numbers(name);
  return all.empty() ? fallback : all.front();
}

void MdpParameters::differs(std::string_view name, const std::string& reason,
                            std::string_view fallback) {
  if (Parameter* const found = find(name); found != nullptr && !found->value.empty())
    found->reason = reason;
  else
    of_defaults_.push_back({fmt::format("{} = {} (default)", name, fallback), reason});
}

std::vector<MdpDifference> MdpParameters::differences() const {
  std::vector<MdpDifference> all = of_defaults_;
  for (const Parameter& p : parameters_) {
    std::string reason = p.reason;
    if (!p.asked && reason.empty()) {
      const std::string name = letters_and_digits(p.name);
      const auto known = std::find_if(reasons.begin(), reasons.end(), [&](const Reason& r) {
        return name.starts_with(r.beginning);
      });
      if (known == reasons.end() && is_off(p.value)) continue;
      reason = known == reasons.end() ? not_offered : known->text;
    }
    if (!reason.empty()) all.push_back({fmt::format("{} = {}", p.name, p.value), reason});
  }
  return all;
}

}  // namespace polhode::gromacs
