// SPDX-License-Identifier: MIT
// The sections of a GROMACS topology.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "base/suggest.hpp"
#include "bonded_key.hpp"
#include "io/files/field_line.hpp"
#include "io/files/split_words.hpp"
#include "polhode/base/error.hpp"
#include "preprocessor.hpp"

namespace polhode {
namespace {

using Kind = GromacsRelation::Kind;

// Maximum counts, above the needs of any rigid body. These limits bound the memory that a file can
// demand.
constexpr std::size_t max_relations = 1'000'000, max_blocks = 64;
constexpr std::int64_t any = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t lennard_jones_function = 1, buckingham_function = 2;

class Parser {
 public:
  explicit Parser(const std::string& file) { topology_.file = file; }
  void take(const gromacs::Line& line);
  GromacsTopology result() &&;

 private:
  using Reader = void (Parser::*)(const FieldLine&);
  static const std::map<std::string, Reader, std::less<>>& readers();

  void begin_section(const FieldLine& line, std::string_view text);
  bool is_of_force_field() const;

  void defaults(const FieldLine&);
  void atom_type(const FieldLine&);
  void nonbond_pair(const FieldLine&);
  void bond_type(const FieldLine& l) { equilibrium(l, 2, topology_.equilibrium.bonds); }
  void constraint_type(const FieldLine& l) { equilibrium(l, 2, topology_.equilibrium.constraints); }
  void angle_type(const FieldLine& l) { equilibrium(l, 3, topology_.equilibrium.angles); }
  void molecule_type(const FieldLine&);
  void atom(const FieldLine&);
  void settle(const FieldLine& l) { relation(l, Kind::settle, 1, 2); }
  void constraint(const FieldLine& l) { relation(l, Kind::constraint, 2, 1); }
  void bond(const FieldLine& l) { relation(l, Kind::bond, 2, 1); }
  void angle(const FieldLine& l) { relation(l, Kind::angle, 3, 1); }
  void virtual_site2(const FieldLine& l) { relation(l, Kind::virtual2, 3, 1); }
  void virtual_site3(const FieldLine& l) { relation(l, Kind::virtual3, 4, 3); }
  void block(const FieldLine&);
  // Interactions that are constant within a rigid body, and sections without meaning for it.
  void inside(const FieldLine& line) { current(line); }
  void ignore(const FieldLine&) {}
  void obstacle(const FieldLine&);
  void between(const FieldLine& line);

  GromacsMolecule& current(const FieldLine& line);
  TypePair short_range(const FieldLine& line, std::size_t first) const;
  TypePair lennard_jones(const FieldLine& line, std::size_t first) const;
  TypePair buckingham(const FieldLine& line, std::size_t first) const;
  void equilibrium(const FieldLine& line, std::size_t atoms, std::map<std::string, double>& values);
  void relation(const FieldLine& line, Kind kind, std::size_t atoms, std::size_t numbers);

  GromacsTopology topology_;
  std::map<std::string, std::size_t> molecule_index_;
  std::string section_;
  Reader reader_ = nullptr;
  int combination_ = 0;
  std::int64_t function_ = lennard_jones_function;  // function of all pairs, from [ defaults ]
  std::size_t relations_ = 0;
};

const std::map<std::string, Parser::Reader, std::less<>>& Parser::readers() {
  static const std::map<std::string, Reader, std::less<>> all = {
      {"defaults", &Parser::defaults},
      {"atomtypes", &Parser::atom_type},
      {"nonbond_params", &Parser::nonbond_pair},
      {"bondtypes", &Parser::bond_type},
      {"constrainttypes", &Parser::constraint_type},
      {"angletypes", &Parser::angle_type},
      {"moleculetype", &Parser::molecule_type},
      {"atoms", &Parser::atom},
      {"settles", &Parser::settle},
      {"constraints", &Parser::constraint},
      {"bonds", &Parser::bond},
      {"angles", &Parser::angle},
      {"virtual_sites2", &Parser::virtual_site2},
      {"dummies2", &Parser::virtual_site2},
      {"virtual_sites3", &Parser::virtual_site3},
      {"dummies3", &Parser::virtual_site3},
      {"system", &Parser::ignore},
      {"molecules", &Parser::block},
      {"exclusions", &Parser::inside},
      {"pairs", &Parser::inside},
      {"pairs_nb", &Parser::inside},
      {"dihedrals", &Parser::inside},
      {"cmap", &Parser::inside},
      {"angle_restraints", &Parser::inside},
      {"dihedral_restraints", &Parser::inside},
      {"pairtypes", &Parser::ignore},
      {"dihedraltypes", &Parser::ignore},
      {"cmaptypes", &Parser::ignore},
      {"implicit_genborn_params", &Parser::ignore},
      {"virtual_sites1", &Parser::obstacle},
      {"virtual_sites4", &Parser::obstacle},
      {"dummies4", &Parser::obstacle},
      {"virtual_sitesn", &Parser::obstacle},
      {"polarization", &Parser::obstacle},
      {"thole_polarization", &Parser::obstacle},
      {"water_polarization", &Parser::obstacle},
      {"position_restraints", &Parser::obstacle},
      {"distance_restraints", &Parser::obstacle},
      {"orientation_restraints", &Parser::obstacle},
      {"angle_restraints_z", &Parser::obstacle},
      {"intermolecular_interactions", &Parser::between},
  };
  return all;
}

void Parser::take(const gromacs::Line& line) {
  const FieldLine fields(line.text, line.place);
  if (line.text.front() == '[') {
    begin_section(fields, line.text);
  } else if (section_ == "system" && topology_.title.empty()) {
    topology_.title = line.text;
  } else if (reader_ == nullptr) {
    fields.refuse(
        fmt::format("'{}' precedes the first section; a topology must begin with [ defaults ], or "
                    "with an #include of a force field that begins with [ defaults ]",
                    line.text.substr(0, 40)));
  } else {
    (this->*reader_)(fields);
  }
}

void Parser::begin_section(const FieldLine& line, std::string_view text) {
  const auto close = text.find(']');
  if (close == text.npos || close + 1 != text.size())
    line.refuse("the section name begins with '[' and must end with ']', as in [ atoms ]");
  section_ = trimmed(text.substr(1, close - 1));
  const auto known = readers().find(section_);
  if (known == readers().end()) {
    std::vector<std::string> names;
    for (const auto& [name, reader] : readers()) names.push_back(name);
    line.refuse(fmt::format("there is no section [ {} ]{}", section_.substr(0, 40),
                            did_you_mean(section_.substr(0, 40), names)));
  }
  reader_ = known->second;
  if (reader_ == &Parser::between) between(line);
  if (is_of_force_field() && !topology_.molecules.empty())
    line.refuse(
        fmt::format("[ {} ] is after [ moleculetype ] '{}', whose atoms already have their "
                    "parameters; as in GROMACS, the force field must precede all molecules",
                    section_, topology_.molecules.back().name));
}

bool Parser::is_of_force_field() const {
  constexpr std::array all = {&Parser::defaults,  &Parser::atom_type,       &Parser::nonbond_pair,
                              &Parser::bond_type, &Parser::constraint_type, &Parser::angle_type};
  return std::find(all.begin(), all.end(), reader_) != all.end();
}

void Parser::between(const FieldLine& line) {
  line.refuse(
      "the section [ intermolecular_interactions ] is not supported for rigid bodies; delete the "
      "section");
}

void Parser::defaults(const FieldLine& line) {
  line.require(2, "nbfunc and comb-rule");
  if (combination_ != 0) line.refuse("[ defaults ] is given twice; include one force field only");
  function_ = line.integer(0, "nbfunc", 1, any);
  if (function_ > buckingham_function)
    line.refuse(
        fmt::format("nbfunc is {}; it must be 1, Lennard-Jones, or 2, Buckingham", function_));
  combination_ = static_cast<int>(line.integer(1, "comb-rule", 1, 3));
  topology_.rule = combination_ == 2 ? MixingRule::lorentz_berthelot : MixingRule::geometric;
}

// Reads the potential in the fields from `first` on. The type names of the pair are left empty.
TypePair Parser::short_range(const FieldLine& line, std::size_t first) const {
  if (combination_ == 0)
    line.refuse(
        "parameters precede [ defaults ], which defines the meaning of these parameters; put [ "
        "defaults ] first");
  return function_ == buckingham_function ? buckingham(line, first) : lennard_jones(line, first);
}

// Reads σ and ε from two fields, which contain C6 and C12 instead if the combination rule is 1. A
// negative ε marks a pair for which only one of C6 and C12 is 0.
TypePair Parser::lennard_jones(const FieldLine& line, std::size_t first) const {
  TypePair pair{.place = line.place()};
  const bool powers = combination_ == 1;
  const double a = line.number(first, powers ? "C6" : "sigma");
  const double b = line.number(first + 1, powers ? "C12" : "epsilon");
  if (a < 0 || b < 0)
    line.refuse(fmt::format("{} = {} and {} = {}; both must be 0 or more", powers ? "C6" : "sigma",
                            a, powers ? "C12" : "epsilon", b));
  if (!powers)
    pair.sigma = a, pair.epsilon = b;
  else if (a > 0 && b > 0)
    pair.sigma = std::pow(b / a, 1.0 / 6), pair.epsilon = a * a / (4 * b);
  else if (a > 0 || b > 0)
    pair.epsilon = -1;
  return pair;
}

// Reads the Buckingham parameters A, B and C, which are all 0 if there is no interaction.
TypePair Parser::buckingham(const FieldLine& line, std::size_t first) const {
  line.require(first + 3, "the three parameters A, B and C of a Buckingham potential at the end");
  TypePair pair{.place = line.place()};
  const BuckinghamLaw law{line.number(first, "A"), line.number(first + 1, "B"),
                          line.number(first + 2, "C")};
  if (law == BuckinghamLaw{}) return pair;
  try {
    check(0, 0, law);
  } catch (const Error& e) {
    line.refuse(e.what());
  }
  pair.law = law;
  return pair;
}

// The fields of an atom type are: name [bonded type] [atomic number] mass charge particle V W. The
// position of the particle type, a single letter, shows which optional fields are present.
void Parser::atom_type(const FieldLine& line) {
  constexpr std::string_view columns =
      "name, optional bonded type and atomic number, mass, charge, particle type, and two "
      "parameters for Lennard-Jones or three for Buckingham";
  line.require(6, columns);
  const auto is_particle = [&](std::size_t k) {
    return k + 2 < line.size() && line[k].size() == 1 &&
           std::isalpha(static_cast<unsigned char>(line[k].front()));
  };
  const std::size_t particle = is_particle(5) ? 5 : is_particle(3) ? 3 : 4;
  if (!is_particle(particle))
    line.refuse(
        fmt::format("no field from the fourth to the sixth is a particle type (A, V, D or S); the "
                    "fields must be: {}",
                    columns));
  GromacsAtomType type{.name = line.word(0), .bonded = line.word(0), .place = line.place()};
  const bool letter = std::isalpha(static_cast<unsigned char>(line[1].front()));
  if (particle == 5 || (particle == 4 && letter)) type.bonded = line.word(1);
  if (particle == 5 || (particle == 4 && !letter))
    type.atomic_number = static_cast<int>(line.integer(particle - 3, "atomic number", -1, 1000));
  type.mass = line.number(particle - 2, "mass");
  type.charge = line.number(particle - 1, "charge");
  const TypePair own = short_range(line, particle + 1);
  type.sigma = own.sigma, type.epsilon = own.epsilon, type.law = own.law;
  if (type.epsilon < 0) type.one_sided = true, type.epsilon = 0;
  const auto [known, is_new] = topology_.types.try_emplace(type.name, type);
  if (!is_new && !known->second.same_parameters(type))
    line.refuse(
        fmt::format("atom type '{}' is already defined in {} with other parameters; delete one of "
                    "the definitions",
                    type.name, text_of(known->second.place)));
}

void Parser::nonbond_pair(const FieldLine& line) {
  line.require(5, "two atom types, function, and the parameters of the potential");
  if (line.integer(2, "function", 1, any) != function_)
    line.refuse(fmt::format("the function type is {}; it must be {}, as in [ defaults ]", line[2],
                            function_));
  TypePair pair = short_range(line, 3);
  pair.first = line.word(0), pair.second = line.word(1);
  topology_.pairs.push_back(std::move(pair));
}

void Parser::equilibrium(const FieldLine& line, std::size_t atoms,
                         std::map<std::string, double>& values) {
  if (line.size() < atoms + 2) return;  // the function has no parameters
  std::vector<std::string> types;
  for (std::size_t k = 0; k < atoms; ++k) types.push_back(line.word(k));
  values[gromacs::bonded_key(types)] = line.number(atoms + 1, atoms == 2 ? "length" : "angle");
}

void Parser::molecule_type(const FieldLine& line) {
  line.require(2, "name and nrexcl");
  const auto [known, is_new] =
      molecule_index_.try_emplace(line.word(0), topology_.molecules.size());
  if (!is_new)
    line.refuse(
        fmt::format("molecule type '{}' is already defined in {}; rename or delete one of the two",
                    line[0], text_of(topology_.molecules[known->second].place)));
  topology_.molecules.push_back({.name = line.word(0), .place = line.place()});
}

GromacsMolecule& Parser::current(const FieldLine& line) {
  if (topology_.molecules.empty())
    line.refuse(
        fmt::format("[ {} ] precedes the first [ moleculetype ]; this section must follow the [ "
                    "moleculetype ] that it describes",
                    section_));
  return topology_.molecules.back();
}

void Parser::obstacle(const FieldLine& line) {
  GromacsMolecule& molecule = current(line);
  if (!molecule.obstacle.empty()) return;
  molecule.obstacle = section_;
  molecule.obstacle_place = line.place();
}

void Parser::atom(const FieldLine& line) {
  GromacsMolecule& molecule = current(line);
  line.require(6, "number, type, residue number, residue, atom name, charge group");
  const auto expected = static_cast<std::int64_t>(molecule.atoms.size()) + 1;
  if (line.integer(0, "atom number", 1, any) != expected)
    line.refuse(
        fmt::format("found atom {} instead of atom {}; atoms must be numbered consecutively from 1",
                    line[0], expected));
  const auto type = topology_.types.find(line.word(1));
  if (type == topology_.types.end())
    line.refuse(
        fmt::format("atom type '{}' is not defined before this line, in [ atomtypes ]; include the "
                    "force field that defines it",
                    line[1].substr(0, 40)));
  GromacsAtom atom{line.word(1), line.word(4), type->second.charge, type->second.mass,
                   line.place()};
  if (line.size() > 6) atom.charge = line.number(6, "charge");
  if (line.size() > 7) atom.mass = line.number(7, "mass");
  if (atom.mass < 0) line.refuse(fmt::format("the mass is {} u; it must be 0 or more", atom.mass));
  molecule.atoms.push_back(std::move(atom));
}

// The fields of a bonded interaction are: atoms, function type, parameters. Further parameters,
// such as force constants or parameters of a perturbed state, are ignored.
void Parser::relation(const FieldLine& line, Kind kind, std::size_t atoms, std::size_t numbers) {
  GromacsMolecule& molecule = current(line);
  line.require(atoms, fmt::format("{} atoms, a function and its parameters", atoms));
  if (++relations_ > max_relations)
    line.refuse(
        fmt::format("there are more than {} bonds, constraints and other interactions, more than "
                    "rigid molecules need; delete unused molecule types",
                    max_relations));
  GromacsRelation relation{.kind = kind, .place = line.place()};
  for (std::size_t k = 0; k < atoms; ++k)
    relation.atoms[k] = static_cast<std::uint32_t>(
        line.integer(k, "atom number", 1, static_cast<std::int64_t>(molecule.atoms.size())) - 1);
  if (kind == Kind::settle && relation.atoms[0] + 3 > molecule.atoms.size())
    line.refuse(fmt::format("atom {} must be followed by two hydrogen atoms for [ settles ]",
                            relation.atoms[0] + 1));
  if (line.size() > atoms)
    relation.function = static_cast<std::uint8_t>(line.integer(atoms, "function", 1, 255));
  if (kind == Kind::settle || kind == Kind::virtual2 || kind == Kind::virtual3) {
    if (kind == Kind::virtual3 && relation.function != 4) numbers = 2;
    line.require(atoms + 1 + numbers,
                 fmt::format("{} atoms, a function and {} numbers", atoms, numbers));
  }
  for (std::size_t k = 0; k < numbers && atoms + 1 + k < line.size(); ++k)
    relation.numbers[relation.given++] = line.number(atoms + 1 + k, "parameter");
  molecule.relations.push_back(std::move(relation));
}

void Parser::block(const FieldLine& line) {
  line.require(2, "name and count");
  const auto known = molecule_index_.find(line.word(0));
  if (known == molecule_index_.end()) {
    std::vector<std::string> names;
    for (const auto& [name, index] : molecule_index_) names.push_back(name);
    line.refuse(fmt::format("molecule type '{}' is not defined before this line{}",
                            line[0].substr(0, 40), did_you_mean(line[0].substr(0, 40), names)));
  }
  const auto count = static_cast<std::size_t>(line.integer(1, "count", 0, 1'000'000'000));
  if (count == 0) return;
  auto& blocks = topology_.blocks;
  if (!blocks.empty() && blocks.back().molecule == known->second) {
    blocks.back().count += count;
    return;
  }
  if (blocks.size() == max_blocks)
    line.refuse(
        fmt::format("[ molecules ] has more than {} blocks of different molecules; sort the "
                    "molecules by type, here and in the coordinate file",
                    max_blocks));
  blocks.push_back({known->second, count});
}

GromacsTopology Parser::result() && {
  if (topology_.blocks.empty())
    throw Error(
        "the topology contains no molecules; it must end with [ molecules ], with a name and a "
        "count on each line",
        topology_.file);
  return std::move(topology_);
}

}  // namespace

GromacsTopology parse_gromacs(std::string_view text, const std::string& file,
                              const IncludeLoader& loader,
                              const std::vector<std::string>& defines) {
  gromacs::Preprocessor lines(text, file, loader, defines);
  Parser parser(file);
  while (const auto line = lines.next()) parser.take(*line);
  return std::move(parser).result();
}

}  // namespace polhode
