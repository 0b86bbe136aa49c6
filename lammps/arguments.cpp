// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <vector>

#include "base/suggest.hpp"
#include "lammps.h"
#include "pointers.h"
#include "polhode/base/error.hpp"
#include "utils.h"

namespace polhode::lammps {

std::string_view Arguments::word(std::string_view meaning) {
  if (words_.empty())
    throw Error("the " + keyword_ + " has too few values; " + std::string(meaning) +
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

void Arguments::each_keyword(
    const std::map<std::string, std::function<void()>, std::less<>>& readers) {
  while (!words_.empty()) {
    const std::string name(word("a keyword"));
    keyword_ = "keyword " + name;
    const auto reader = readers.find(name);
    if (reader == readers.end()) {
      std::vector<std::string> names;
      for (const auto& [known, function] : readers) names.push_back(known);
      throw Error("there is no keyword '" + name + "'" + did_you_mean(name, names) +
                  "; the keywords are: " + join_names(names));
    }
    reader->second();
  }
}

}  // namespace polhode::lammps
