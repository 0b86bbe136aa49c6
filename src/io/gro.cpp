// SPDX-License-Identifier: MIT
#include "polhode/io/gro.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <ostream>
#include <unordered_map>

#include "polhode/base/error.hpp"
#include "polhode/io/embedded.hpp"
#include "polhode/io/lammps_data.hpp"
#include "text_buffer.hpp"
#include "text_file.hpp"

namespace polhode {
namespace {

// Columns of an atom: residue number and name, atom name, atom number, five characters each.
constexpr std::size_t first_number = 20;

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

// Goes through a text line by line and knows where it is.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// @param expected  tells what the line must be
  template <class Expected>
  std::string_view next(const Expected& expected) {
    ++number_;
    if (text_.empty()) refuse(fmt::format("the file ends where {} must stand", expected()));
    const auto end = text_.find('\n');
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == text_.npos ? text_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(what, fmt::format("{}:{}", file_, number_));
  }

 private:
  std::string_view text_;
  std::string file_;
  std::size_t number_ = 0;
};

std::optional<double> parsed(std::string_view field) {
  field = trimmed(field);
  double value = 0;
  const auto [end, status] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (status != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

double number(std::string_view field, const char* what, const Lines& lines) {
  const auto value = parsed(field);
  if (!value)
    lines.refuse(
        fmt::format("'{}' stands where the {} must be a number; lines of atoms have "
                    "columns of fixed width",
                    trimmed(field), what));
  if (!std::isfinite(*value))
    lines.refuse(fmt::format("the {} is {}; it must be a finite number", what, trimmed(field)));
  return *value;
}

// All numbers of a line have the width between its first two decimal points.
std::size_t column_width(std::string_view line, const Lines& lines) {
  const auto p1 = line.find('.', first_number);
  const auto p2 = p1 == line.npos ? p1 : line.find('.', p1 + 1);
  const auto p3 = p2 == line.npos ? p2 : line.find('.', p2 + 1);
  if (p3 == line.npos)
    lines.refuse(
        "a line of an atom ends before its third coordinate; it must hold x, y and z with "
        "decimal points after 20 characters of names");
  if (p3 - p2 != p2 - p1)
    lines.refuse(
        fmt::format("the decimal points of x, y and z are {} and {} characters apart; "
                    "they must be equally far, since their distance is the width of "
                    "columns",
                    p2 - p1, p3 - p2));
  return p2 - p1;
}

std::string_view column(std::string_view line, std::size_t k, std::size_t width) {
  return line.substr(first_number + k * width, width);
}

struct AtomLine {
  Atom atom;
  bool has_velocity = false;
};

// The kinds of atoms that have been met, by the characters that name them.
class Kinds {
 public:
  std::uint32_t of(std::string_view line, std::vector<AtomKind>& kinds, const Lines& lines) {
    const auto [known, is_new] =
        known_.try_emplace(line.substr(5, 10), static_cast<std::uint32_t>(kinds.size()));
    if (is_new)
      kinds.push_back(
          {std::string(trimmed(line.substr(5, 5))), std::string(trimmed(line.substr(10, 5))), {}});
    if (kinds[known->second].name.empty())
      lines.refuse("there is no atom name in characters 11 to 15; sites are matched by it");
    return known->second;
  }

 private:
  std::unordered_map<std::string_view, std::uint32_t> known_;
};

// All of an atom but its kind.
AtomLine read_atom(std::string_view line, std::size_t width, const Lines& lines) {
  static constexpr std::array names = {"x coordinate", "y coordinate", "z coordinate",
                                       "x velocity",   "y velocity",   "z velocity"};
  AtomLine result;
  Atom& atom = result.atom;
  const std::string_view residue = trimmed(line.substr(0, 5));
  const auto end = residue.data() + residue.size();
  if (std::from_chars(residue.data(), end, atom.residue).ptr != end || residue.empty())
    lines.refuse(
        fmt::format("'{}' stands where the residue number must be, in the first five "
                    "characters",
                    residue));
  const std::size_t written = line.find_last_not_of(" \t") + 1;
  result.has_velocity = written > first_number + 3 * width;
  const std::size_t needed = first_number + (result.has_velocity ? 6 : 3) * width;
  if (written < needed)
    lines.refuse(fmt::format(
        "the line ends after {} characters; three {} of {} characters each "
        "after the names need {}",
        written, result.has_velocity ? "coordinates and three velocities" : "coordinates", width,
        needed));
  for (std::size_t k = 0; k < 3; ++k) atom.r[k] = number(column(line, k, width), names[k], lines);
  for (std::size_t k = 0; k < 3 && result.has_velocity; ++k)
    atom.v[k] = number(column(line, 3 + k, width), names[3 + k], lines);
  return result;
}

Box read_box(std::string_view line, const Lines& lines) {
  std::vector<double> edges;
  for (std::string_view rest = trimmed(line); !rest.empty();) {
    const auto end = rest.find_first_of(" \t");
    edges.push_back(number(rest.substr(0, end), "box edge", lines));
    rest = end == rest.npos ? std::string_view{} : trimmed(rest.substr(end));
  }
  if (edges.size() != 3 && edges.size() != 9)
    lines.refuse(fmt::format("'{}' stands where the box must be; it must be three edges in nm",
                             trimmed(line)));
  for (std::size_t k = 3; k < edges.size(); ++k)
    if (edges[k] != 0)
      lines.refuse(
          "the box is triclinic; it must be a cuboid, the only box that is known here; "
          "convert it, with gmx trjconv -ur rect or by a new box");
  for (std::size_t k = 0; k < 3; ++k)
    if (edges[k] <= 0)
      lines.refuse(fmt::format("a box edge is {} nm; it must be longer than 0 nm", edges[k]));
  return {{edges[0], edges[1], edges[2]}};
}

// GROMACS writes the time into the title: "... t= 20.000 step= 10000".
double title_time(std::string_view title) {
  const auto at = title.rfind("t=");
  if (at == title.npos) return 0;
  const std::string_view rest = trimmed(title.substr(at + 2));
  const auto time = parsed(rest.substr(0, rest.find_first_of(" \t")));
  return time && std::isfinite(*time) ? *time : 0;
}

// Writes a frame line by line.
class GroLines {
 public:
  GroLines(std::ostream& out, const std::vector<AtomKind>& kinds, int decimals, bool velocities)
      : text_(out), decimals_(decimals), velocities_(velocities) {
    for (const AtomKind& kind : kinds)
      names_.push_back(fmt::format("{:<5.5}{:>5.5}", kind.residue_name, kind.name));
  }

  void head(const std::string& title, std::size_t atoms) {
    text_.print("{}\n{:5}\n", title, atoms);
  }
  void atom(const Atom& atom) {
    number_ = (number_ + 1) % digits5;
    text_.print("{:5}", atom.residue % digits5);
    text_.append(names_[atom.kind]);
    text_.print("{:5}", number_);
    for (std::size_t k = 0; k < 3; ++k) text_.fixed(atom.r[k], width(), decimals_);
    for (std::size_t k = 0; k < 3 && velocities_; ++k)
      text_.fixed(atom.v[k], width(), decimals_ + 1);
    text_.end_line();
  }
  void box(const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) text_.fixed(box.edge[k], width(), decimals_);
    text_.end_line();
  }

 private:
  // Numbers of residues and atoms have five digits and start again at 0.
  static constexpr int digits5 = 100000;
  std::size_t width() const { return static_cast<std::size_t>(decimals_) + 5; }

  TextBuffer text_;
  std::vector<std::string> names_;  // of each kind
  int decimals_, number_ = 0;
  bool velocities_;
};

}  // namespace

Frame parse_gro(std::string_view text, const std::string& file) {
  Lines lines(text, file);
  Frame frame;
  frame.source = file;
  frame.title = trimmed(lines.next([] { return "the title"; }));
  frame.time = title_time(frame.title);
  const std::string_view count_line = trimmed(lines.next([] { return "the number of atoms"; }));
  std::size_t count = 0;
  const auto end = count_line.data() + count_line.size();
  const auto [last, status] = std::from_chars(count_line.data(), end, count);
  if (count_line.empty() || status != std::errc() || last != end)
    lines.refuse(fmt::format("'{}' stands where the number of atoms must be, in the second line",
                             count_line));
  std::size_t width = 0;
  Kinds kinds;
  frame.atoms.reserve(std::min(count, text.size() / first_number));
  for (std::size_t i = 0; i < count; ++i) {
    const auto here = [&] {
      return fmt::format("atom {} of the {} that the second line tells", i + 1, count);
    };
    const std::string_view line = lines.next(here);
    if (line.size() < first_number || line.find('.') < first_number)
      lines.refuse(fmt::format("'{}' stands where {} must be", trimmed(line), here()));
    if (i == 0) width = column_width(line, lines);
    auto [atom, has_velocity] = read_atom(line, width, lines);
    atom.kind = kinds.of(line, frame.kinds, lines);
    if (i == 0) frame.has_velocities = has_velocity;
    if (has_velocity != frame.has_velocities)
      lines.refuse(
          fmt::format("this atom has {} velocity and the ones before have {}; velocities "
                      "must be given for all atoms or for none",
                      has_velocity ? "a" : "no", has_velocity ? "none" : "one"));
    frame.atoms.push_back(atom);
  }
  const std::string_view box = lines.next([] { return "the box"; });
  const auto point = box.find('.');
  if (point != box.npos && point >= first_number)
    lines.refuse(
        fmt::format("a further atom stands where the box must be; the second line tells "
                    "{} atoms",
                    count));
  frame.box = read_box(box, lines);
  return frame;
}

Frame read_gro(const std::string& path) { return parse_gro(file_text(path), path); }

Frame read_start(const std::string& name_or_path) {
  const std::string path = "start/" + name_or_path + ".gro";
  if (const auto text = embedded_text(path)) return parse_gro(*text, path);
  if (is_data_file(name_or_path)) return frame_of(read_lammps_data(name_or_path));
  return read_gro(name_or_path);
}

void write_gro(std::ostream& out, const Frame& frame, int decimals) {
  GroLines lines(out, frame.kinds, decimals, frame.has_velocities);
  lines.head(frame.title, frame.atoms.size());
  for (const Atom& atom : frame.atoms) lines.atom(atom);
  lines.box(frame.box);
}

void write_gro(std::ostream& out, const State& state, const Topology& topology, int decimals) {
  GroLines lines(out, atom_kinds(topology, MasslessSites::kept), decimals, true);
  lines.head(title_of(state), atom_count(topology));
  each_atom(state, topology, MasslessSites::kept, [&](const Atom& atom) { lines.atom(atom); });
  lines.box(state.box);
}

}  // namespace polhode
