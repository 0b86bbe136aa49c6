// SPDX-License-Identifier: MIT
#include "settings.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "atom.h"
#include "error.h"
#include "lammps.h"
#include "polhode/base/error.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "utils.h"

namespace polhode::lammps {
namespace {

class Arguments {
 public:
  Arguments(std::span<char*> words, LAMMPS_NS::LAMMPS* lammps) : words_(words), lammps_(lammps) {}
  FixSettings settings();

 private:
  using Reader = void (Arguments::*)();
  std::string_view word(std::string_view meaning);
  double number(std::string_view meaning);
  double positive(std::string_view meaning);
  void scheme() { scheme_ = word("the name or the text of a scheme"); }
  void lambda() { settings_.lambda = positive("lambda"); }
  void tolerance() { settings_.tolerance = positive("tolerance"); }
  void massless();
  void langevin();
  void check(const Scheme& scheme) const;

  std::span<char*> words_;
  LAMMPS_NS::LAMMPS* lammps_;
  std::string keyword_;
  std::string scheme_ = "velocity-verlet";
  FixSettings settings_ = default_settings();
};

std::string_view Arguments::word(std::string_view meaning) {
  if (words_.empty())
    throw Error("the keyword " + keyword_ + " has too few values; " + std::string(meaning) +
                " must follow");
  const std::string_view word = words_.front();
  words_ = words_.subspan(1);
  return word;
}

double Arguments::number(std::string_view meaning) {
  const std::string text(word(meaning));
  return LAMMPS_NS::utils::numeric(FLERR, text, false, lammps_);
}

double Arguments::positive(std::string_view meaning) {
  const double value = number(meaning);
  if (!(value > 0))
    throw Error(std::string(meaning) + " = " + std::to_string(value) + "; it must be above 0");
  return value;
}

void Arguments::massless() {
  const std::string types(word("an atom type or a range of types"));
  int low = 0, high = 0;
  const int count = lammps_->atom->ntypes;
  LAMMPS_NS::utils::bounds(FLERR, types, 1, count, low, high, lammps_->error);
  settings_.massless.resize(static_cast<std::size_t>(count) + 1);
  for (int type = low; type <= high; ++type)
    settings_.massless[static_cast<std::size_t>(type)] = true;
}

void Arguments::langevin() {
  LangevinArguments bath;
  bath.temperature = number("the temperature");
  if (!(bath.temperature >= 0))
    throw Error("the temperature of langevin is " + std::to_string(bath.temperature) +
                "; it must be 0 or more");
  bath.damping_time = positive("the damping time of langevin");
  const double seed = number("the seed");
  if (!(seed >= 0 && seed < 9e15) || seed != static_cast<double>(static_cast<std::int64_t>(seed)))
    throw Error("the seed of langevin must be a whole number from 0 to 9e15");
  bath.seed = static_cast<std::uint64_t>(seed);
  settings_.langevin = bath;
}

// Forces are known at the end of a step of LAMMPS, where a step of the scheme must end.
void Arguments::check(const Scheme& scheme) const {
  if (scheme.has(Flow::bath))
    throw Error("the scheme has a bath O; leave its stages out and use the keyword langevin");
  if (!scheme.starts_with_kick() || !scheme.ends_with_kick())
    throw Error("the scheme '" + scheme_ +
                "' does not begin and end with a kick, as velocity "
                "Verlet does; LAMMPS computes forces at the end of each step, which this scheme "
                "would not use, so choose one of 'polhode schemes' whose stages begin with B");
  if (scheme.stages().front().xi != 0 || scheme.stages().back().xi != 0)
    throw Error("the scheme '" + scheme_ +
                "' begins or ends with a gradient kick, so a step would "
                "end at displaced positions; choose one that begins and ends with a plain kick");
}

FixSettings Arguments::settings() {
  static const std::map<std::string, Reader, std::less<>> readers = {
      {"scheme", &Arguments::scheme},
      {"lambda", &Arguments::lambda},
      {"tolerance", &Arguments::tolerance},
      {"massless", &Arguments::massless},
      {"langevin", &Arguments::langevin}};
  while (!words_.empty()) {
    keyword_ = word("a keyword");
    const auto reader = readers.find(keyword_);
    if (reader == readers.end()) {
      std::vector<std::string> names;
      for (const auto& [name, function] : readers) names.push_back(name);
      throw Error("there is no keyword '" + keyword_ + "'" + did_you_mean(keyword_, names) +
                  "; the keywords are: " + join_names(names));
    }
    (this->*reader->second)();
  }
  const Scheme scheme = scheme_of(scheme_);
  check(scheme);
  settings_.scheme =
      settings_.langevin ? with_bath(scheme, BathPlace::ends, scheme.name()) : scheme;
  return std::move(settings_);
}

}  // namespace

FixSettings default_settings() { return {scheme_of("velocity-verlet")}; }

FixSettings fix_settings(int count, char** arguments, LAMMPS_NS::LAMMPS* lammps) {
  return Arguments({arguments, static_cast<std::size_t>(count)}, lammps).settings();
}

}  // namespace polhode::lammps
