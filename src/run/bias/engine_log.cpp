// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "io/files/split_words.hpp"
#include "io/files/text_file.hpp"
#include "io/formats/lines.hpp"
#include "polhode/base/error.hpp"
#include "run/bias/log_bias.hpp"

namespace polhode {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (auto word = take_word(line); !word.empty(); word = take_word(line)) words.emplace_back(word);
  return words;
}

/// The fields of a line between separators, stripped of blanks and quotation marks.
std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  for (std::string& field : fields) field = trimmed(std::string(field));
  return fields;
}

/// A title without a # before it and without quotation marks around it.
std::string bare(std::string_view title) {
  title.remove_prefix(std::min(title.find_first_not_of("# "), title.size()));
  if (title.size() > 1 && title.front() == '"' && title.back() == '"')
    title = title.substr(1, title.size() - 2);
  return std::string(title);
}

/// The text between the first pair of quotation marks.
std::string quoted_part(std::string_view line) {
  const auto begin = line.find('"'), end = line.rfind('"');
  return begin < end ? std::string(line.substr(begin + 1, end - begin - 1)) : "";
}

bool all_numbers(const std::vector<std::string>& fields) {
  return std::ranges::all_of(fields, [](const auto& field) { return !!parsed<double>(field); });
}

bool no_numbers(const std::vector<std::string>& fields) {
  return std::ranges::none_of(fields, [](const auto& field) { return !!parsed<double>(field); });
}

/// Appends a row to the columns.
void add_row(EngineLog& log, const Lines& lines, const std::vector<std::string>& fields) {
  if (fields.size() != log.columns.size())
    lines.refuse(
        fmt::format("the row has {} fields; it must have {}, one for each column; if the log is "
                    "still being written, copy it and delete the incomplete last row",
                    fields.size(), log.columns.size()));
  for (std::size_t k = 0; k < fields.size(); ++k)
    log.columns[k].values.push_back(
        fields[k].empty() ? std::nan("") : lines.number(fields[k], log.columns[k].name.c_str()));
}

/// The unit of a column of `gmx energy`, which lists each unit once for all columns.
std::string gromacs_unit(const std::string& name, const std::string& units) {
  if (units.find(')') == units.rfind(')')) return titled_column(units).unit;
  const std::string known = lower(name);
  if (known.starts_with("temperature") || known.starts_with("t-")) return "K";
  if (known.starts_with("pres")) return "bar";
  if (known.starts_with("box-")) return "nm";
  if (known == "volume") return "nm^3";
  if (known == "density") return "kg/m^3";
  return units.find("(kJ/mol)") == units.npos ? "" : "kJ/mol";
}

EngineLog read_xvg(Lines& lines) {
  EngineLog log{lines.file(), "xvg file", {{"Time", "ps", {}}}, 1, {}};
  std::string units;
  while (const auto line = lines.next()) {
    const auto words = words_of(*line);
    if (words.empty() || words[0].starts_with('#') || words[0] == "&") continue;
    if (words[0] == "@") {
      const bool legend = words.size() > 3 && words[1].starts_with('s') && words[2] == "legend";
      if (legend) log.columns.push_back({quoted_part(*line), "", {}});
      if (words.size() > 2 && words[1] == "yaxis") units = quoted_part(*line);
      continue;
    }
    if (words[0].starts_with('@')) continue;
    add_row(log, lines, words);
  }
  for (std::size_t k = 1; k < log.columns.size(); ++k)
    log.columns[k].unit = gromacs_unit(log.columns[k].name, units);
  return log;
}

EngineLog read_csv(Lines& lines) {
  EngineLog log{lines.file(), "CSV file", {}, 1, {}};
  char separator = ',';
  bool marked_head = false;  // whether the head begins with '#', as in files of OpenMM
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const bool marked = line->starts_with('#');
    const bool is_comment = marked && line->find_first_of(",;\t") == line->npos;
    if (marked_head && !marked && log.samples() == 0 && no_numbers(fields_of(*line, separator)))
      log.columns.clear();  // the marked line was a comment, and this line is the head
    if (log.columns.empty() && !is_comment) {
      marked_head = marked;
      const auto start = line->find_first_not_of("# ");
      const std::string_view head = line->substr(std::min(start, line->size()));
      separator = *std::ranges::max_element(std::string_view(",;\t"), {},
                                            [&](char c) { return std::ranges::count(head, c); });
      for (const std::string& title : fields_of(head, separator))
        log.columns.push_back(titled_column(title));
    } else if (!marked) {
      add_row(log, lines, fields_of(*line, separator));
    }
  }
  return log;
}

/// The unit of a column for a unit system of LAMMPS; empty if the unit is not known.
std::string lammps_unit(const std::string& name, const std::string& system) {
  const bool is_real = system == "real", is_metal = system == "metal";
  if (name.ends_with("Eng") || name.starts_with("E_") || name == "Econserve") {
    if (is_real) return "kcal/mol";
    if (is_metal) return "eV";
    return system == "lj" ? "lj" : "";
  }
  if (name == "Temp" && (is_real || is_metal)) return "K";
  if (name != "Press" || !(is_real || is_metal)) return "";
  return is_real ? "atm" : "bar";
}

/// The information in a LAMMPS log besides the thermo output.
struct LammpsState {
  std::string system;            ///< unit system
  std::optional<bool> per_atom;  ///< whether energies are per atom, as set by thermo_modify norm
  double atoms = 1;

  void read(const std::vector<std::string>& words) {
    if (words[0] == "units" && words.size() == 2) system = words[1];
    for (std::size_t k = 1; k + 1 < words.size(); ++k) {
      if (words[0] == "thermo_modify" && words[k] == "norm") per_atom = words[k + 1] == "yes";
      if (words[0] == "Loop" && words[k + 1] == "atoms")
        atoms = parsed<double>(words[k]).value_or(1);
    }
  }
};

EngineLog read_lammps(Lines& lines) {
  EngineLog log{lines.file(), "LAMMPS log", {}, 1, {}};
  LammpsState state;
  int runs = 0;
  bool within = false;
  while (const auto line = lines.next()) {
    const auto words = words_of(*line);
    if (words.empty()) continue;
    state.read(words);
    if (words[0] == "Loop") within = false;
    if (words[0] == "Step") {
      log.columns.clear();
      for (const std::string& name : words)
        log.columns.push_back({name, lammps_unit(name, state.system), {}});
      within = true;
      ++runs;
    } else if (within && all_numbers(words)) {
      add_row(log, lines, words);
    }
  }
  if (state.per_atom.value_or(state.system == "lj")) log.divisor = state.atoms;
  if (log.divisor > 1)
    log.notes.push_back(fmt::format(
        "the log contains energies divided by the number of atoms, {:.0f}", log.divisor));
  if (runs > 1) log.notes.push_back(fmt::format("the log has {} runs; the last one is used", runs));
  return log;
}

/// Removes columns with empty fields: such quantities were not sampled in every row.
void drop_incomplete(EngineLog& log) {
  std::vector<std::string> dropped;
  std::erase_if(log.columns, [&](const LogColumn& c) {
    const bool has_gap = std::ranges::any_of(c.values, [](double x) { return std::isnan(x); });
    if (has_gap) dropped.push_back(c.name);
    return has_gap;
  });
  if (!dropped.empty())
    log.notes.push_back(
        fmt::format("columns with empty fields are left out: {}", fmt::join(dropped, ", ")));
}

bool has_line_starting(const std::string& text, const std::string& start) {
  for (std::istringstream in(text); in;) {
    std::string line;
    std::getline(in, line);
    if (trimmed(line).starts_with(start)) return true;
  }
  return false;
}

}  // namespace

LogColumn titled_column(const std::string& text) {
  const std::string title = bare(text);
  const auto open = title.find_last_of("([");
  if (open == title.npos) return {title, "", {}};
  const auto close = title.find_first_of(")]", open);
  return {
      std::string(trimmed(title.substr(0, open))), title.substr(open + 1, close - open - 1), {}};
}

const LogColumn* EngineLog::titled(const std::string& title) const {
  if (const LogColumn* column = find({title})) return column;
  const LogColumn wanted = titled_column(title);
  for (const LogColumn& column : columns)
    if (!wanted.unit.empty() && lower(column.name) == lower(wanted.name) &&
        column.unit == wanted.unit)
      return &column;
  return nullptr;
}

const LogColumn* EngineLog::find(const std::vector<std::string>& names) const {
  for (const std::string& name : names)
    for (const LogColumn& column : columns)
      if (lower(column.name) == lower(name)) return &column;
  return nullptr;
}

EngineLog parse_engine_log(const std::string& text, const std::string& file) {
  std::istringstream in(text);
  Lines lines(in, file);
  EngineLog log;
  if (has_line_starting(text, "@ s0 legend") || has_line_starting(text, "@    xaxis"))
    log = read_xvg(lines);
  else if (has_line_starting(text, "Step "))
    log = read_lammps(lines);
  else if (has_line_starting(text, "LAMMPS (") || has_line_starting(text, "keywords: ["))
    throw Error(
        "the log of LAMMPS has no rows of energies; print them with the step first, as in "
        "'thermo_style custom step temp pe etotal'",
        file);
  else
    log = read_csv(lines);
  drop_incomplete(log);
  if (log.samples() == 0 || log.columns.size() < 2)
    throw Error(
        "there are no rows of energies; the file must be a log of LAMMPS with 'thermo_style "
        "custom', an .xvg file of 'gmx energy', or a CSV file with the column names in its first "
        "line",
        file);
  return log;
}

EngineLog log_of_columns(const std::string& name, const std::vector<std::string>& titles,
                         const std::vector<std::vector<double>>& columns) {
  EngineLog log{name, "columns", {}, 1, {}};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    log.columns.push_back(titled_column(titles.at(k)));
    if (columns[k].size() != columns[0].size())
      throw Error(
          fmt::format("'{}' has {} values, but '{}' has {}; all columns must be equally long",
                      titles[k], columns[k].size(), titles[0], columns[0].size()),
          name);
    if (!std::ranges::all_of(columns[k], [](double x) { return std::isfinite(x); }))
      throw Error(
          fmt::format("'{}' has a value that is not finite; leave out such rows", titles[k]), name);
    log.columns.back().values = columns[k];
  }
  if (log.samples() == 0 || log.columns.size() < 2)
    throw Error("there are no rows of energies; give at least the total energy and a quantity",
                name);
  return log;
}

EngineLog read_engine_log(const std::string& path) {
  if (lower(path).ends_with(".edr"))
    throw Error(
        "an .edr file is binary; write its energies as text by 'gmx energy -f FILE.edr -o "
        "energies.xvg', or read it in Python with pyedr",
        path);
  return parse_engine_log(file_text(path), path);
}

}  // namespace polhode
