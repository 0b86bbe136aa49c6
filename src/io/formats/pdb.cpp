// SPDX-License-Identifier: MIT
// PDB files: positions in Å with three decimals, in fixed columns; frames are models.
#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "atom_kinds.hpp"
#include "format.hpp"
#include "io/settings/quantity.hpp"
#include "lines.hpp"
#include "text_buffer.hpp"

namespace polhode {
namespace {

// Columns of the format, counted from 1 as in the description of the format.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  return line.size() < first ? std::string_view{} : line.substr(first - 1, last - first + 1);
}

class PdbReader : public FrameReader {
 public:
  PdbReader(std::istream& in, const std::string& file) : lines_(in, file) {}

  bool next(Frame& frame) override {
    frame.source = lines_.file();
    frame.title = title_;
    frame.time = time_;
    frame.has_velocities = false;
    frame.atoms.clear();
    residue_ = 0;
    residue_field_.clear();
    location_ = ' ';
    AtomKinds kinds(frame.kinds);
    bool ended = false, in_model = false;
    while (!ended) {
      const auto line = lines_.next();
      if (!line) {
        if (in_model && !frame.atoms.empty() && !without_ends_)
          lines_.refuse(
              "the file ends within a MODEL, before its ENDMDL: the file is cut off; leave the "
              "last model out, or add its missing lines");
        break;
      }
      const std::string_view record = trimmed(columns(*line, 1, 6));
      if (is_atom(*line))
        frame.atoms.push_back(atom(*line, kinds));
      else if (record == "CRYST1")
        box_ = cell(*line);
      else if (record == "TITLE")
        take_title(frame, columns(*line, 11, line->size()));
      in_model |= record == "MODEL";
      if (record == "ENDMDL" || record == "END" || record == "MODEL") ended = !frame.atoms.empty();
      without_ends_ |= ended && record == "MODEL";  // some programs write no ENDMDL
    }
    if (frame.atoms.empty()) return false;
    if (!(box_.volume() > 0))
      lines_.refuse(
          "there is no CRYST1 record before the end of the atoms; it must give the box, in Å and "
          "degrees: CRYST1   24.830   24.830   24.830  90.00  90.00  90.00 P 1           1");
    frame.box = box_;
    return true;
  }

 private:
  // An atom line begins with "ATOM ", or with "ATOM 1" if a serial number of six digits begins one
  // column early.
  bool is_atom(std::string_view line) const {
    if (line.starts_with("HETATM")) return true;
    if (!line.starts_with("ATOM")) return false;
    const std::string_view rest = columns(line, 5, 6);
    if (rest.empty() || rest.find_first_not_of(" 0123456789") == rest.npos) return true;
    lines_.refuse(fmt::format(
        "the record name '{}' is not supported; atoms must be in records ATOM or HETATM",
        columns(line, 1, 6)));
  }

  // A serial number that is too long may have shifted all other columns to the right.
  void check_columns(std::string_view line) const {
    const auto is_digit = [&](std::size_t k) {
      return line.size() >= k && std::isdigit(static_cast<unsigned char>(line[k - 1])) != 0;
    };
    if (is_digit(12) && columns(line, 35, 35) != ".")
      lines_.refuse(
          "the serial number of an atom extends beyond character 11, so the decimal point of x is "
          "not in character 35; write serial numbers of five characters, modulo 100000 or in "
          "hybrid-36");
  }

  // An atom with alternate locations appears more than once; only one location may remain.
  void check_location(std::string_view line) {
    const char location = columns(line, 17, 17).front();
    if (location == ' ') return;
    if (location_ == ' ') location_ = location;
    if (location != location_)
      lines_.refuse(
          fmt::format("a residue has atoms in the alternate locations '{}' and '{}' (character "
                      "17); each atom must have one position, so delete all other locations",
                      location_, location));
  }

  void take_title(Frame& frame, std::string_view text) {
    frame.title = title_ = trimmed(text);
    frame.time = time_ = title_time(title_);
  }

  Atom atom(std::string_view line, AtomKinds& kinds) {
    Atom atom;
    if (columns(line, 47, 54).empty())
      lines_.refuse(fmt::format(
          "the atom line ends after {} characters; x, y and z must be in characters 31 to 54",
          line.size()));
    check_columns(line);
    for (std::size_t k = 0; k < 3; ++k)
      atom.r[k] = angstrom_ * lines_.number(columns(line, 31 + 8 * k, 38 + 8 * k), "coordinate",
                                            "; x, y and z are in characters 31 to 54");
    const std::string_view named = columns(line, 13, 21);
    std::string key(named);
    key += columns(line, 77, 78);
    atom.kind = kinds.of(key, [&] {
      const std::string_view name = trimmed(named.substr(0, 4));
      if (name.empty())
        lines_.refuse(
            "there is no atom name in characters 13 to 16; atoms are matched to sites by their "
            "names");
      std::string element(trimmed(columns(line, 77, 78)));
      for (std::size_t k = 1; k < element.size(); ++k)
        element[k] = static_cast<char>(std::tolower(static_cast<unsigned char>(element[k])));
      return AtomKind{std::string(trimmed(columns(line, 18, 21))), std::string(name), element};
    });
    atom.residue = residue(columns(line, 22, 27));
    check_location(line);
    return atom;
  }

  // Residue numbers that do not fit into their columns are written as letters or stars, or start
  // again at 0. Residues are therefore counted.
  int residue(std::string_view field) {
    if (residue_ == 0 || field != residue_field_) {
      residue_field_ = field;
      location_ = ' ';
      ++residue_;
    }
    return residue_;
  }

  Box cell(std::string_view line) {
    std::array<double, 6> edges_and_angles;
    for (std::size_t k = 0; k < 3; ++k)
      edges_and_angles[k] = lines_.number(columns(line, 7 + 9 * k, 15 + 9 * k), "box edge");
    for (std::size_t k = 0; k < 3; ++k)
      edges_and_angles[3 + k] = lines_.number(columns(line, 34 + 7 * k, 40 + 7 * k), "box angle");
    for (std::size_t k = 0; k < 3; ++k) {
      if (edges_and_angles[3 + k] != 90)
        lines_.refuse(
            fmt::format("an angle of the box is {} degrees; it must be 90 degrees: only "
                        "rectangular (orthorhombic) boxes are supported",
                        edges_and_angles[3 + k]));
      if (!(edges_and_angles[k] > 0))
        lines_.refuse(
            fmt::format("a box edge is {} Å; it must be longer than 0 Å", edges_and_angles[k]));
    }
    if (edges_and_angles[0] == 1 && edges_and_angles[1] == 1 && edges_and_angles[2] == 1)
      lines_.refuse(
          "the box is 1 x 1 x 1 Å, the PDB convention for a missing box; write the edges of the "
          "periodic box in Å");
    return {angstrom_ *
            Vec3<double>{edges_and_angles[0], edges_and_angles[1], edges_and_angles[2]}};
  }

  Lines lines_;
  std::string title_, residue_field_;
  double time_ = 0;
  int residue_ = 0;
  bool without_ends_ = false;  // whether a model ended with the MODEL line of the next one
  char location_ = ' ';        // alternate location of the atoms of the residue, if they have one
  Box box_{};
  double angstrom_ = unit("A", Dimension::length);
};

// A serial number in five characters. Numbers up to 99999 are decimal; larger numbers are in base
// 36, beginning with A0000 (hybrid-36, cci.lbl.gov/hybrid_36). After ZZZZZ, the serial number
// continues in lower case from a0000.
std::string serial(std::size_t number) {
  constexpr std::size_t width = 5, decimal = 100'000, digit = 36 * 36 * 36 * 36;
  if (number < decimal) return fmt::format("{:5}", number);
  number -= decimal;
  const char ten = number < 26 * digit ? 'A' : 'a';
  number = number % (26 * digit) + 10 * digit;
  std::string text(width, ' ');
  for (std::size_t k = width; k-- > 0; number /= 36) {
    const auto value = static_cast<char>(number % 36);
    text[k] = static_cast<char>(value < 10 ? '0' + value : ten + (value - 10));
  }
  return text;
}

// The name of an atom whose element has one letter begins in the second of four columns.
std::string atom_name(const AtomKind& kind) {
  return kind.name.size() < 4 && kind.element.size() < 2 ? fmt::format(" {:<3}", kind.name)
                                                         : fmt::format("{:<4.4}", kind.name);
}

}  // namespace

std::unique_ptr<FrameReader> pdb_reader(std::istream& in, const std::string& file) {
  return std::make_unique<PdbReader>(in, file);
}

void append_pdb(std::iostream& file, const FrameView& frame, std::uint64_t before) {
  const double angstrom = unit("A", Dimension::length);
  const Vec3<double> edge = frame.box.edge / angstrom;
  TextBuffer text(file);
  text.print("TITLE     {}\n", frame.title);
  text.print("CRYST1{:9.3f}{:9.3f}{:9.3f}  90.00  90.00  90.00 P 1           1\n", edge.x, edge.y,
             edge.z);
  text.print("MODEL     {:4}\n", (before + 1) % 10000);
  std::vector<std::string> names;
  for (const AtomKind& kind : frame.kinds)
    names.push_back(fmt::format(" {} {:<4.4} ", atom_name(kind), kind.residue_name));
  std::size_t number = 0;
  frame.each_atom([&](const Atom& atom) {
    text.append("ATOM  ");
    text.append(serial(++number));
    text.append(names[atom.kind]);
    text.print("{:4}    ", atom.residue % 10000);
    for (std::size_t k = 0; k < 3; ++k) text.fixed(atom.r[k] / angstrom, 8, 3);
    text.print("  1.00  0.00          {:>2.2}", frame.kinds[atom.kind].element);
    text.end_line();
  });
  text.print("ENDMDL\n");
}

}  // namespace polhode
