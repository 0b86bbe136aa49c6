// SPDX-License-Identifier: MIT
#include "figure_script.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/printable.hpp"
#include "io/files/embedded.hpp"

namespace polhode {
namespace {

std::string_view template_text(std::string_view name) {
  return *embedded_text(fmt::format("plots/{}.gp", name));
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for (const char c : printable(text)) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string gnuplot_file(std::string_view path) {
  return gnuplot_text("./" + std::filesystem::path(path).filename().string());
}

// A backslash at the end of a line would join the line with the next line.
std::string gnuplot_comment(std::string_view text) {
  std::string line = printable(text);
  while (line.ends_with('\\')) line.pop_back();
  return line;
}

FigureScript::FigureScript(const Image& image, std::size_t width, std::size_t height)
    : text_(fmt::format(
          "# To change the figure, edit this script and run gnuplot on it: it draws {}.\n",
          gnuplot_comment(image.name))) {
  file("image", image.name).text("format", image.format);
  count("width", width).count("height", height);
}

FigureScript& FigureScript::number(std::string_view name, double value) {
  text_ += fmt::format("{} = {:#.10g}\n", name, value);
  return *this;
}

FigureScript& FigureScript::count(std::string_view name, std::size_t value) {
  text_ += fmt::format("{} = {}\n", name, value);
  return *this;
}

FigureScript& FigureScript::text(std::string_view name, std::string_view value) {
  text_ += fmt::format("{} = {}\n", name, gnuplot_text(value));
  return *this;
}

FigureScript& FigureScript::file(std::string_view name, std::string_view path) {
  text_ += fmt::format("{} = {}\n", name, gnuplot_file(path));
  return *this;
}

FigureScript& FigureScript::counts(std::string_view name, std::span<const std::size_t> values) {
  return array(name, values, "0", [](std::size_t value) { return fmt::format("{}", value); });
}

FigureScript& FigureScript::numbers(std::string_view name, std::span<const double> values) {
  return array(name, values, "0", [](double value) { return fmt::format("{:#.10g}", value); });
}

FigureScript& FigureScript::texts(std::string_view name, std::span<const std::string> values) {
  return array(name, values, "''", gnuplot_text);
}

FigureScript& FigureScript::array(std::string_view name, auto values, std::string_view none,
                                  const auto& text_of) {
  text_ += fmt::format("array {}[{}]\n", name, std::max<std::size_t>(1, values.size()));
  for (std::size_t k = 0; k < values.size(); ++k)
    text_ += fmt::format("{}[{}] = {}\n", name, k + 1, text_of(values[k]));
  if (values.empty()) text_ += fmt::format("{}[1] = {}\n", name, none);
  return *this;
}

FigureScript& FigureScript::schemes(const std::vector<SchemeRows>& schemes) {
  std::vector<std::string> names, colours;
  std::vector<std::size_t> filled, open, first, last;
  for (const SchemeRows& rows : schemes) {
    names.push_back(rows.scheme);
    first.push_back(rows.first), last.push_back(rows.last);
  }
  if (names.empty()) names.emplace_back();  // gnuplot needs a colour even if it loops over none
  for (const SchemeStyle& style : scheme_styles(names)) {
    colours.push_back(style.colour);
    filled.push_back(static_cast<std::size_t>(style.filled));
    open.push_back(static_cast<std::size_t>(style.open));
  }
  count("curves", schemes.size()).texts("name", names).texts("colour", colours);
  counts("filled", filled).counts("open", open);
  return counts("first", first).counts("last", last);
}

std::string FigureScript::with(std::string_view name) const {
  return fmt::format("{}\n{}\n{}", text_, template_text("style"), template_text(name));
}

}  // namespace polhode
