// SPDX-License-Identifier: MIT
#include "molecule_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <system_error>

#include "base/from_chars.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/error.hpp"

namespace polhode::lammps {
namespace {

// Sections of LAMMPS molecule files that do not describe sites.
constexpr std::array skipped = {"Molecules", "Fragments", "Diameters", "Dipoles", "Bonds",
                                "Angles",    "Dihedrals", "Impropers", "Special", "Shake",
                                "Body",      "Integers",  "Doubles"};

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : in_(std::string(text)), file_(file) {}

  MoleculeFile parse() {
    std::getline(in_, line_), ++number_;  // skips the title
    while (next_line()) {
      if (words_.size() == 2 && words_[1] == "atoms") {
        set_count();
      } else if (std::isalpha(static_cast<unsigned char>(words_[0][0])) != 0) {
        section();
      }
    }
    line_.clear();
    if (atoms_ == 0) refuse("there is no line with the number of atoms, such as '3 atoms'");
    if (molecule_.r.empty())
      refuse("there is no section Coords; it must contain the positions of the sites");
    if (molecule_.types.empty())
      refuse("there is no section Types; it must contain the types of the sites");
    molecule_.charges.resize(atoms_);
    return std::move(molecule_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(what, file_ + ":" + std::to_string(number_));
  }

  // Reads the next line that contains words, and removes its comment.
  bool next_line() {
    while (std::getline(in_, line_)) {
      ++number_;
      std::istringstream words(line_.substr(0, line_.find('#')));
      words_.clear();
      for (std::string word; words >> word;) words_.push_back(word);
      if (!words_.empty()) return true;
    }
    return false;
  }

  void set_count() {
    if (atoms_ > 0) refuse("the number of atoms is given twice; give it once, before all sections");
    const double count = number(0);
    if (!(count >= 1 && count <= static_cast<double>(max_sites)) || count != std::floor(count))
      refuse("the number of atoms is " + words_[0] + "; it must be a whole number from 1 to " +
             std::to_string(max_sites));
    atoms_ = static_cast<std::size_t>(count);
  }

  void section() {
    const std::string name = words_[0];
    if (name == "Coords") {
      read_sites(molecule_.r, 3, [&] { return Vec3<double>{number(1), number(2), number(3)}; });
    } else if (name == "Types") {
      read_sites(molecule_.types, 1, [&] { return type(); });
    } else if (name == "Charges") {
      read_sites(molecule_.charges, 1, [&] { return number(1); });
    } else if (name == "Masses") {
      read_sites(molecule_.masses, 1, [&] { return number(1); });
    } else if (std::find(skipped.begin(), skipped.end(), name) == skipped.end()) {
      refuse("'" + name + "' is not a section of a molecule file of LAMMPS");
    } else {
      while (next_line_of_section()) {
      }
    }
  }

  // A section ends at the first line that begins with a letter.
  bool next_line_of_section() {
    const auto before = in_.tellg();
    const int number_before = number_;
    if (!next_line()) return false;
    if (std::isalpha(static_cast<unsigned char>(words_[0][0])) == 0) return true;
    in_.seekg(before);
    number_ = number_before;
    return false;
  }

  template <class Value, class Read>
  void read_sites(std::vector<Value>& sites, std::size_t values, const Read& read) {
    if (atoms_ == 0) refuse("the number of atoms, such as '3 atoms', must be before all sections");
    sites.resize(atoms_);
    std::vector<bool> seen(atoms_);
    for (std::size_t k = 0; k < atoms_; ++k) {
      if (!next_line_of_section())
        refuse("the section ends after " + std::to_string(k) + " of " + std::to_string(atoms_) +
               " atoms");
      const double id = number(0);
      if (words_.size() < values + 1 || !(id >= 1 && id <= static_cast<double>(atoms_)) ||
          id != std::floor(id) || seen[static_cast<std::size_t>(id) - 1])
        refuse("'" + line_ + "' must be the number of an atom, from 1 to " +
               std::to_string(atoms_) + " and each once, and its " + std::to_string(values) +
               " value(s)");
      const std::size_t at = static_cast<std::size_t>(id) - 1;
      seen[at] = true;
      sites[at] = read();
    }
  }

  int type() const {
    int value = 0;
    const std::string& word = words_[1];
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (status != std::errc() || end != word.data() + word.size() || value < 1)
      refuse("the type '" + word +
             "' must be a number of 1 or more; type labels are not supported");
    return value;
  }

  double number(std::size_t k) const {
    double value = 0;
    const std::string& word = words_[k];
    const auto [end, status] = from_chars(word.data(), word.data() + word.size(), value);
    if (status != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      refuse("'" + word + "' is not a number");
    return value;
  }

  std::istringstream in_;
  const std::string& file_;
  std::string line_;
  int number_ = 0;
  std::vector<std::string> words_;
  std::size_t atoms_ = 0;
  MoleculeFile molecule_;
};

}  // namespace

MoleculeFile parse_molecule_file(std::string_view text, const std::string& file) {
  return Parser(text, file).parse();
}

}  // namespace polhode::lammps
