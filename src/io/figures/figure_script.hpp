// SPDX-License-Identifier: MIT
// gnuplot scripts: definitions of the values that a template from data/plots uses, the common
// style, and the template, which plots the data.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/figures/plot.hpp"

namespace polhode {

/// An image to be drawn.
struct Image {
  std::string name;    ///< name of the image file
  std::string format;  ///< format: "svg" or "png"
};

std::string script_of(const EnergyFigure& figure, const Image& image);
std::string script_of(const CurvesFigure& figure, const Image& image);
std::string script_of(const EfficiencyFigure& figure, const Image& image);
std::string script_of(const AdviceFigure& figure, const Image& image);
std::string script_of(const CanonicalFigure& figure, const Image& image);
std::string script_of(const PolhodeFigure& figure, const Image& image);

/// Quotes a text with single quotes, in which gnuplot replaces neither `commands` nor backslashes.
/// Unprintable characters are escaped before quoting, so that the text stays on one line.
std::string gnuplot_text(std::string_view text);

/// Quotes the name of a file next to the script. The result begins with "./", because gnuplot
/// interprets "<command" and "|command" as pipes and "~" as a home folder.
std::string gnuplot_file(std::string_view path);

/// Writes a text as a comment on one line.
std::string gnuplot_comment(std::string_view text);

/// The style in which a scheme is drawn.
struct SchemeStyle {
  std::string colour;        ///< colour as "#RRGGBB"
  int filled = 7, open = 6;  ///< point types of gnuplot
};

/// The styles of the schemes of a figure, from data/plots/schemes.toml. Schemes that are not in
/// schemes.toml, such as schemes written as text, get the unused styles in order.
std::vector<SchemeStyle> scheme_styles(const std::vector<std::string>& schemes);

/// Builds a gnuplot script. Texts are quoted so that nothing in them is evaluated. Templates
/// contain no text from users.
class FigureScript {
 public:
  /// @param width, height  size in pixels; bitmaps have twice as many
  FigureScript(const Image& image, std::size_t width, std::size_t height);

  /// Defines a number with a decimal point, because gnuplot truncates the quotient of two integers.
  FigureScript& number(std::string_view name, double value);
  FigureScript& count(std::string_view name, std::size_t value);
  FigureScript& text(std::string_view name, std::string_view value);
  /// Defines the name of a file in the folder of the script.
  FigureScript& file(std::string_view name, std::string_view path);
  /// Defines gnuplot arrays, which are indexed from 1. An empty array is written with one element:
  /// 0 or an empty text.
  FigureScript& counts(std::string_view name, std::span<const std::size_t> values);
  FigureScript& numbers(std::string_view name, std::span<const double> values);
  FigureScript& texts(std::string_view name, std::span<const std::string> values);
  /// Defines the number of schemes and their names, colours, markers, and first and last rows:
  /// `curves`, `name`, `colour`, `filled`, `open`, `first`, `last`.
  FigureScript& schemes(const std::vector<SchemeRows>& schemes);

  /// The gnuplot script, including the common style and the template data/plots/NAME.gp.
  std::string with(std::string_view name) const;

 private:
  /// Defines an array.
  /// @param none  element of an empty array, because gnuplot evaluates an element even in a loop
  ///   without iterations
  FigureScript& array(std::string_view name, auto values, std::string_view none,
                      const auto& text_of);

  std::string text_;
};

}  // namespace polhode
