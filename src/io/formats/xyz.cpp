// SPDX-License-Identifier: MIT
// Extended XYZ in the dialect of ASE and OVITO: Lattice, Properties and Time in the comment line.
// Positions are in Å, the time in ps and velocities, if any, in Å/ps. Massless sites, if any, have
// the species X.
#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <utility>

#include "atom_kinds.hpp"
#include "format.hpp"
#include "io/settings/quantity.hpp"
#include "lines.hpp"
#include "text_buffer.hpp"

namespace polhode {
namespace {

constexpr std::string_view massless_species = "X";

// A column of the atom lines: meaning and number of words.
struct Property {
  enum class What { species, position, velocity, residue, other } what;
  std::size_t words;
};

// Reads the Key="value" pairs of a comment line, one after another.
struct Pair {
  std::string_view key, value;
};

std::optional<Pair> take_pair(std::string_view& text) {
  text = trimmed(text);
  if (text.empty()) return std::nullopt;
  const auto end_of_key = text.find_first_of("= \t");
  Pair pair{text.substr(0, end_of_key), {}};
  text.remove_prefix(pair.key.size());
  if (!text.starts_with('=')) return pair;
  text.remove_prefix(1);
  const char quote = text.empty() ? ' ' : text.front();
  if (quote != '"' && quote != '\'' && quote != '{') {
    pair.value = text.substr(0, text.find_first_of(" \t"));
    text.remove_prefix(pair.value.size());
    return pair;
  }
  text.remove_prefix(1);
  pair.value = text.substr(0, text.find(quote == '{' ? '}' : quote));
  text.remove_prefix(std::min(text.size(), pair.value.size() + 1));
  return pair;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

class XyzReader : public FrameReader {
 public:
  XyzReader(std::istream& in, const std::string& file) : lines_(in, file) {}

  bool next(Frame& frame) override {
    auto count_line = lines_.next();
    while (count_line && trimmed(*count_line).empty()) count_line = lines_.next();
    if (!count_line) return false;
    const auto count = parsed<std::size_t>(*count_line);
    if (!count)
      lines_.refuse(
          fmt::format("found '{}' instead of the number of atoms, which must be alone on its line",
                      trimmed(*count_line)));
    frame.source = lines_.file();
    frame.title.clear();
    read_comment(frame);
    read_atoms(frame, *count);
    return true;
  }

 private:
  void read_comment(Frame& frame) {
    frame.time = 0;
    frame.box = {};
    // Without Properties, an atom line consists of an element and x, y, z.
    properties_ = {{Property::What::species, 1}, {Property::What::position, 3}};
    std::string_view rest = lines_.next([] { return "the comment line with the Lattice"; });
    std::array<bool, 4> met{};
    while (const auto pair = take_pair(rest)) {
      refuse_second(pair->key, met);
      if (same_word(pair->key, "lattice")) frame.box = lattice(pair->value);
      if (same_word(pair->key, "properties")) properties_ = columns(pair->value);
      if (same_word(pair->key, "time")) frame.time = lines_.number(pair->value, "Time");
      if (same_word(pair->key, "pbc")) check_periodic(pair->value);
    }
    if (frame.box.volume() == 0)
      lines_.refuse(
          "the comment line has no Lattice; it must give the box, in Å: Lattice=\"10 0 0 0 10 0 0 "
          "0 10\"");
    frame.has_velocities = has(Property::What::velocity);
    for (const auto& [what, name] : {std::pair{Property::What::species, "species:S:1"},
                                     std::pair{Property::What::position, "pos:R:3"}})
      if (!has(what))
        lines_.refuse(
            fmt::format("the Properties do not contain {}, which every atom must have", name));
  }

  // A repeated key is an error, because the value to use is ambiguous.
  void refuse_second(std::string_view key, std::array<bool, 4>& met) const {
    constexpr std::array<std::string_view, 4> once = {"Lattice", "Properties", "Time", "pbc"};
    for (std::size_t k = 0; k < once.size(); ++k)
      if (same_word(key, once[k]) && std::exchange(met[k], true))
        lines_.refuse(
            fmt::format("the comment line has {} twice; delete the wrong entry", once[k]));
  }

  bool has(Property::What what) const {
    return std::any_of(properties_.begin(), properties_.end(),
                       [what](const Property& p) { return p.what == what; });
  }

  void check_periodic(std::string_view text) const {
    std::string_view rest = text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
      if (!same_word(word, "T") && !same_word(word, "true") && word != "1")
        lines_.refuse(
            fmt::format("pbc is \"{}\"; it must be \"T T T\", as only boxes that are periodic in "
                        "all directions are supported",
                        text));
  }

  Box lattice(std::string_view text) const {
    std::array<double, 9> m;
    for (double& x : m) x = lines_.number(take_word(text), "Lattice");
    if (!trimmed(text).empty())
      lines_.refuse(
          "the Lattice has more than nine numbers; it must have three vectors of three numbers "
          "each");
    for (std::size_t k = 0; k < 9; ++k)
      if (k % 4 != 0 && m[k] != 0)
        lines_.refuse(
            "the box is triclinic; only rectangular (orthorhombic) boxes with edges along x, y and "
            "z are supported");
    for (const std::size_t k : {0u, 4u, 8u})
      if (!(m[k] > 0))
        lines_.refuse(fmt::format("a box edge is {} Å; it must be longer than 0 Å", m[k]));
    return {angstrom_ * Vec3<double>{m[0], m[4], m[8]}};
  }

  // Properties such as "species:S:1:pos:R:3" consist of name, type and number of words.
  std::vector<Property> columns(std::string_view text) const {
    using What = Property::What;
    std::vector<Property> found;
    while (!text.empty()) {
      std::array<std::string_view, 3> part;
      for (std::string_view& field : part) {
        field = text.substr(0, text.find(':'));
        text.remove_prefix(std::min(text.size(), field.size() + 1));
      }
      const auto words = parsed<std::size_t>(part[2]);
      if (!words || *words == 0)
        lines_.refuse(
            fmt::format("the Properties have '{}' instead of the number of columns of '{}'; "
                        "Properties must be triples such as species:S:1",
                        part[2], part[0]));
      const auto any_of = [&](std::initializer_list<std::string_view> names) {
        return std::any_of(names.begin(), names.end(),
                           [&](auto name) { return same_word(part[0], name); });
      };
      const What what = any_of({"species", "element"})                      ? What::species
                        : any_of({"pos", "position", "positions"})          ? What::position
                        : any_of({"vel", "velo", "velocity", "velocities"}) ? What::velocity
                        : any_of({"resid", "molid", "mol", "residue"})      ? What::residue
                                                                            : What::other;
      const std::size_t expected = what == What::position || what == What::velocity ? 3 : 1;
      if (what != What::other && *words != expected)
        lines_.refuse(
            fmt::format("'{}' has {} columns; it must have {}", part[0], *words, expected));
      found.push_back({what, *words});
    }
    return found;
  }

  void read_atoms(Frame& frame, std::size_t count) {
    AtomKinds kinds(frame.kinds);
    frame.atoms.clear();
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view rest =
          lines_.next([&] { return fmt::format("atom {} of the {} in the frame", i + 1, count); });
      Atom& atom = frame.atoms.emplace_back();
      for (const auto& [what, words] : properties_) switch (what) {
          case Property::What::species: {
            const std::string_view species = word(rest);
            atom.kind = kinds.of(species, [&] {
              const std::string name(species);
              return AtomKind{{}, name, same_word(name, massless_species) ? "" : name};
            });
            break;
          }
          case Property::What::position:
            atom.r = vector(rest, "position");
            break;
          case Property::What::velocity:
            atom.v = vector(rest, "velocity");
            break;
          case Property::What::residue:
            atom.residue = residue(word(rest));
            break;
          case Property::What::other:
            for (std::size_t k = 0; k < words; ++k) word(rest);
            break;
        }
    }
  }

  int residue(std::string_view field) const {
    const auto number = parsed<int>(field);
    if (!number)
      lines_.refuse(fmt::format("found '{}' instead of the number of the atom's molecule", field));
    return *number;
  }
  std::string_view word(std::string_view& rest) const {
    const std::string_view found = take_word(rest);
    if (found.empty())
      lines_.refuse("the atom line is too short; it must have all columns of Properties");
    return found;
  }
  Vec3<double> vector(std::string_view& rest, const char* what) const {
    Vec3<double> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = angstrom_ * lines_.number(word(rest), what);
    return v;
  }

  Lines lines_;
  std::vector<Property> properties_;
  double angstrom_ = unit("A", Dimension::length);
};

}  // namespace

std::unique_ptr<FrameReader> xyz_reader(std::istream& in, const std::string& file) {
  return std::make_unique<XyzReader>(in, file);
}

void append_xyz(std::iostream& out, const FrameView& frame, std::uint64_t) {
  const double angstrom = unit("A", Dimension::length);
  std::vector<std::string> species;  // species of each kind
  for (const AtomKind& kind : frame.kinds)
    species.push_back(fmt::format("{:<2}", kind.element.empty() ? massless_species : kind.element));
  TextBuffer text(out);
  const Vec3<double> edge = frame.box.edge / angstrom;
  text.print(
      "{}\nLattice=\"{:.10g} 0 0 0 {:.10g} 0 0 0 {:.10g}\" Properties=species:S:1:pos:R:3{} "
      "Time={:.6f} pbc=\"T T T\"\n",
      frame.atoms, edge.x, edge.y, edge.z, frame.has_velocities ? ":velo:R:3" : "", frame.time);
  const auto vector = [&](const Vec3<double>& v) {
    for (std::size_t k = 0; k < 3; ++k) {
      text.append(" ");
      text.fixed(v[k], 14, 8);
    }
  };
  frame.each_atom([&](const Atom& atom) {
    text.append(species[atom.kind]);
    vector(atom.r / angstrom);
    if (frame.has_velocities) vector(atom.v / angstrom);
    text.end_line();
  });
}

}  // namespace polhode
