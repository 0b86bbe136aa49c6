// SPDX-License-Identifier: MIT
// The text of a LAMMPS data file.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "base/suggest.hpp"
#include "io/files/field_line.hpp"
#include "io/files/split_words.hpp"
#include "io/files/text_file.hpp"
#include "io/settings/quantity.hpp"
#include "io/topology/lammps_data.hpp"
#include "io/topology/lammps_export.hpp"
#include "kinds.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::int64_t any = std::numeric_limits<std::int32_t>::max();

// Factors that convert from the LAMMPS unit style real to internal units.
const double angstrom = unit("A", Dimension::length);
const double angstrom_per_fs = angstrom / unit("fs", Dimension::time);
const double kcal = unit("kcal/mol", Dimension::energy);

class Parser {
 public:
  Parser(std::string_view text, const std::string& file)
      : rest_(text), file_(std::make_shared<const std::string>(file)) {
    data_.file = file;
  }
  LammpsData result();

 private:
  using Reader = void (Parser::*)(const FieldLine&);
  static const std::map<std::string, Reader, std::less<>>& readers();

  TextPlace place() const { return {file_, line_}; }
  // Reads the next line and splits it at a '#'.
  std::optional<std::pair<std::string_view, std::string_view>> next();
  void begin(std::string_view name, std::string_view comment);
  void header(const FieldLine&);
  void edge(const FieldLine&, std::size_t axis);

  void mass(const FieldLine&);
  void pair_coefficients(const FieldLine&);
  void pair_ij(const FieldLine&);
  void atom(const FieldLine&);
  void velocity(const FieldLine&);
  void ignore(const FieldLine&) {}  // these interactions are constant within rigid bodies

  int type(const FieldLine&, std::size_t k) const;
  TypePair short_range(const FieldLine&, std::size_t k) const;
  void finish();

  std::string_view rest_;
  std::shared_ptr<const std::string> file_;
  std::size_t line_ = 0;
  std::string_view comment_;  // comment of the line
  Reader reader_ = &Parser::header;
  std::string section_ = "header";
  std::optional<std::int64_t> atoms_;
  std::int64_t types_ = 0;
  std::array<bool, 3> edges_{};
  Vec3<double> low_{};
  std::vector<std::pair<std::int64_t, Vec3<double>>> velocities_;
  LammpsData data_;
};

const std::map<std::string, Parser::Reader, std::less<>>& Parser::readers() {
  static const std::map<std::string, Reader, std::less<>> all = {
      {"Masses", &Parser::mass},
      {"Atoms", &Parser::atom},
      {"Velocities", &Parser::velocity},
      {"Pair Coeffs", &Parser::pair_coefficients},
      {"PairIJ Coeffs", &Parser::pair_ij},
      {"Bond Coeffs", &Parser::ignore},
      {"Angle Coeffs", &Parser::ignore},
      {"Dihedral Coeffs", &Parser::ignore},
      {"Improper Coeffs", &Parser::ignore},
      {"BondBond Coeffs", &Parser::ignore},
      {"BondAngle Coeffs", &Parser::ignore},
      {"Bonds", &Parser::ignore},
      {"Angles", &Parser::ignore},
      {"Dihedrals", &Parser::ignore},
      {"Impropers", &Parser::ignore},
  };
  return all;
}

std::optional<std::pair<std::string_view, std::string_view>> Parser::next() {
  if (rest_.empty()) return std::nullopt;
  ++line_;
  const auto end = std::min(rest_.find('\n'), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  const auto hash = line.find('#');
  return std::pair{trimmed(line.substr(0, hash)),
                   hash == line.npos ? "" : trimmed(line.substr(hash + 1))};
}

void Parser::begin(std::string_view name, std::string_view comment) {
  const FieldLine here(name, place());
  const auto known = readers().find(name);
  if (known == readers().end()) {
    std::vector<std::string> names;
    for (const auto& [section, reader] : readers()) names.push_back(section);
    here.refuse(fmt::format("there is no section '{}'{}; the supported sections are: {}",
                            name.substr(0, 40), did_you_mean(name.substr(0, 40), names),
                            join_names(names)));
  }
  if (name == "Atoms" && !comment.empty() && comment != "full")
    here.refuse(
        fmt::format("the atom style is '{}'; it must be full, which has molecule, type and charge",
                    comment.substr(0, 40)));
  if (name == "Atoms" && !(edges_[0] && edges_[1] && edges_[2]))
    here.refuse(
        "the atoms precede the box; its edges 'xlo xhi', 'ylo yhi' and 'zlo zhi' must be in the "
        "header");
  section_ = name;
  reader_ = known->second;
  if (name != "Pair Coeffs" && name != "PairIJ Coeffs") return;
  data_.pair_style = comment;
  // Parameters of a style that is not supported have another meaning. Coordinates need none.
  if (!law_of_pair_style(data_.pair_style)) reader_ = &Parser::ignore;
}

// Reads a number and its meaning in the header; only the numbers of atoms and atom types, and the
// box, are used.
void Parser::header(const FieldLine& line) {
  const auto ends_with = [&](std::initializer_list<std::string_view> words) {
    if (line.size() < words.size()) return false;
    std::size_t k = line.size() - words.size();
    for (const std::string_view word : words)
      if (line[k++] != word) return false;
    return true;
  };
  if (ends_with({"xlo", "xhi"})) return edge(line, 0);
  if (ends_with({"ylo", "yhi"})) return edge(line, 1);
  if (ends_with({"zlo", "zhi"})) return edge(line, 2);
  if (ends_with({"xy", "xz", "yz"})) {
    line.require(6, "three tilts, and xy xz yz");
    for (std::size_t k = 0; k < 3; ++k)
      if (line.number(k, "tilt") != 0)
        line.refuse(
            "the box is triclinic, and only rectangular (orthorhombic) boxes, with tilts of 0, are "
            "supported; build the system in a rectangular box, for example with 'region box block' "
            "in LAMMPS");
    return;
  }
  if (ends_with({"avec"}) || ends_with({"bvec"}) || ends_with({"cvec"}))
    line.refuse(
        "the box is general triclinic, and only rectangular (orthorhombic) boxes, given by 'xlo "
        "xhi', are supported; build the system in a rectangular box, for example with 'region box "
        "block' in LAMMPS");
  if (line.size() == 2 && line[1] == "atoms")
    atoms_ = line.integer(0, "number of atoms", 0, any);
  else if (ends_with({"atom", "types"}))
    types_ = line.integer(0, "number of atom types", 0, any);
  else if (line.size() < 2 || std::isdigit(static_cast<unsigned char>(line[0].front())) == 0)
    line.refuse(
        fmt::format("found '{}' in the header instead of a number with its meaning, such as '648 "
                    "atoms', or the name of a section",
                    line[0].substr(0, 40)));
}

void Parser::edge(const FieldLine& line, std::size_t axis) {
  line.require(4, "lower and upper bound, and their names");
  const double low = line.number(0, "lower end"), high = line.number(1, "upper end");
  const double edge = (high - low) * angstrom;
  if (!(edge > 0) || !std::isfinite(edge))
    line.refuse(
        fmt::format("the box extends from {} to {} Å; its edges must be longer than 0", low, high));
  low_[axis] = low;
  data_.box.edge[axis] = edge;
  edges_[axis] = true;
}

int Parser::type(const FieldLine& line, std::size_t k) const {
  if (types_ == 0)
    line.refuse(
        "the header does not contain the number of atom types; write for example '2 atom types'");
  return static_cast<int>(line.integer(k, "atom type", 1, types_));
}

void Parser::mass(const FieldLine& line) {
  line.require(2, "atom type and mass");
  const double mass = line.number(1, "mass");
  if (mass <= 0) line.refuse(fmt::format("the mass is {} u; it must be above 0 u", mass));
  LammpsData::AtomType& t = data_.types[type(line, 0)];
  t.mass = mass;
  if (const auto point = comment_.rfind('.'); point != comment_.npos)
    t.site = comment_.substr(point + 1);  // exports name a site "tip4p.HW1"
}

// Reads the potential from the fields with index k and higher. The pair style selects the
// potential; without a style the potential is Lennard-Jones.
TypePair Parser::short_range(const FieldLine& line, std::size_t k) const {
  TypePair pair{.place = line.place()};
  const auto law = law_of_pair_style(data_.pair_style);
  if (law == LammpsLaw::buckingham) {
    line.require(k + 3, "atom types, A, rho and C");
    const double A = line.number(k, "A") * kcal, rho = line.number(k + 1, "rho") * angstrom,
                 C = line.number(k + 2, "C") * kcal * std::pow(angstrom, 6);
    if (A != 0 || C != 0) pair.law = BuckinghamLaw{A, 1 / rho, C};
  } else {
    const double epsilon = line.number(k, "epsilon"), sigma = line.number(k + 1, "sigma");
    if (epsilon < 0 || sigma < 0)
      line.refuse(fmt::format("epsilon is {} kcal/mol and sigma {} Å; both must be 0 or more",
                              epsilon, sigma));
    pair.sigma = sigma * angstrom, pair.epsilon = epsilon * kcal;
    if (law == LammpsLaw::mie) {
      line.require(k + 4, "atom types, epsilon, sigma and two exponents");
      pair.law = MieLaw{line.number(k + 2, "repulsive exponent"),
                        line.number(k + 3, "attractive exponent")};
    }
  }
  try {
    check(pair.sigma, pair.epsilon, pair.law);
  } catch (const Error& e) {
    line.refuse(e.what());
  }
  return pair;
}

void Parser::pair_coefficients(const FieldLine& line) {
  line.require(3, "atom type and the parameters of the pair style");
  const TypePair own = short_range(line, 1);
  LammpsData::AtomType& t = data_.types[type(line, 0)];
  t.sigma = own.sigma, t.epsilon = own.epsilon, t.law = own.law, t.has_pair_coefficients = true;
}

void Parser::pair_ij(const FieldLine& line) {
  line.require(4, "two atom types and the parameters of the pair style");
  const int first = type(line, 0), second = type(line, 1);
  TypePair pair = short_range(line, 2);
  if (first == second) {
    LammpsData::AtomType& t = data_.types[first];
    t.sigma = pair.sigma, t.epsilon = pair.epsilon, t.law = pair.law;
    t.has_pair_coefficients = true;
  } else {
    pair.first = std::to_string(first), pair.second = std::to_string(second);
    data_.pairs.push_back(std::move(pair));
  }
}

void Parser::atom(const FieldLine& line) {
  line.require(7, "id, molecule, type, charge, x, y, z");
  LammpsData::Atom atom{};
  atom.id = line.integer(0, "atom id", 1, std::numeric_limits<std::int64_t>::max());
  atom.molecule = line.integer(1, "molecule id", 0, std::numeric_limits<std::int64_t>::max());
  atom.type = type(line, 2);
  atom.charge = line.number(3, "charge");
  if (line.size() != 7 && line.size() != 10)
    line.refuse(
        fmt::format("the line has {} fields; it must have 7, or 10 with image flags: id, "
                    "molecule, type, charge, x, y, z, nx, ny, nz",
                    line.size()));
  for (std::size_t k = 0; k < 3; ++k) {
    static constexpr std::array names = {"x coordinate", "y coordinate", "z coordinate"};
    atom.r[k] = (line.number(4 + k, names[k]) - low_[k]) * angstrom;
    if (line.size() == 10)
      atom.r[k] +=
          data_.box.edge[k] * static_cast<double>(line.integer(7 + k, "image flag", -any, any));
  }
  data_.atoms.push_back(atom);
}

void Parser::velocity(const FieldLine& line) {
  line.require(4, "atom id, and the velocity along x, y and z");
  Vec3<double> v{};
  for (std::size_t k = 0; k < 3; ++k) v[k] = line.number(1 + k, "velocity") * angstrom_per_fs;
  velocities_.emplace_back(line.integer(0, "atom id", 1, std::numeric_limits<std::int64_t>::max()),
                           v);
}

// Checks the file as a whole.
void Parser::finish() {
  const auto refuse = [&](const std::string& what) { throw Error(what, data_.file); };
  if (!atoms_)
    refuse("the header does not contain the number of atoms; write for example '648 atoms'");
  auto& atoms = data_.atoms;
  if (static_cast<std::int64_t>(atoms.size()) != *atoms_)
    refuse(fmt::format(
        "the header specifies {} atoms, but the section Atoms has {}; both numbers must be equal",
        *atoms_, atoms.size()));
  if (atoms.empty()) refuse("the file has no atoms; it must have at least one");
  for (const LammpsData::Atom& atom : atoms)
    if (const auto known = data_.types.find(atom.type);
        known == data_.types.end() || known->second.mass == 0)
      refuse(fmt::format("atom type {} has no mass; the section Masses must contain the mass",
                         atom.type));
  for (auto& [number, type] : data_.types)
    if (type.mass <= lammps_massless) type.mass = 0;
  std::sort(atoms.begin(), atoms.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  for (std::size_t k = 1; k < atoms.size(); ++k)
    if (atoms[k].id == atoms[k - 1].id)
      refuse(fmt::format("there are two atoms with the id {}; ids must differ", atoms[k].id));
  data_.has_velocities = !velocities_.empty();
  for (const auto& [id, v] : velocities_) {
    const auto atom = std::lower_bound(atoms.begin(), atoms.end(), id,
                                       [](const auto& a, std::int64_t i) { return a.id < i; });
    if (atom == atoms.end() || atom->id != id)
      refuse(fmt::format("there is a velocity for atom {}, but no such atom; delete this velocity",
                         id));
    atom->v = v;
  }
}

LammpsData Parser::result() {
  if (const auto title = next()) data_.title = title->first.empty() ? title->second : title->first;
  constexpr std::string_view units = "units = ";
  if (const auto at = data_.title.find(units); at != data_.title.npos) {
    std::string_view rest = std::string_view(data_.title).substr(at + units.size());
    const std::string_view name = take_word(rest);
    if (name != "real")
      throw Error(fmt::format("the units are '{}'; they must be 'real' (Å, fs, kcal/mol)",
                              name.substr(0, 40)),
                  text_of(place()));
  }
  while (const auto line = next()) {
    const auto& [text, comment] = *line;
    if (text.empty()) continue;
    comment_ = comment;
    if (std::isupper(static_cast<unsigned char>(text.front())))
      begin(text, comment);
    else
      (this->*reader_)(FieldLine(text, place()));
  }
  finish();
  sort_into_kinds(data_);
  return std::move(data_);
}

}  // namespace

std::optional<LammpsLaw> law_of_pair_style(std::string_view style) {
  std::string_view name = take_word(style);
  if (name.empty()) return LammpsLaw::lennard_jones;
  for (const std::string_view suffix : {"/gpu", "/intel", "/kk", "/omp", "/opt"})
    if (name.ends_with(suffix)) {
      name.remove_suffix(suffix.size());
      break;
    }
  // Some unsupported styles begin with the name of a supported style: lj/cut/soft,
  // lj/cut/thole/long, lj/cut/dipole/cut, buck/mdf.
  constexpr std::pair<std::string_view, LammpsLaw> known[] = {
      {"lj/cut", LammpsLaw::lennard_jones},
      {"lj/cut/coul/cut", LammpsLaw::lennard_jones},
      {"lj/cut/coul/debye", LammpsLaw::lennard_jones},
      {"lj/cut/coul/dsf", LammpsLaw::lennard_jones},
      {"lj/cut/coul/long", LammpsLaw::lennard_jones},
      {"lj/cut/coul/msm", LammpsLaw::lennard_jones},
      {"lj/cut/coul/wolf", LammpsLaw::lennard_jones},
      {"buck", LammpsLaw::buckingham},
      {"buck/coul/cut", LammpsLaw::buckingham},
      {"buck/coul/long", LammpsLaw::buckingham},
      {"buck/coul/msm", LammpsLaw::buckingham},
      {"mie/cut", LammpsLaw::mie}};
  for (const auto& [known_name, law] : known)
    if (name == known_name) return law;
  return std::nullopt;
}

LammpsData parse_lammps_data(std::string_view text, const std::string& file) {
  return Parser(text, file).result();
}

LammpsData read_lammps_data(const std::string& path) {
  return parse_lammps_data(file_text(path), path);
}

}  // namespace polhode
