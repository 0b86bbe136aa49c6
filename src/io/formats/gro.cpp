// SPDX-License-Identifier: MIT
#include "io/coordinates/gro.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>

#include "atom_kinds.hpp"
#include "format.hpp"
#include "lines.hpp"
#include "text_buffer.hpp"

namespace polhode {
namespace {

// The columns of an atom are residue number, residue name, atom name and atom number, with five
// characters each.
constexpr std::size_t first_number = 20;

constexpr const char* in_columns = "; atom lines have columns of fixed width";

// All numbers of a line have the same width: the distance between the first two decimal points.
std::size_t column_width(std::string_view line, const Lines& lines) {
  const auto p1 = line.find('.', first_number);
  const auto p2 = p1 == line.npos ? p1 : line.find('.', p1 + 1);
  const auto p3 = p2 == line.npos ? p2 : line.find('.', p2 + 1);
  if (p3 == line.npos)
    lines.refuse(
        "an atom line ends before its third coordinate; it must have x, y and z, with decimal "
        "points, after the 20 characters of the names");
  if (p3 - p2 != p2 - p1)
    lines.refuse(
        fmt::format("the decimal points of x, y and z are {} and {} characters apart; both "
                    "distances must be equal, since the distance is the column width",
                    p2 - p1, p3 - p2));
  return p2 - p1;
}

std::string_view column(std::string_view line, std::size_t k, std::size_t width) {
  return line.substr(first_number + k * width, width);
}

// Atom kinds are identified by the characters of the residue and atom names.
std::uint32_t kind_of(std::string_view line, AtomKinds& kinds, const Lines& lines) {
  return kinds.of(line.substr(5, 10), [&] {
    const std::string_view name = trimmed(line.substr(10, 5));
    if (name.empty())
      lines.refuse(
          "there is no atom name in characters 11 to 15; atoms are matched to sites by their "
          "names");
    return AtomKind{std::string(trimmed(line.substr(5, 5))), std::string(name), {}};
  });
}

// Reads an atom, and whether it has a velocity; the kind of the atom is determined later.
std::pair<Atom, bool> read_atom(std::string_view line, std::size_t width, const Lines& lines) {
  static constexpr std::array names = {"x coordinate", "y coordinate", "z coordinate",
                                       "x velocity",   "y velocity",   "z velocity"};
  Atom atom;
  const auto residue = parsed<int>(line.substr(0, 5));
  if (!residue)
    lines.refuse(
        fmt::format("found '{}' instead of the residue number in the first five characters",
                    trimmed(line.substr(0, 5))));
  atom.residue = *residue;
  const std::size_t written = line.find_last_not_of(" \t") + 1;
  const bool has_velocity = written > first_number + 3 * width;
  const std::size_t needed = first_number + (has_velocity ? 6 : 3) * width;
  if (written < needed)
    lines.refuse(fmt::format(
        "the line ends after {} characters; the names and three {} of {} characters each need {} "
        "characters",
        written, has_velocity ? "coordinates and three velocities" : "coordinates", width, needed));
  for (std::size_t k = 0; k < 3; ++k)
    atom.r[k] = lines.number(column(line, k, width), names[k], in_columns);
  for (std::size_t k = 0; k < 3 && has_velocity; ++k)
    atom.v[k] = lines.number(column(line, 3 + k, width), names[3 + k], in_columns);
  return {atom, has_velocity};
}

Box read_box(std::string_view line, const Lines& lines) {
  std::vector<double> edges;
  std::string_view rest = line;
  for (auto word = take_word(rest); !word.empty(); word = take_word(rest))
    edges.push_back(lines.number(word, "box edge"));
  if (edges.size() != 3 && edges.size() != 9)
    lines.refuse(
        fmt::format("found '{}' instead of the box; write three edges in nm", trimmed(line)));
  for (std::size_t k = 3; k < edges.size(); ++k)
    if (edges[k] != 0)
      lines.refuse(
          "the box is triclinic, and only rectangular (orthorhombic) boxes are supported; build "
          "the system in a rectangular box, for example with gmx solvate -box 3 3 3");
  for (std::size_t k = 0; k < 3; ++k)
    if (edges[k] <= 0)
      lines.refuse(fmt::format("a box edge is {} nm; it must be longer than 0 nm", edges[k]));
  return {{edges[0], edges[1], edges[2]}};
}

// Residue and atom numbers have five digits; after 99999 they start again at 0.
constexpr int digits5 = 100000;

// The column width of numbers: sign, digits, decimal point and decimals of the widest number. As in
// GROMACS, the width is at least the number of decimals plus five. Readers infer the width from the
// distance between decimal points.
std::size_t width_of(const FrameView& frame, int decimals) {
  double r = 0, v = 0;
  const auto widen = [](double& largest, const Vec3<double>& x) {
    largest = std::max({largest, -10 * x.x, x.x, -10 * x.y, x.y, -10 * x.z,
                        x.z});  // a sign needs the space of a digit
  };
  frame.each_atom([&](const Atom& atom) {
    widen(r, atom.r);
    widen(v, atom.v);
  });
  const double largest =
      frame.has_velocities ? std::max(r, 10 * v) : r;  // velocities have one decimal more
  std::size_t width = static_cast<std::size_t>(decimals) + 5;
  for (double power = 9999; largest > power && power < 1e300; power *= 10) ++width;
  return width;
}

void write(std::ostream& out, const FrameView& frame, int decimals) {
  const std::size_t width = width_of(frame, decimals);
  std::vector<std::string> names;  // names of each kind
  for (const AtomKind& kind : frame.kinds)
    names.push_back(fmt::format("{:<5.5}{:>5.5}", kind.residue_name, kind.name));
  TextBuffer text(out);
  text.print("{}\n{:5}\n", frame.title, frame.atoms);
  int number = 0;
  frame.each_atom([&](const Atom& atom) {
    number = (number + 1) % digits5;
    text.print("{:5}", atom.residue % digits5);
    text.append(names[atom.kind]);
    text.print("{:5}", number);
    for (std::size_t k = 0; k < 3; ++k) text.fixed(atom.r[k], width, decimals);
    for (std::size_t k = 0; k < 3 && frame.has_velocities; ++k)
      text.fixed(atom.v[k], width, decimals + 1);
    text.end_line();
  });
  for (std::size_t k = 0; k < 3; ++k) {
    text.append(" ");  // the numbers of the box have no fixed columns
    text.fixed(frame.box.edge[k], width - 1, decimals);
  }
  text.end_line();
}

// Reads the frames of a file one after another.
class GroReader : public FrameReader {
 public:
  GroReader(std::istream& in, const std::string& file) : lines_(in, file) {}

  bool next(Frame& frame) override {
    auto line = lines_.next();
    if (!line) return false;
    frame.source = lines_.file();
    frame.title = trimmed(*line);
    frame.time = title_time(frame.title);
    line = lines_.next();
    while (frame.title.empty() && line && trimmed(*line).empty()) line = lines_.next();
    if (frame.title.empty() && !line) return false;  // these are blank lines at the end
    if (!line) lines_.refuse("the file ends before the number of atoms");
    const auto count = parsed<std::size_t>(*line);
    if (!count)
      lines_.refuse(fmt::format("found '{}' instead of the number of atoms in the second line",
                                trimmed(*line)));
    read_atoms(frame, *count);
    return true;
  }

 private:
  void read_atoms(Frame& frame, std::size_t count) {
    frame.atoms.clear();
    frame.has_velocities = false;
    AtomKinds kinds(frame.kinds);
    std::size_t width = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto here = [&] {
        return fmt::format("atom {} of {} (the number in the second line)", i + 1, count);
      };
      const std::string_view line = lines_.next(here);
      if (line.size() < first_number || line.find('.') < first_number)
        lines_.refuse(fmt::format("found '{}' instead of {}", trimmed(line), here()));
      if (i == 0) width = column_width(line, lines_);
      auto [atom, has_velocity] = read_atom(line, width, lines_);
      atom.kind = kind_of(line, kinds, lines_);
      if (i == 0) frame.has_velocities = has_velocity;
      if (has_velocity != frame.has_velocities)
        lines_.refuse(
            fmt::format("this atom has {} velocity, but each previous atom has {}; either all "
                        "atoms or no atoms must have velocities",
                        has_velocity ? "a" : "no", has_velocity ? "none" : "one"));
      frame.atoms.push_back(atom);
    }
    const std::string_view box = lines_.next([] { return "the box"; });
    const auto point = box.find('.');
    if (point != box.npos && point >= first_number)
      lines_.refuse(
          fmt::format("found another atom instead of the box; according to the second line, the "
                      "frame has {} atoms",
                      count));
    frame.box = read_box(box, lines_);
  }

  Lines lines_;
};

}  // namespace

double title_time(std::string_view title) {
  // "t=" must be a word, because "count=500" is no time.
  const auto within_word = [&](std::size_t at) {
    return at > 0 && (std::isalnum(static_cast<unsigned char>(title[at - 1])) ||
                      title[at - 1] == '_' || title[at - 1] == '-');
  };
  auto at = title.rfind("t=");
  while (at != title.npos && within_word(at)) at = title.rfind("t=", at - 1);
  if (at == title.npos) return 0;
  std::string_view rest = title.substr(at + 2);
  const auto time = parsed<double>(take_word(rest));
  return time && std::isfinite(*time) ? *time : 0;
}

std::unique_ptr<FrameReader> gro_reader(std::istream& in, const std::string& file) {
  return std::make_unique<GroReader>(in, file);
}

void append_gro(std::iostream& file, const FrameView& frame, std::uint64_t) {
  write(file, frame, 10);
}

Frame parse_gro(std::string_view text, const std::string& file) {
  std::istringstream in{std::string(text)};
  Frame frame;
  if (!GroReader(in, file).next(frame)) throw Error("the file ends before its title", file + ":1");
  return frame;
}

void write_gro(std::ostream& out, const Frame& frame, int decimals) {
  write(out, view_of(frame), decimals);
}

void write_gro(std::ostream& out, const State& state, const Topology& topology, int decimals) {
  write(out, view_of(state, topology), decimals);
}

}  // namespace polhode
